#pragma once

// Invariants of a stress: principal values and von Mises' stress.

#include <array>

namespace femsph {

/// The principal values of a symmetric tensor xx yy zz xy yz zx, the largest first; the one across a plane
/// included.
std::array<double, 3> principal_values(const std::array<double, 6>& t);

/// sqrt(3/2 s:s) with s the deviator of the stress xx yy zz xy yz zx.
double von_mises(const std::array<double, 6>& stress);

}  // namespace femsph
