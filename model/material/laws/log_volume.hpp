#pragma once

#include "model/material/laws/stretch.hpp"

namespace femsph {

/// The change of ln J in a step whose increment d is that of the midpoint rule (kinematics.hpp): the sum of 2
/// atanh(d_k/2) over the principal values, which is exact where the axes stay, without its terms of fifth
/// order. tr d alone lets J drift in a shock that few steps resolve.
template <class T, int dim>
FEMSPH_INLINE T log_volume_change(const Symmetric<T, dim>& d) {
  return trace(d) + (1.0 / 12) * contract(symmetric_product(d, d), d);
}

}  // namespace femsph
