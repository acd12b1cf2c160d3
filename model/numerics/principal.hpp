#pragma once

#include <array>

namespace femsph {

/// The principal values of a symmetric tensor xx yy zz xy yz zx, the largest first; the one across a plane
/// included.
std::array<double, 3> principal_values(const std::array<double, 6>& t);

}  // namespace femsph
