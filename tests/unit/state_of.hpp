#pragma once

#include <numeric>
#include <vector>

#include "model/motion/bodies/discretization.hpp"

namespace femsph::test {

/// Stress and strain of all material points under the displacement u.
template <class Vector>
MaterialState state_of(const Discretization& d, const Vector& u) {
  std::vector<std::size_t> all(d.material_points());
  std::iota(all.begin(), all.end(), std::size_t(0));
  MaterialState state;
  d.material_state(u.data(), all, state);
  return state;
}

}  // namespace femsph::test
