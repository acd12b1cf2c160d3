#pragma once
// The list of theory values: exact values and values of beam theory, computed from a scene. In SI, with the
// signs of the scene: a downward load gives a negative deflection. Histories are for a load that acts in full
// from the start, without damping.

#include <string>
#include <vector>

#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {

/// All, in the order of `femsph list`.
const std::vector<Theory>& theories();
/// Throws std::runtime_error with "did you mean".
const Theory& theory_named(const std::string& name);

}  // namespace femsph::compare
