#pragma once
// The polar decomposition F = R U of a deformation gradient.

#include "model/material/laws/stretch.hpp"
#include "model/numerics/simd.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

/// F = R U in three dimensions.
template <class T>
struct Polar {
  Tensor<T, 3> R;
  Symmetric<T, 3> strain, shrink;  ///< U - 1 and U^-1 - 1
};

/// F^T F - 1
template <class T>
FEMSPH_INLINE Symmetric<T, 3> green(const Tensor<T, 3>& F) {
  Symmetric<T, 3> G;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const T g = F[0][i] * F[0][j] + F[1][i] * F[1][j] + F[2][i] * F[2][j];
      G(i, j) = i == j ? g - 1.0 : g;
    }
  return G;
}

/// The decomposition by the power series of U^-1 = (1 + G)^-1/2, G = F^T F - 1, to the term G^n; the error is
/// below |G|^(n+1)/2. By the Cayley-Hamilton theorem, G^3 = I1 G^2 - I2 G + I3, every power is a combination
/// of 1, G and G^2, so that each term takes three multiplications.
template <int n, class T>
FEMSPH_INLINE void polar_series(const Tensor<T, 3>& F, const Symmetric<T, 3>& G, Polar<T>& p) {
  constexpr double c[11] = {
      0,
      -1.0 / 2,
      3.0 / 8,
      -5.0 / 16,
      35.0 / 128,
      -63.0 / 256,
      231.0 / 1024,
      -429.0 / 2048,
      6435.0 / 32768,
      -12155.0 / 65536,
      46189.0 / 262144};
  const T xy = G[0] * G[1] - G[3] * G[3], yz = G[1] * G[2] - G[4] * G[4], zx = G[2] * G[0] - G[5] * G[5];
  const T I1 = trace(G), I2 = xy + yz + zx,
          I3 = G[0] * yz + G[3] * (G[4] * G[5] - G[3] * G[2]) + G[5] * (G[3] * G[4] - G[1] * G[5]);
  T a = broadcast<T>(c[n - 2]), b = broadcast<T>(c[n - 1]), g = broadcast<T>(c[n]);  // a + b G + g G^2
#pragma GCC unroll 8
  for (int k = n - 3; k >= 0; --k) {
    const T above = b;
    b = a - g * I2;
    a = c[k] + g * I3;
    g = above + g * I1;
  }
  const T sa = a + g * I3, sb = 1.0 + a + b - g * I2, sg = b + g + g * I1;  // U - 1 = (1 + G) U^-1 - 1
  Symmetric<T, 3> G2;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) G2(i, j) = G(i, 0) * G(0, j) + G(i, 1) * G(1, j) + G(i, 2) * G(2, j);
  for (int k = 0; k < 6; ++k) {
    p.shrink[k] = b * G[k] + g * G2[k];
    p.strain[k] = sb * G[k] + sg * G2[k];
  }
  for (int k = 0; k < 3; ++k) p.shrink[k] += a, p.strain[k] += sa;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      p.R[i][j] = F[i][j] + (F[i][0] * p.shrink(0, j) + F[i][1] * p.shrink(1, j) + F[i][2] * p.shrink(2, j));
}

/// For large stretches, which are rare: Newton's iteration X <- (X + X^-T)/2 (Higham, SIAM J. Sci. Stat.
/// Comput. 7, 1986) until |G| < 1/2, then the series until its error is negligible.
template <class T>
[[gnu::noinline]] void polar_far(const Tensor<T, 3>& F, Polar<T>& p) {
  p.R = F;
  for (int turn = 0; turn < 20; ++turn) {
    const Symmetric<T, 3> G = green(p.R);
    const T size = contract(G, G);
    const Tensor<T, 3> X = p.R;
    if (any(size > 0.25)) {
      Tensor<T, 3> C;  // cofactors: X^-T = C / det X
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
          C[i][j] = X[i1][j1] * X[i2][j2] - X[i1][j2] * X[i2][j1];
        }
      const T r = 0.5 / (X[0][0] * C[0][0] + X[0][1] * C[0][1] + X[0][2] * C[0][2]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) p.R[i][j] = 0.5 * X[i][j] + C[i][j] * r;
      continue;
    }
    polar_series<10>(X, G, p);
    if (!any(size > 1.5e-3)) break;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const T u = p.R[0][i] * F[0][j] + p.R[1][i] * F[1][j] + p.R[2][i] * F[2][j];
      p.strain(i, j) = i == j ? u - 1.0 : u;
    }
  p.shrink = inverse_stretch(p.strain);
  for (int k = 0; k < 3; ++k) p.shrink[k] -= 1.0;
}

/// The decomposition with an error below 1e-16 in every lane: the series to G^4 for strains up to 0.04 %, to
/// G^10 up to 1.9 %, else polar_far().
template <class T>
FEMSPH_INLINE void polar(const Tensor<T, 3>& F, Polar<T>& p) {
  const Symmetric<T, 3> G = green(F);
  const T size = contract(G, G);  // |G|^2
  if (any(size > 1.5e-3)) {
    const Tensor<T, 3> from = F;  // copies, so that the kernel can keep its own variables in registers
    Polar<T> far;
    polar_far(from, far);
    p = far;
  } else if (any(size > 6.5e-7)) {
    polar_series<10>(F, G, p);
  } else {
    polar_series<4>(F, G, p);
  }
}

/// The rotation R of F = R U; in 2D in closed form.
template <class T, int dim>
FEMSPH_INLINE Tensor<T, dim> polar_rotation(const Tensor<T, dim>& F) {
  if constexpr (dim == 2) {
    Tensor<T, dim> R;
    const T c = F[0][0] + F[1][1], s = F[1][0] - F[0][1];
    const T r = 1.0 / square_root(c * c + s * s);
    R[0][0] = R[1][1] = c * r;
    R[1][0] = s * r;
    R[0][1] = -s * r;
    return R;
  } else {
    Polar<T> p;
    polar(F, p);
    return p.R;
  }
}

}  // namespace femsph
