#pragma once
// What the control of hourglass modes (one_point.hpp) needs to know of a material.

#include <cmath>
#include <limits>

#include "model/material/law.hpp"

namespace femsph::fem {

/// Stress at which the fibres of a bent cell flow, Pa: infinite for laws that do not yield.
template <class LawType>
double fibre_strength(const LawType&) {
  return std::numeric_limits<double>::infinity();
}
/// Where tension ends earlier than compression, an ideally plastic section carries M = (b h^2 / 2) Y F / (Y +
/// F): as with 2 Y F / (Y + F) for both. In plane strain yielding takes 2/sqrt(3) of the uniaxial stress.
inline double fibre_strength(const Plastic& law) {
  const double compression = law.parameters.yield;
  const double tension = law.parameters.tension == TensionRule::none ? compression
                                                                     : law.parameters.tensile_strength;
  return 2 * compression * tension / (compression + tension) *
         (law.base.plane == Plane::strain ? 2 / std::sqrt(3.0) : 1.0);
}

/// Pa.
struct HourglassModuli {
  double bending, shear, uniaxial, poisson;
  double yield_energy;  ///< w_y of one_point.hpp, J/m^3
  double perturbation;  ///< Flanagan and Belytschko's coefficient times the modulus that it stands by

  template <class LawType>
  static HourglassModuli of(const LawType& law, double coefficient) {
    const LinearElastic& e = law.elastic();
    const double bending = 4 * e.mu * (e.lambda + e.mu) / (e.lambda + 2 * e.mu),
                 strength = fibre_strength(law);
    return {bending,
            e.mu,
            2 * e.mu * (1 + e.poisson),
            e.poisson,
            strength * strength / (6 * bending),
            coefficient * hourglass_modulus(e)};
  }
};

}  // namespace femsph::fem
