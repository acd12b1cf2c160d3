#pragma once
// The Q1 cell as a uniform gradient plus hourglass modes (Flanagan and Belytschko, Int. J. Numer. Meth. Engng
// 17, 1981). Any nodal field is x(xi) = x_0 + sum_d x_d xi_d + sum_a x_a h_a(xi), with the hourglass shapes h
// = xi eta in 2D and h_1 = eta zeta, h_2 = zeta xi, h_3 = xi eta, h_4 = xi eta zeta in 3D. The volume average
// of its gradient is exactly
//   L = (2^dim / V) (sum_d x_d (x) c_d + sum_a x_a (x) g_a)
//   2D: c_d the cofactors of the centre, g = 0
//   3D: c_d = A_d+1 x A_d+2 + S_d+2 x S_d+1 / 3,  g_a = (A_a+2 x S_a+1 + S_a+2 x A_a+1) / 3,  g_4 = 0
//   (indices cyclic)
// where A_d and S_a are the coefficients x_d and x_a of the geometry: integrate det J d xi_d/dX over the
// reference cube term by term. gamma_a . u = u_a - L S_a is mode a without the part that belongs to the
// linear field: zero for every linear field.

#include "fem/mesh/gauss.hpp"

namespace femsph::fem {

template <int dim>
inline constexpr int hourglass_modes = dim == 2 ? 1 : 4;

/// Bit d is set if mode a varies along direction d.
template <int dim>
constexpr int mode_mask(int a) {
  if constexpr (dim == 2) return 3;
  return a == 3 ? 7 : 7 ^ (1 << a);
}

/// Sums and differences of corner values along each direction in turn (the fast Walsh-Hadamard transform), or
/// the transposed transform.
template <bool transposed, class T, int n>
FEMSPH_INLINE void hadamard(T (&y)[n]) {
#pragma GCC unroll 3
  for (int b = 1; b < n; b <<= 1)
#pragma GCC unroll 8
    for (int a = 0; a < n; ++a)
      if (!(a & b)) {
        const T first = y[a], second = y[a | b];
        if constexpr (transposed) {
          y[a] = first - second;
          y[a | b] = first + second;
        } else {
          y[a] = first + second;
          y[a | b] = second - first;
        }
      }
}

/// Coefficients of one nodal vector field: linear[d][component], mode[a][component].
template <class T, int dim>
struct Modes {
  Tensor<T, dim> linear;
  T mode[hourglass_modes<dim>][dim];

  Modes() = default;
  FEMSPH_INLINE explicit Modes(const T* x) {
    constexpr int n = corners<dim>;
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c) {
      T y[n];
      for (int a = 0; a < n; ++a) y[a] = x[a * dim + c];
      hadamard<false>(y);
      for (int d = 0; d < dim; ++d) linear[d][c] = y[1 << d] * (1.0 / n);
      for (int a = 0; a < hourglass_modes<dim>; ++a) mode[a][c] = y[mode_mask<dim>(a)] * (1.0 / n);
    }
  }

  /// The adjoint: forces on the coefficients become nodal forces.
  FEMSPH_INLINE void nodal(T* f) const {
    constexpr int n = corners<dim>;
#pragma GCC unroll 3
    for (int c = 0; c < dim; ++c) {
      T y[n];
      y[0] = T{};
      for (int d = 0; d < dim; ++d) y[1 << d] = linear[d][c] * (1.0 / n);
      for (int a = 0; a < hourglass_modes<dim>; ++a) y[mode_mask<dim>(a)] = mode[a][c] * (1.0 / n);
      hadamard<true>(y);
      for (int a = 0; a < n; ++a) f[a * dim + c] = y[a];
    }
  }
};

template <class T, int dim>
struct MeanCell {
  static constexpr int modes = hourglass_modes<dim>;
  static constexpr int curved = dim == 2 ? 0 : 3;  ///< modes whose g does not vanish

  Modes<T, dim> geometry;
  Tensor<T, dim> c;
  T g[3][dim];
  T volume;
  T scale;  ///< 2^dim / V

  FEMSPH_INLINE explicit MeanCell(const T* X) : geometry(X) {
    const Tensor<T, dim>& A = geometry.linear;
    volume = cofactors<T, dim>(A, c);
    if constexpr (dim == 3) {
      const auto& S = geometry.mode;
      for (int d = 0; d < 3; ++d) {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        T p[3], q[3];
        cross(S[f], S[e], p);
        for (int k = 0; k < 3; ++k) c[d][k] += p[k] * (1.0 / 3);
        cross(A[f], S[e], p);
        cross(S[f], A[e], q);
        for (int k = 0; k < 3; ++k) g[d][k] = (p[k] + q[k]) * (1.0 / 3);
      }
      volume = T{};
      for (int d = 0; d < 3; ++d)
        volume += A[d][0] * c[d][0] + S[d][0] * g[d][0];  // the mean gradient of X itself is 1
    }
    scale = 1.0 / volume;
    volume *= corners<dim>;
  }

  /// Mean gradient L[i][c] and modes q[a][i] = gamma_a . u_i of the displacement.
  FEMSPH_INLINE void strain(const T* u, Tensor<T, dim>& L, T (&q)[modes][dim]) const {
    const Modes<T, dim> m(u);
    for (int i = 0; i < dim; ++i)
      for (int k = 0; k < dim; ++k) {
        T l = m.linear[0][i] * c[0][k];
        for (int d = 1; d < dim; ++d) l += m.linear[d][i] * c[d][k];
        for (int a = 0; a < curved; ++a) l += m.mode[a][i] * g[a][k];
        L[i][k] = l * scale;
      }
    for (int a = 0; a < modes; ++a)
      for (int i = 0; i < dim; ++i) {
        T r = m.mode[a][i];
        for (int k = 0; k < dim; ++k) r -= geometry.mode[a][k] * L[i][k];
        q[a][i] = r;
      }
  }

  /// The adjoint of strain(): nodal forces of P, the stress times the volume that works on L, and of Q, which
  /// works on q.
  FEMSPH_INLINE void force(const Tensor<T, dim>& P, const T (&Q)[modes][dim], T* f) const {
    Modes<T, dim> m;
    for (int i = 0; i < dim; ++i) {
      T z[dim];
      for (int k = 0; k < dim; ++k) {
        z[k] = P[i][k];
        for (int a = 0; a < modes; ++a) z[k] -= Q[a][i] * geometry.mode[a][k];
        z[k] *= scale;
      }
      for (int d = 0; d < dim; ++d) {
        m.linear[d][i] = z[0] * c[d][0];
        for (int k = 1; k < dim; ++k) m.linear[d][i] += z[k] * c[d][k];
      }
      for (int a = 0; a < modes; ++a) {
        m.mode[a][i] = Q[a][i];
        if (a < curved)
          for (int k = 0; k < dim; ++k) m.mode[a][i] += z[k] * g[a][k];
      }
    }
    m.nodal(f);
  }

  /// Sum over corners and components of the squared mean gradient of the shape functions, 1/m^2.
  FEMSPH_INLINE T gradient_square() const {
    T s = T{};
    for (int d = 0; d < dim; ++d)
      for (int k = 0; k < dim; ++k) s += c[d][k] * c[d][k];
    for (int a = 0; a < curved; ++a)
      for (int k = 0; k < dim; ++k) s += g[a][k] * g[a][k];
    return s * scale * scale * (1.0 / corners<dim>);
  }
};

}  // namespace femsph::fem
