#pragma once

// Invariants of a stress: principal values and the von Mises stress.

#include <array>

namespace femsph {

/// The three principal values of a symmetric tensor xx yy zz xy yz zx, the largest first.
std::array<double, 3> principal_values(const std::array<double, 6>& t);

/// sqrt(3/2 s:s) with s the deviator of the stress xx yy zz xy yz zx.
double von_mises(const std::array<double, 6>& stress);

}  // namespace femsph
