#pragma once

#include <algorithm>

#include "model/material/laws/law_input.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

/// Isotropic linear elasticity, sigma = lambda tr(eps) I + 2 mu eps. In plane stress lambda is replaced by 2
/// lambda mu / (lambda + 2 mu) = E nu / (1 - nu^2), so that the formula holds in all three cases.
struct LinearElastic {
  struct Parameters {};
  static constexpr const char* name = "elastic";
  static Entry entry() { return {"elastic", "isotropic linear elasticity (Hooke's law)"}; }
  static Parameters read(Fields&, const LawInput&) { return {}; }
  static LinearElastic of(const Parameters&, const ElasticConstants& m, Plane plane) {
    return make(m.young, m.poisson, m.density, plane);
  }
  static BarYield bar(const Parameters&) { return {}; }
  static std::vector<std::string> effects(const Parameters&) { return {}; }

  double lambda;   ///< first Lame parameter, in plane stress the effective one, Pa
  double mu;       ///< shear modulus, Pa
  double density;  ///< kg/m^3
  double poisson;  ///< Poisson's ratio of the material
  Plane plane;

  /// young > 0 (Pa), -1 < poisson < 0.5, density > 0 (kg/m^3); not checked here.
  static LinearElastic make(double young, double poisson, double density, Plane plane) {
    const double mu = young / (2 * (1 + poisson));
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    return {plane == Plane::stress ? young * poisson / (1 - poisson * poisson) : lambda, mu, density, poisson,
            plane};
  }

  template <int dim>
  static constexpr int history_size = 0;
  static constexpr bool path_independent = true;

  template <class T, int dim>
  FEMSPH_INLINE Symmetric<T, dim> stress(const Symmetric<T, dim>& strain) const {
    Symmetric<T, dim> s;
    const T pressure = lambda * trace(strain);
    for (int k = 0; k < symmetric_size<dim>; ++k) s[k] = 2.0 * mu * strain[k];
    for (int k = 0; k < dim; ++k) s[k] += pressure;
    return s;
  }

  template <class T, int dim>
  FEMSPH_INLINE void update(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress_now, T*) const {
    const Symmetric<T, dim> d = stress(increment);
    for (int k = 0; k < symmetric_size<dim>; ++k) stress_now[k] += d[k];
  }

  /// Stored energy per volume, J/m^3: 1/2 sigma : eps. (Normal to the plane either stress or strain is 0.)
  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>& strain, const Symmetric<T, dim>& stress_now,
                                const T*) const {
    return 0.5 * contract(stress_now, strain);
  }

  /// The elastic part of the law, for the critical step and the hourglass stiffness.
  const LinearElastic& elastic() const { return *this; }

  /// Speed of the fastest plane wave, m/s: sqrt((lambda + 2 mu)/rho); in plane stress this is sqrt(E / (rho
  /// (1 - nu^2))).
  double wave_speed() const { return std::sqrt((lambda + 2 * mu) / density); }

  /// Stress normal to the plane: 0 in plane stress, nu (sxx + syy) in plane strain.
  double thickness_stress(const Symmetric<double, 2>&, const Symmetric<double, 2>& s, const double*) const {
    return plane == Plane::strain ? poisson * (s[0] + s[1]) : 0.0;
  }
  /// Strain normal to the plane: 0 in plane strain, -nu/(1 - nu) (exx + eyy) in plane stress.
  double thickness_strain(const Symmetric<double, 2>& e, const Symmetric<double, 2>&, const double*) const {
    return plane == Plane::stress ? -poisson / (1 - poisson) * (e[0] + e[1]) : 0.0;
  }
};

/// The modulus for hourglass control, Pa: lambda + 2 mu, but at most its value for nu = 0.3, 3.5 mu.
/// Hourglass modes are modes of shear and bending: a control in proportion to lambda, which is unbounded as
/// nu -> 0.5, would lock a nearly incompressible body. A fluid (mu = 0) has no stiffness in these modes; 1 %
/// of its bulk modulus is enough to hold them.
inline double hourglass_modulus(const LinearElastic& elastic) {
  if (elastic.mu == 0) return 0.01 * elastic.lambda;
  return std::min(elastic.lambda + 2 * elastic.mu, 3.5 * elastic.mu);
}

}  // namespace femsph
