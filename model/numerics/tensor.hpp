#pragma once
// Small tensors of a scalar type T (double or Pack).
//   Tensor<T, dim>     dim x dim, row first: H[i][j] = du_i/dX_j
//   Symmetric<T, dim>  tensor components (not engineering shear), in the order xx yy xy (2D), xx yy zz xy yz
//   zx (3D)

#include <array>

#include "model/numerics/simd.hpp"

namespace femsph {

using Point = std::array<double, 3>;  ///< metres; the third component is 0 in 2D

template <int dim>
inline constexpr int symmetric_size = dim*(dim + 1) / 2;

template <class T, int dim>
struct Tensor {
  T a[dim][dim];
  FEMSPH_INLINE T* operator[](int i) { return a[i]; }
  FEMSPH_INLINE const T* operator[](int i) const { return a[i]; }
};

/// Where component (i, j) sits in a Symmetric.
template <int dim>
constexpr int symmetric_index(int i, int j) {
  if (i == j) return i;
  if constexpr (dim == 2) return 2;
  return i + j == 1 ? 3 : (i + j == 3 ? 4 : 5);
}

template <class T, int dim>
struct Symmetric {
  T a[symmetric_size<dim>];
  FEMSPH_INLINE T& operator[](int k) { return a[k]; }
  FEMSPH_INLINE const T& operator[](int k) const { return a[k]; }
  FEMSPH_INLINE T& operator()(int i, int j) { return a[symmetric_index<dim>(i, j)]; }
  FEMSPH_INLINE const T& operator()(int i, int j) const { return a[symmetric_index<dim>(i, j)]; }
};

template <class T, int dim>
FEMSPH_INLINE T trace(const Symmetric<T, dim>& s) {
  T t = s[0];
  for (int i = 1; i < dim; ++i) t += s[i];
  return t;
}

/// a : b, in 2D over the components of the plane.
template <class T, int dim>
FEMSPH_INLINE T contract(const Symmetric<T, dim>& a, const Symmetric<T, dim>& b) {
  T diagonal = a[0] * b[0], shear = a[dim] * b[dim];
  for (int i = 1; i < dim; ++i) diagonal += a[i] * b[i];
  for (int i = dim + 1; i < symmetric_size<dim>; ++i) shear += a[i] * b[i];
  return diagonal + 2.0 * shear;
}

template <class T, int dim>
FEMSPH_INLINE T determinant(const Tensor<T, dim>& M) {
  if constexpr (dim == 2)
    return M[0][0] * M[1][1] - M[0][1] * M[1][0];
  else
    return M[0][0] * (M[1][1] * M[2][2] - M[1][2] * M[2][1]) +
           M[0][1] * (M[1][2] * M[2][0] - M[1][0] * M[2][2]) +
           M[0][2] * (M[1][0] * M[2][1] - M[1][1] * M[2][0]);
}

/// The inverse; returns the determinant.
template <class T, int dim>
FEMSPH_INLINE T invert(const Tensor<T, dim>& M, Tensor<T, dim>& inverse) {
  const T det = determinant(M), r = 1.0 / det;
  if constexpr (dim == 2) {
    inverse[0][0] = M[1][1] * r, inverse[1][1] = M[0][0] * r;
    inverse[0][1] = -M[0][1] * r, inverse[1][0] = -M[1][0] * r;
  } else {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        inverse[j][i] = (M[i1][j1] * M[i2][j2] - M[i1][j2] * M[i2][j1]) * r;
      }
  }
  return det;
}

/// The inverse of a matrix is cofactor^T / det.
struct Cofactors {
  Tensor<double, 3> cofactor;
  double det;
};
inline Cofactors cofactors(const Tensor<double, 3>& M) {
  Cofactors r;
  for (int a = 0; a < 3; ++a)
    for (int c = 0; c < 3; ++c) {
      const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      r.cofactor[a][c] = M[a1][c1] * M[a2][c2] - M[a1][c2] * M[a2][c1];
    }
  r.det = M[0][0] * r.cofactor[0][0] + M[0][1] * r.cofactor[0][1] + M[0][2] * r.cofactor[0][2];
  return r;
}

}  // namespace femsph
