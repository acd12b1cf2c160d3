#pragma once
// The objective rate of the updated form: stress and strain are rotated by Q = (I - W/2)^-1 (I + W/2), W the
// increment of the spin at the middle of the step (Hughes & Winget 1980), so that a rotation of the body adds
// no stress.

#include "model/numerics/tensor.hpp"

namespace femsph::sph {

/// Splits L, the velocity gradient times dt, into the strain increment D and the spin W.
template <class T, int dim>
FEMSPH_INLINE void split_motion(const Tensor<T, dim>& L, Symmetric<T, dim>& D, Tensor<T, dim>& W) {
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c) {
      W[r][c] = 0.5 * (L[r][c] - L[c][r]);
      D(r, c) = 0.5 * (L[r][c] + L[c][r]);
    }
}

template <class T, int dim>
FEMSPH_INLINE Tensor<T, dim> turn_of(const Tensor<T, dim>& W) {
  Tensor<T, dim> Q;
  if constexpr (dim == 2) {
    const T w = 0.5 * W[1][0], d = 1.0 / (1.0 + w * w);
    Q[0][0] = Q[1][1] = (1.0 - w * w) * d;
    Q[1][0] = 2.0 * w * d;
    Q[0][1] = -Q[1][0];
  } else {  // Cayley's formula with the axial vector a of W/2
    const T a[3] = {0.5 * W[2][1], 0.5 * W[0][2], 0.5 * W[1][0]};
    const T s = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], d = 1.0 / (1.0 + s);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Q[i][j] = 2.0 * a[i] * a[j] + W[i][j];
        if (i == j) Q[i][j] += 1.0 - s;
        Q[i][j] *= d;
      }
  }
  return Q;
}

/// Q s Q^T
template <class T, int dim>
FEMSPH_INLINE Symmetric<T, dim> turned(const Tensor<T, dim>& Q, const Symmetric<T, dim>& s) {
  Symmetric<T, dim> out;
  for (int i = 0; i < dim; ++i) {
    T row[dim];  // (Q s)_i
    for (int l = 0; l < dim; ++l) {
      row[l] = Q[i][0] * s(0, l);
      for (int k = 1; k < dim; ++k) row[l] += Q[i][k] * s(k, l);
    }
    for (int j = i; j < dim; ++j) {
      T sum = row[0] * Q[j][0];
      for (int l = 1; l < dim; ++l) sum += row[l] * Q[j][l];
      out(i, j) = sum;
    }
  }
  return out;
}

}  // namespace femsph::sph
