#pragma once
// For output: what the law knows in its own frame, as Cauchy stress and strain in the axes of space.

#include <array>
#include <type_traits>

#include "model/material/kinematics.hpp"

namespace femsph {

/// H: displacement gradient; stress, strain: in the law's frame; history: the law's own, null if it has none. Six components xx yy zz xy yz zx out, thickness direction included.
/// With FiniteRotation the Cauchy stress is P F^T / J (J includes the stretch across the plane in 2D) and the strain is turned to space, R (U - I) R^T.
template <class Kinematics, class LawType, int dim>
void spatial_state(const LawType& law, const Tensor<double, dim>& H, Symmetric<double, dim> stress, Symmetric<double, dim> strain,
                   [[maybe_unused]] const double* history, std::array<double, 6>& stress_out, std::array<double, 6>& strain_out) {
  double szz = 0, ezz = 0;
  if constexpr (dim == 2) {
    szz = law.thickness_stress(stress, history);
    ezz = law.thickness_strain(strain, stress, history);
  }
  if constexpr (std::is_same_v<Kinematics, FiniteRotation>) {
    Symmetric<double, dim> again;
    const Tensor<double, dim> R = FiniteRotation::strain<double, dim>(H, again);
    Tensor<double, dim> P, F = H;
    for (int i = 0; i < dim; ++i) F[i][i] += 1;
    FiniteRotation::piola<double, dim>(R, stress, P);
    double J = F[0][0] * F[1][1] - F[0][1] * F[1][0];
    if constexpr (dim == 3)
      J = F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) - F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
          F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
    J *= 1 + ezz;
    szz *= (1 + ezz) / J;
    const Symmetric<double, dim> local = strain;
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) {
        double s = 0, e = 0;
        for (int k = 0; k < dim; ++k) {
          s += 0.5 * (P[i][k] * F[j][k] + P[j][k] * F[i][k]);
          for (int l = 0; l < dim; ++l) e += R[i][k] * local(k, l) * R[j][l];
        }
        stress(i, j) = s / J;
        strain(i, j) = e;
      }
  }
  if constexpr (dim == 2) {
    stress_out = {stress[0], stress[1], szz, stress[2], 0, 0};
    strain_out = {strain[0], strain[1], ezz, strain[2], 0, 0};
  } else {
    for (std::size_t k = 0; k < 6; ++k) stress_out[k] = stress[int(k)], strain_out[k] = strain[int(k)];
  }
}

}  // namespace femsph
