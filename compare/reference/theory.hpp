#pragma once
// Exact and beam-theory values by name, evaluated from a scene. All in SI, with the signs of the scene: a
// downward load gives a negative deflection. Histories are those of a load that acts in full from the start,
// without damping.

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

/// All of them, bars first.
const std::vector<Theory>& theories();
std::vector<std::string> theory_names();
/// Throws std::runtime_error with "did you mean".
const Theory& theory_named(const std::string& name);

}  // namespace femsph::compare
