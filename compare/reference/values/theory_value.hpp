#pragma once
// A theory value: an exact or beam-theory number by its name, evaluated from a scene. One file a solution,
// which lists the values that follow from it; the list of files is in ../theory.cpp.

#include <functional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace femsph::compare {

struct Theory {
  enum class Depends { on_nothing, on_place, on_time, on_place_and_time };
  std::string name, unit, formula;
  Depends depends;
  /// At a point of the undeformed body and at a time; either is ignored where the value does not depend on
  /// it. Throws std::runtime_error with one sentence if the scene is not of its kind.
  std::function<double(const Scene&, const Point&, double time)> value;

  bool on_time() const { return depends == Depends::on_time || depends == Depends::on_place_and_time; }
};

// The values of each solution.
std::vector<Theory> bar_values();
std::vector<Theory> return_path_values();
std::vector<Theory> impact_values();
std::vector<Theory> plastic_moment_values();
std::vector<Theory> cantilever_values();

}  // namespace femsph::compare
