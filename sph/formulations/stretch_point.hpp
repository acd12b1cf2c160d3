#pragma once
// A material point of the updated form whose law gives the stress of the total stretch (neo-Hookean). The
// deformation gradient is updated by
//   F(n+1) = (1 - L/2)^-1 (1 + L/2) F(n),   L the velocity gradient at the middle of the step times dt,
// which rotates exactly like the rule of Hughes & Winget (1980). The law gives the Biot stress T of F = R U.
// With J the ratio of volumes (in 2D of areas: the force then belongs to the undeformed thickness) the stress
// in the pair forces is P F^T / J = R T U R^T / J.

#include "model/material/spatial_state.hpp"

namespace femsph::sph {

template <int dim, class Law>
struct StretchPoint {
  static constexpr int n = symmetric_size<dim>;
  static constexpr bool plastic = false;
  enum Slot { gradient = 0, stress = dim * dim, size = dim * dim + n };  ///< H = F - 1; the pull

  FEMSPH_INLINE static Symmetric<Pack, dim> pull(const Pack* own) {
    Symmetric<Pack, dim> s;
    for (int k = 0; k < n; ++k) s[k] = own[stress + k];
    return s;
  }

  FEMSPH_INLINE static void advance(const Law& law, const Tensor<Pack, dim>& L, Pack& volume, Pack* own) {
    Tensor<Pack, dim> forth, back, sum, H, F, inverse;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        H[i][j] = own[gradient + i * dim + j];
        forth[i][j] = 0.5 * L[i][j];
        back[i][j] = -0.5 * L[i][j];
        if (i == j) forth[i][j] += 1.0, back[i][j] += 1.0;
      }
    const Pack growth = determinant(forth) / invert(back, inverse);
    for (int i = 0; i < dim; ++i)  // H(n+1) = (1 - L/2)^-1 (L + (1 + L/2) H): 0 stays 0
      for (int j = 0; j < dim; ++j) {
        sum[i][j] = L[i][j];
        for (int k = 0; k < dim; ++k) sum[i][j] += forth[i][k] * H[k][j];
      }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        H[i][j] = inverse[i][0] * sum[0][j];
        for (int k = 1; k < dim; ++k) H[i][j] += inverse[i][k] * sum[k][j];
        own[gradient + i * dim + j] = F[i][j] = H[i][j];
        if (i == j) F[i][j] += 1.0;
      }
    Symmetric<Pack, dim> e;
    const Tensor<Pack, dim> R = FiniteRotation::strain<Pack, dim>(H, e);
    const Symmetric<Pack, dim> T = law.stress(e);
    const Pack per_volume = 1.0 / determinant(F);
    Tensor<Pack, dim> P;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        P[i][j] = R[i][0] * T(0, j);
        for (int k = 1; k < dim; ++k) P[i][j] += R[i][k] * T(k, j);
      }
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) {
        Pack s = P[i][0] * F[j][0];
        for (int k = 1; k < dim; ++k) s += P[i][k] * F[j][k];
        own[stress + symmetric_index<dim>(i, j)] = s * per_volume;
      }
    volume *= growth;
  }

  FEMSPH_INLINE static Pack stored(const Law& law, const Pack& volume, const Pack* own) {
    Symmetric<Pack, dim> e;
    Tensor<Pack, dim> H, F;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        H[i][j] = F[i][j] = own[gradient + i * dim + j];
        if (i == j) F[i][j] += 1.0;
      }
    FiniteRotation::strain<Pack, dim>(H, e);
    return volume / determinant(F) *
           law.stored_energy(e, law.stress(e), static_cast<const Pack*>(nullptr));  // per undeformed volume
  }
  FEMSPH_INLINE static Pack lost(const Pack*) { return Pack{}; }
  /// det F
  FEMSPH_INLINE static Pack volume_ratio(const Pack* own) {
    Tensor<Pack, dim> F;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) F[i][j] = own[gradient + i * dim + j] + (i == j ? 1.0 : 0.0);
    return determinant(F);
  }

  static void show(const Law& law, const double* own, std::array<double, 6>& stress_out,
                   std::array<double, 6>& strain_out) {
    Tensor<double, dim> H;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) H[i][j] = own[gradient + i * dim + j];
    Symmetric<double, dim> e;
    FiniteRotation::strain<double, dim>(H, e);
    spatial_state<FiniteRotation>(law, H, law.stress(e), e, nullptr, stress_out, strain_out);
  }
  static double plastic_strain(const Law&, const double*) { return 0; }
};

}  // namespace femsph::sph
