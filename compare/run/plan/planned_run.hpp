#pragma once

#include <string>

#include "compare/run/plan/method.hpp"
#include "model/motion/march.hpp"

namespace femsph::compare {

/// One run to make.
struct PlannedRun {
  std::string case_name, label;  ///< label: the method's name in tables
  Method method;                 ///< with the study's overrides
  Resolution resolution;
  std::string scene;  ///< a key of Study::scenes
  MarchOptions march;
  bool quick = false;  ///< part of the quick form
  int ladder = 0;      ///< runs of one [[runs]] table share it
};

}  // namespace femsph::compare
