#pragma once
// A compressible fluid: an equation of state, and a constant dynamic viscosity or none,
//   sigma = -p I + 2 eta dev(d) / dt      (Newton; no bulk viscosity)
// with d the strain increment of the step and dt its time. It has no shear stiffness. Not in plane stress.
//
// update() takes the co-rotated increment and sums its change of ln J (log_volume.hpp). It returns
// the Kirchhoff stress J sigma, and energies per undeformed volume, as kinematics.hpp needs them; after
// return_cauchy() the Cauchy stress sigma, and energies per present volume, as forms of SPH need that sum
// over present volumes.

#include "model/material/laws/equation_of_state.hpp"
#include "model/material/laws/linear_elastic.hpp"

namespace femsph {

struct Fluid {
  struct Parameters {
    EquationOfState eos;
    double viscosity = 0;  ///< eta, Pa s
  };
  static constexpr const char* name = "a fluid";
  // Description and reading of the keys: fluid.cpp.
  static Entry entry();
  static std::vector<KeyTable> tables();
  static Parameters read(Fields& fields, const LawInput& in);
  static std::vector<std::string> effects(const Parameters& p);
  static Fluid of(const Parameters& p, const ElasticConstants& m, Plane plane);

  static constexpr bool fluid = true;  ///< no shear stiffness, and neither "young" nor "poisson"
  static constexpr bool large_motion_only = true;
  static constexpr bool path_independent = false;

  Parameters parameters;
  LinearElastic base;   ///< lambda = K, mu = 0; its Poisson's ratio: below
  double step = 0;      ///< the time (s) of the next strain increments; 0: not known, and no viscosity
  bool cauchy = false;  ///< of the stress that update() takes and returns; else Kirchhoff
  void set_step(double dt) { step = dt; }
  void return_cauchy() { cauchy = true; }

  /// Of `base`. Elements that assume strains by it keep (1 - nu/(1 - nu))^2 = 1 % of the stiffness of volume
  /// in their hourglass modes, as other controls do in a fluid (hourglass_modulus); with 1/2 none would be
  /// left.
  static constexpr double nearly_half = 0.9 / 1.9;

  /// `work`: of the viscosity, J/m^3; `energy`: of equation_of_state.hpp; `across`: the stress normal to the
  /// plane, 2D only.
  enum Slot { log_volume, energy, work, across };
  template <int dim>
  static constexpr int history_size = dim == 2 ? 4 : 3;

  template <class T, int dim>
  FEMSPH_INLINE void update(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
    const Symmetric<T, dim> by =
        increment;  // copies: what the kernel holds in registers must not have an address
    Symmetric<T, dim> to = stress;
    advance(by, to, history);
    stress = to;
  }
  /// update(). In fluid.cpp for T = double and Pack, dim = 2 and 3.
  template <class T, int dim>
  void advance(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const;

  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>&, const Symmetric<T, dim>&, const T* history) const {
    return stored(history);
  }
  template <class T>
  T stored(const T* history) const;

  /// Pressure alone has no shear stiffness, so that dP/dF = g J^2 (-dp/dJ) exactly. The viscous stress lags
  /// by half a step: central differences are stable for omega^2 + 2 c/dt <= 4/dt^2 with c the damping rate of
  /// a mode, at most 4/3 eta/K omega^2. So it counts as a stiffness 8/3 eta/dt.
  template <class T>
  T stiffening(const T& g, const T& J) const;

  const LinearElastic& elastic() const { return base; }
  double wave_speed() const { return base.wave_speed(); }
  double thickness_stress(const Symmetric<double, 2>&, const Symmetric<double, 2>&,
                          const double* history) const {
    return history[across];
  }
  double thickness_strain(const Symmetric<double, 2>&, const Symmetric<double, 2>&, const double*) const {
    return 0;
  }
  template <class T>
  FEMSPH_INLINE T plastic_strain(const T*) const {
    return T{};
  }
  template <class T>
  FEMSPH_INLINE T plastic_work(const T* history) const {
    return history[work];
  }
};

}  // namespace femsph
