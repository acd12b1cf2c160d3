#pragma once
// One run of a study.

#include <string>

#include "compare/run/plan/body_methods.hpp"
#include "model/motion/march.hpp"

namespace femsph::compare {

struct PlannedRun {
  std::string case_name, label;  ///< label: the methods' name in tables
  BodyMethods methods;           ///< with the study's overrides
  Resolution resolution;
  std::string scene;  ///< a key of Study::scenes
  MarchOptions march;
  bool quick = false;  ///< part of the quick form
  int ladder = 0;      ///< number of the [[runs]] table: runs that differ in their spacing
};

}  // namespace femsph::compare
