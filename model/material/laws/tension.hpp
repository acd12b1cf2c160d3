#pragma once
// Rankine's cut-off: no principal stress above the tensile strength. The stress keeps its principal axes n_i
// and each principal stress becomes min(sigma_i, strength): sigma -= sum_i max(sigma_i - strength, 0) n_i (x)
// n_i.
//   - Differences of principal stresses do not increase, and neither does q: the von Mises condition remains
//     satisfied.
//   - No energy is created: the inelastic strain C^-1 D, with D the stress that is cut off, dissipates the
//   work
//     sigma : C^-1 : D = tr D ((1 + nu) strength - nu tr sigma) / E >= tr D (1 - 2 nu) strength / E >= 0.
// In plane stress the stresses in the plane are cut, in plane strain also the stress normal to it.

#include "model/material/laws/point_stress.hpp"

namespace femsph::plastic {

template <class T>
FEMSPH_INLINE void cut_tension(double strength, PointStress<T, 2>& s) {
  const T mean = 0.5 * (s.in[0] + s.in[1]), half = 0.5 * (s.in[0] - s.in[1]), shear = s.in[2];
  const T radius = square_root(half * half + shear * shear);
  const T high = larger(mean + radius - strength, T{}), low = larger(mean - radius - strength, T{});
  // n (x) n of the two axes: 1/2 (I +- D / radius), D the deviator of the plane
  const T both = 0.5 * (high + low), turn = select(radius > 0.0, 0.5 * (high - low) / radius, T{});
  s.in[0] -= both + turn * half;
  s.in[1] -= both - turn * half;
  s.in[2] -= turn * shear;
  s.across -= larger(s.across - strength, T{});
}

/// Principal axes by Jacobi's cyclic rotations (Golub & Van Loan, Matrix Computations, 8.5), a fixed number
/// of sweeps for all lanes.
template <class T>
FEMSPH_INLINE void cut_tension(double strength, PointStress<T, 3>& s) {
  Tensor<T, 3> A, V{};
  T bound = broadcast<T>(-1e300);  // Gershgorin: no principal stress lies above
  for (int i = 0; i < 3; ++i) {
    V[i][i] = broadcast<T>(1.0);
    T row = s.in[i];
    for (int j = 0; j < 3; ++j) {
      A[i][j] = s.in(i, j);
      if (j != i) row += larger(A[i][j], -A[i][j]);
    }
    bound = larger(bound, row);
  }
  if (!any(bound > strength)) return;
  for (int sweep = 0; sweep < 6; ++sweep)
    for (int turn = 0; turn < 3; ++turn) {
      const int p = turn == 2 ? 1 : 0, r = turn == 0 ? 1 : 2;
      const T off = A[p][r], there = select(off != 0.0, off, broadcast<T>(1.0));
      const T theta = 0.5 * (A[r][r] - A[p][p]) / there, size = larger(theta, -theta);
      const T root = 1.0 / (size + square_root(theta * theta + 1.0));
      const T t = select(off != 0.0, select(theta < 0.0, -root, root), T{}),
              c = 1.0 / square_root(t * t + 1.0), d = t * c;
      for (int k = 0; k < 3; ++k) {
        const T akp = A[k][p], akr = A[k][r], vkp = V[k][p], vkr = V[k][r];
        A[k][p] = c * akp - d * akr, A[k][r] = d * akp + c * akr;
        V[k][p] = c * vkp - d * vkr, V[k][r] = d * vkp + c * vkr;
      }
      for (int k = 0; k < 3; ++k) {
        const T apk = A[p][k], ark = A[r][k];
        A[p][k] = c * apk - d * ark, A[r][k] = d * apk + c * ark;
      }
      A[p][r] = A[r][p] = T{};
    }
  for (int n = 0; n < 3; ++n) {
    const T over = larger(A[n][n] - strength, T{});
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) s.in(i, j) -= over * V[i][n] * V[j][n];
  }
}

}  // namespace femsph::plastic
