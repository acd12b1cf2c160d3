#pragma once
// The Q1 cell at its 2^dim Gauss points, by sum factorization. Corners and points are numbered
// lexicographically: bit d of the number says at which end (or which point) along direction d. T is double or
// Pack. A derivative along direction d is constant along d, so it is stored once for each line of points:
// 2^(dim-1) values.

#include "model/numerics/tensor.hpp"

namespace femsph::fem {

inline constexpr double gauss_point = 0.57735026918962576451;  ///< 1/sqrt(3)

template <int dim>
inline constexpr int corners = 1 << dim;

/// Which of the lines along direction d holds point q.
template <int dim>
constexpr int line_of(int d, int q) {
  if constexpr (dim == 2) return (q >> (1 - d)) & 1;
  return ((q >> ((d + 1) % 3)) & 1) + 2 * ((q >> ((d + 2) % 3)) & 1);
}

/// Derivatives of one nodal component at the Gauss points: D[d][line] = d x / d xi_d.
template <class T, int dim>
using Derivatives = T[dim][corners<dim> / 2];

/// Turns the values at the ends of a segment into those at its two Gauss points. It is its own adjoint.
template <class T>
FEMSPH_INLINE void to_gauss(T& low, T& high) {
  const T mean = 0.5 * (low + high), slope = (0.5 * gauss_point) * (high - low);
  low = mean - slope;
  high = mean + slope;
}

/// x[corner * dim] is the nodal component.
template <class T, int dim>
FEMSPH_INLINE void differentiate(const T* x, Derivatives<T, dim>& D) {
#pragma GCC unroll 3
  for (int d = 0; d < dim; ++d) {
    const int s = 1 << d, t1 = 1 << ((d + 1) % dim), t2 = dim == 3 ? 1 << ((d + 2) % dim) : 0;
#pragma GCC unroll 4
    for (int k = 0; k < corners<dim> / 2; ++k) {
      const int a = (k & 1) * t1 + (k >> 1) * t2;
      D[d][k] = 0.5 * (x[(a + s) * dim] - x[a * dim]);
    }
    to_gauss(D[d][0], D[d][1]);
    if constexpr (dim == 3) {
      to_gauss(D[d][2], D[d][3]);
      to_gauss(D[d][0], D[d][2]);
      to_gauss(D[d][1], D[d][3]);
    }
  }
}

/// The adjoint: f[corner * dim] = sum over directions and lines of (d N / d xi_d) D[d][line]. Overwrites D.
template <class T, int dim>
FEMSPH_INLINE void integrate(Derivatives<T, dim>& D, T* f) {
#pragma GCC unroll 8
  for (int a = 0; a < corners<dim>; ++a) f[a * dim] = T{};
#pragma GCC unroll 3
  for (int d = 0; d < dim; ++d) {
    const int s = 1 << d, t1 = 1 << ((d + 1) % dim), t2 = dim == 3 ? 1 << ((d + 2) % dim) : 0;
    to_gauss(D[d][0], D[d][1]);
    if constexpr (dim == 3) {
      to_gauss(D[d][2], D[d][3]);
      to_gauss(D[d][0], D[d][2]);
      to_gauss(D[d][1], D[d][3]);
    }
#pragma GCC unroll 4
    for (int k = 0; k < corners<dim> / 2; ++k) {
      const int a = (k & 1) * t1 + (k >> 1) * t2;
      const T half = 0.5 * D[d][k];
      f[(a + s) * dim] += half;
      f[a * dim] -= half;
    }
  }
}

template <class T>
FEMSPH_INLINE void cross(const T* a, const T* b, T* c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/// C[d][c] = det J d xi_d / d X_c of J[d][c] = d X_c / d xi_d; returns det J.
template <class T, int dim>
FEMSPH_INLINE T cofactors(const Tensor<T, dim>& J, Tensor<T, dim>& C) {
  if constexpr (dim == 2) {
    C[0][0] = J[1][1];
    C[0][1] = -J[1][0];
    C[1][0] = -J[0][1];
    C[1][1] = J[0][0];
    return J[0][0] * J[1][1] - J[0][1] * J[1][0];
  } else {
    for (int d = 0; d < 3; ++d) cross(J[(d + 1) % 3], J[(d + 2) % 3], C[d]);
    return J[0][0] * C[0][0] + J[0][1] * C[0][1] + J[0][2] * C[0][2];
  }
}

/// G[d][c] = d x_c / d xi_d at the centre.
template <class T, int dim>
FEMSPH_INLINE Tensor<T, dim> centre_derivatives(const T* x) {
  Tensor<T, dim> G;
  for (int d = 0; d < dim; ++d)
    for (int c = 0; c < dim; ++c) {
      T sum{};
      for (int a = 0; a < corners<dim>; ++a) sum += (a >> d & 1 ? 1.0 : -1.0) * x[a * dim + c];
      G[d][c] = (1.0 / corners<dim>)*sum;
    }
  return G;
}

/// The derivatives of all components at the Gauss points of one cell.
template <class T, int dim>
struct GaussCell {
  Derivatives<T, dim> D[dim];  ///< per component

  FEMSPH_INLINE explicit GaussCell(const T* x) {
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c) differentiate<T, dim>(x + c, D[c]);
  }
  /// G[d][c] = d x_c / d xi_d at point q.
  FEMSPH_INLINE Tensor<T, dim> at(int q) const {
    Tensor<T, dim> G;
    for (int d = 0; d < dim; ++d)
      for (int c = 0; c < dim; ++c) G[d][c] = D[c][d][line_of<dim>(d, q)];
    return G;
  }
};

/// Sums det J P at the Gauss points and makes nodal forces of it, f_a = sum_q det J P grad N_a.
template <class T, int dim>
struct GaussForce {
  Derivatives<T, dim> D[dim]{};

  FEMSPH_INLINE void add(int q, const Tensor<T, dim>& P, const Tensor<T, dim>& C) {
    for (int i = 0; i < dim; ++i)
      for (int d = 0; d < dim; ++d) {
        T p = P[i][0] * C[d][0];
        for (int c = 1; c < dim; ++c) p += P[i][c] * C[d][c];
        D[i][d][line_of<dim>(d, q)] += p;
      }
  }
  FEMSPH_INLINE void nodal(T* f) {
#pragma GCC unroll 3
    for (int i = 0; i < dim; ++i) integrate<T, dim>(D[i], f + i);
  }
};

/// H[i][c] = d u_i / d X_c = sum_d G[d][i] C[d][c] r, with r = 1 / det J.
template <class T, int dim>
FEMSPH_INLINE Tensor<T, dim> displacement_gradient(const Tensor<T, dim>& G, const Tensor<T, dim>& C, T r) {
  Tensor<T, dim> H;
  for (int i = 0; i < dim; ++i)
    for (int c = 0; c < dim; ++c) {
      T h = G[0][i] * C[0][c];
      for (int d = 1; d < dim; ++d) h += G[d][i] * C[d][c];
      H[i][c] = h * r;
    }
  return H;
}

}  // namespace femsph::fem
