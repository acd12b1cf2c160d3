#pragma once
// The right stretch tensor U, given by the strain e = U - 1.

#include "model/numerics/tensor.hpp"

namespace femsph {

/// The relative change of volume (of area in 2D), det U - 1, without cancellation at small strain.
template <class T, int dim>
FEMSPH_INLINE T volume_change(const Symmetric<T, dim>& e) {
  if constexpr (dim == 2)
    return e[0] + e[1] + (e[0] * e[1] - e[2] * e[2]);
  else {
    const T xy = e[0] * e[1] - e[3] * e[3], yz = e[1] * e[2] - e[4] * e[4], zx = e[2] * e[0] - e[5] * e[5];
    const T det = e[0] * yz + e[3] * (e[4] * e[5] - e[3] * e[2]) + e[5] * (e[3] * e[4] - e[1] * e[5]);
    return trace(e) + (xy + yz + zx + det);
  }
}

/// U^-1
template <class T, int dim>
FEMSPH_INLINE Symmetric<T, dim> inverse_stretch(const Symmetric<T, dim>& e) {
  const T a = 1.0 + e[0], b = 1.0 + e[1];
  if constexpr (dim == 2) {
    const T r = 1.0 / (a * b - e[2] * e[2]);
    return {b * r, a * r, -e[2] * r};
  } else {
    const T c = 1.0 + e[2], xy = e[3], yz = e[4], zx = e[5];
    const T A = b * c - yz * yz, B = a * c - zx * zx, C = a * b - xy * xy;
    const T D = yz * zx - c * xy, E = xy * zx - a * yz, F = xy * yz - b * zx;
    const T r = 1.0 / (a * A + xy * D + zx * F);
    return {A * r, B * r, C * r, D * r, E * r, F * r};
  }
}

/// sym(a b)
template <class T, int dim>
FEMSPH_INLINE Symmetric<T, dim> symmetric_product(const Symmetric<T, dim>& a, const Symmetric<T, dim>& b) {
  Symmetric<T, dim> s;
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      T sum = a(i, 0) * b(0, j);
      for (int k = 1; k < dim; ++k) sum += a(i, k) * b(k, j);
      if (i != j) {
        for (int k = 0; k < dim; ++k) sum += a(j, k) * b(k, i);
        sum *= 0.5;
      }
      s(i, j) = sum;
    }
  return s;
}

}  // namespace femsph
