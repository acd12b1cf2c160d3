#pragma once
// The moment balance of a co-rotated strain measure. Let F = R U, and let the energy E depend on U and on
// vectors R^T q that are not part of F: dE = T : dU + sum S . d(R^T q). With Omega = R^T dR this is
//   dE = T : (R^T dF) - Omega : M + (terms in dq),   M = T U + sum S (x) R^T q,
// and Omega follows from
//   Omega U + U Omega = R^T dF - (R^T dF)^T,   axial vectors: (tr U 1 - U) omega = ax(R^T dF).
// So the stress that works on R^T dF is T + Z with a skew Z, which vanishes if M is symmetric (T coaxial with
// U, no q). Such a force is the exact adjoint of strains that vanish in a rigid rotation: its moment is zero
// for any law.

#include "model/numerics/tensor.hpp"

namespace femsph::fem {

/// Z from the axial vector of M: M[1][0] - M[0][1] in 2D; M[2][1] - M[1][2] and so on in 3D. A term S (x) R^T
/// q of M has the axial vector q x S.
template <class T>
FEMSPH_INLINE Tensor<T, 2> axial_couple(const Symmetric<T, 2>& U, const T& axial) {
  const T z = axial / trace(U);
  Tensor<T, 2> Z;
  Z[0][0] = Z[1][1] = T{};
  Z[1][0] = -z;
  Z[0][1] = z;
  return Z;
}

template <class T>
FEMSPH_INLINE Tensor<T, 3> axial_couple(const Symmetric<T, 3>& U, const T (&axial)[3]) {
  const T t = trace(U);
  const T a = t - U[0], b = t - U[1], c = t - U[2], d = -U(0, 1), e = -U(1, 2), f = -U(0, 2);
  const T A = b * c - e * e, B = a * c - f * f, C = a * b - d * d;
  const T D = e * f - c * d, E = d * f - a * e, F = d * e - b * f;
  const T r = 1.0 / (a * A + d * D + f * F);
  const T x = axial[0], y = axial[1], z = axial[2];
  const T zx = (A * x + D * y + F * z) * r, zy = (D * x + B * y + E * z) * r,
          zz = (F * x + E * y + C * z) * r;
  Tensor<T, 3> Z;
  Z[0][0] = Z[1][1] = Z[2][2] = T{};
  Z[2][1] = -zx;
  Z[1][2] = zx;
  Z[0][2] = -zy;
  Z[2][0] = zy;
  Z[1][0] = -zz;
  Z[0][1] = zz;
  return Z;
}

template <class T>
FEMSPH_INLINE Tensor<T, 2> rotation_couple(const Symmetric<T, 2>& U, const Tensor<T, 2>& M) {
  return axial_couple<T>(U, M[1][0] - M[0][1]);
}
template <class T>
FEMSPH_INLINE Tensor<T, 3> rotation_couple(const Symmetric<T, 3>& U, const Tensor<T, 3>& M) {
  const T axial[3] = {M[2][1] - M[1][2], M[0][2] - M[2][0], M[1][0] - M[0][1]};
  return axial_couple<T>(U, axial);
}

/// P = R (T + Z), with M as above, U = 1 + strain.
template <class T, int dim>
FEMSPH_INLINE void coupled_piola(const Tensor<T, dim>& R, const Symmetric<T, dim>& strain,
                                 const Symmetric<T, dim>& stress, Tensor<T, dim> M, Tensor<T, dim>& P) {
  Symmetric<T, dim> U = strain;
  for (int i = 0; i < dim; ++i) U[i] += 1.0;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      for (int k = 0; k < dim; ++k) M[i][j] += stress(i, k) * U(k, j);
  const Tensor<T, dim> Z = rotation_couple(U, M);
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      T p = R[i][0] * (stress(0, j) + Z[0][j]);
      for (int k = 1; k < dim; ++k) p += R[i][k] * (stress(k, j) + Z[k][j]);
      P[i][j] = p;
    }
}

}  // namespace femsph::fem
