#pragma once
// Exact and beam-theory values by name, evaluated from a scene. All in SI, with the signs of the scene: a
// downward load gives a negative deflection. Histories are those of a load that acts in full from the start,
// without damping.

#include <string>
#include <vector>

#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {

/// All of them, bars first.
const std::vector<Theory>& theories();
std::vector<std::string> theory_names();
/// Throws std::runtime_error with "did you mean".
const Theory& theory_named(const std::string& name);

}  // namespace femsph::compare
