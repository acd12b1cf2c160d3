#pragma once
// Compressible neo-Hookean solid (Bonet & Wood, Nonlinear Continuum Mechanics for Finite Element Analysis,
// 2nd ed., eq. 6.27):
//   psi = mu/2 (F:F - 3) - mu ln J + lambda/2 (ln J)^2     per undeformed volume.
// With F = R U the stress conjugate to U is T = d psi / dU = mu (U - U^-1) + lambda ln J U^-1, and P = R T.
// For small strain it is linear elasticity with the same lambda and mu. psi is infinite for J -> 0; J <= 0
// gives NaN.
//   plane strain   U_zz = 1
//   plane stress   U_zz = t with mu (t - 1/t) + lambda ln(J_2 t)/t = 0, J_2 the change of area in the plane:
//                  w = 2 ln t solves mu (e^w - 1) + lambda w/2 + lambda ln J_2 = 0. This is convex and
//                  increasing, so that Newton's method converges monotonically from w = -lambda ln J_2 / (mu
//                  + lambda/2), its first step from w = 0.

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/stretch.hpp"
#include "model/numerics/elementary.hpp"

namespace femsph {

struct NeoHookean {
  struct Parameters {};
  static constexpr const char* name = "neo-Hookean";
  static Entry entry() {
    return {"neo-hookean",
            "compressible neo-Hookean solid (Bonet & Wood, eq. 6.27); only with motion = \"large\""};
  }
  static Parameters read(Fields&, const LawInput&) { return {}; }
  static NeoHookean of(const Parameters&, const ElasticConstants& m, Plane plane) {
    return make(m.young, m.poisson, m.density, plane);
  }
  static BarYield bar(const Parameters&) { return {}; }  // bars are linear elastic

  LinearElastic base;  ///< the law for small strain
  double lambda;       ///< first Lame parameter of the material, Pa (base.lambda is that of the plane)

  static NeoHookean make(double young, double poisson, double density, Plane plane) {
    return {LinearElastic::make(young, poisson, density, plane),
            young * poisson / ((1 + poisson) * (1 - 2 * poisson))};
  }

  template <int dim>
  static constexpr int history_size = 0;
  static constexpr bool path_independent = true;
  static constexpr bool large_motion_only = true;  ///< in small motion it would be LinearElastic

  /// ln J, and ln t of the stretch t normal to the plane.
  template <class T>
  struct Volume {
    T log_J, log_t;
  };
  template <class T, int dim>
  FEMSPH_INLINE Volume<T> volume(const Symmetric<T, dim>& strain) const {
    const T in = log_of_1_plus(volume_change(strain));
    if (dim == 3 || base.plane == Plane::strain) return {in, T{}};
    const T offset = lambda * in;
    T w = offset * (-1 / (base.mu + 0.5 * lambda));
    for (int turn = 0; turn < 50; ++turn) {  // five for realistic strains
      const T e = exponential(w),
              step = (base.mu * (e - 1.0) + 0.5 * lambda * w + offset) / (base.mu * e + 0.5 * lambda);
      w -= step;
      if (!any((step > 1e-9) | (step < -1e-9))) break;  // the next step would be of the order of its square
    }
    return {in + 0.5 * w, 0.5 * w};
  }

  /// T at the strain e = U - 1. U - U^-1 is computed as e + U^-1 e, without cancellation at small e.
  template <class T, int dim>
  FEMSPH_INLINE Symmetric<T, dim> stress(const Symmetric<T, dim>& strain) const {
    const Symmetric<T, dim> inverse = inverse_stretch(strain);
    const T pressure = lambda * volume(strain).log_J;
    Symmetric<T, dim> s;
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) {
        T product = inverse(i, 0) * strain(0, j);
        for (int k = 1; k < dim; ++k) product += inverse(i, k) * strain(k, j);
        s(i, j) = base.mu * (strain(i, j) + product) + pressure * inverse(i, j);
      }
    return s;
  }

  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>& strain, const Symmetric<T, dim>&, const T*) const {
    const Volume<T> v = volume(strain);
    T shape = 2.0 * trace(strain) + contract(strain, strain);  // F:F - 3
    if (dim == 2 && base.plane == Plane::stress) shape += exponential(2.0 * v.log_t) - 1.0;
    return base.mu * (0.5 * shape - v.log_J) + 0.5 * lambda * v.log_J * v.log_J;
  }

  /// dT/dU along the smallest principal stretch, mu (1 + g) + lambda (1 - ln J) g, relative to the undeformed
  /// one; in plane stress an approximation with lambda of the plane.
  template <class T>
  FEMSPH_INLINE T stiffening(const T& g, const T& J) const {
    return (base.mu * (1.0 + g) + base.lambda * (1.0 - natural_log(J)) * g) *
           (1 / (base.lambda + 2 * base.mu));
  }
  const LinearElastic& elastic() const { return base; }
  double wave_speed() const { return base.wave_speed(); }
  /// Biot stress normal to the plane: lambda ln J in plane strain, where U_zz = 1; 0 in plane stress.
  double thickness_stress(const Symmetric<double, 2>& e, const Symmetric<double, 2>&, const double*) const {
    return base.plane == Plane::strain ? lambda * volume(e).log_J : 0.0;
  }
  /// t - 1
  double thickness_strain(const Symmetric<double, 2>& e, const Symmetric<double, 2>&, const double*) const {
    return std::expm1(volume(e).log_t);
  }
};

}  // namespace femsph
