#pragma once
// A theory value: an exact value, or one of beam theory, that is computed from a scene. Each file of this
// folder is one solution with the values that follow from it; ../theory.cpp lists the solutions.

#include <functional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace femsph::compare {

struct Theory {
  enum class Depends { on_nothing, on_place, on_time, on_place_and_time };
  std::string name, unit, formula;  ///< unit: SI
  Depends depends;
  /// SI, at a point of the undeformed body (m) and at a time (s), which are ignored where the value does not
  /// depend on them. Throws std::runtime_error with one sentence if the theory does not cover the scene.
  std::function<double(const Scene&, const Point&, double time)> value;

  bool on_time() const { return depends == Depends::on_time || depends == Depends::on_place_and_time; }
};

// The solutions.
std::vector<Theory> bar_values();
std::vector<Theory> return_path_values();
std::vector<Theory> impact_values();
std::vector<Theory> plastic_moment_values();
std::vector<Theory> cantilever_values();

}  // namespace femsph::compare
