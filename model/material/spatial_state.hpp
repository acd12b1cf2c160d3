#pragma once
// For output: Cauchy stress and strain in the axes of space, from those of the law in its co-rotated frame.

#include <array>
#include <cmath>
#include <type_traits>

#include "model/material/kinematics.hpp"

namespace femsph {

/// The co-rotated Cauchy stress R^T sigma R from the stress of the law. `normal_stress` and `normal_strain`:
/// on entry those of the law normal to the plane (2D), on return the Cauchy stress and stretch - 1. J
/// includes that stretch.
///   FiniteRotation   of the Biot stress T: sigma = P F^T / J = R (T U) R^T / J, symmetrised
///   LargeStrain      of the Kirchhoff stress tau: sigma = R tau R^T / J; the normal strain is logarithmic
template <class Kinematics, int dim>
Symmetric<double, dim> corotated_cauchy(const Symmetric<double, dim>& strain,
                                        const Symmetric<double, dim>& stress, double& normal_stress,
                                        double& normal_strain) {
  Symmetric<double, dim> s = stress;
  if constexpr (std::is_same_v<Kinematics, SmallStrain>) return s;
  constexpr bool kirchhoff = std::is_same_v<Kinematics, LargeStrain>;
  if constexpr (kirchhoff) {
    normal_strain = std::expm1(normal_strain);
  } else {
    Symmetric<double, dim> U = strain;
    for (int i = 0; i < dim; ++i) U[i] += 1.0;
    s = symmetric_product(stress, U);
  }
  const double J = (1 + volume_change(strain)) * (1 + normal_strain);
  normal_stress *= (kirchhoff ? 1.0 : 1 + normal_strain) / J;
  for (int k = 0; k < symmetric_size<dim>; ++k) s[k] /= J;
  return s;
}

/// H: displacement gradient; stress, strain and history: those of the law (history null if it has none).
/// Output: six components xx yy zz xy yz zx, with the direction normal to the plane; in large motion the
/// Cauchy stress and the strain R (U - I) R^T.
template <class Kinematics, class LawType, int dim>
void spatial_state(const LawType& law, const Tensor<double, dim>& H, Symmetric<double, dim> stress,
                   Symmetric<double, dim> strain, [[maybe_unused]] const double* history,
                   std::array<double, 6>& stress_out, std::array<double, 6>& strain_out) {
  double szz = 0, ezz = 0;
  if constexpr (dim == 2) {
    szz = law.thickness_stress(strain, stress, history);
    ezz = law.thickness_strain(strain, stress, history);
  }
  if constexpr (!std::is_same_v<Kinematics, SmallStrain>) {
    const Symmetric<double, dim> e = strain, s = corotated_cauchy<Kinematics>(strain, stress, szz, ezz);
    Symmetric<double, dim> again;
    const Tensor<double, dim> R = Kinematics::template strain<double, dim>(H, again);
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) {
        stress(i, j) = strain(i, j) = 0;
        for (int k = 0; k < dim; ++k)
          for (int l = 0; l < dim; ++l) {
            stress(i, j) += R[i][k] * s(k, l) * R[j][l];
            strain(i, j) += R[i][k] * e(k, l) * R[j][l];
          }
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
