#pragma once
// What the control of hourglass modes (one_point.hpp) takes from the material.

#include <cmath>
#include <limits>

#include "model/material/flow_stress.hpp"

namespace femsph::fem {

/// Stress at which the fibres of a bent cell flow, Pa; infinite without plasticity. With a yield stress Y in
/// compression and a smaller strength F in tension, an ideally plastic rectangular section carries M = (b h^2
/// / 2) Y F / (Y + F), as one with the strength 2 Y F / (Y + F) on both sides does. In plane strain a fibre
/// yields at 2/sqrt(3) of the uniaxial yield stress.
inline double fibre_strength(const Plasticity* plasticity, Plane plane) {
  if (!plasticity) return std::numeric_limits<double>::infinity();
  const double compression = plasticity->yield;
  const double tension = plasticity->tension == TensionRule::none ? compression
                                                                  : plasticity->tensile_strength;
  return 2 * compression * tension / (compression + tension) *
         (plane == Plane::strain ? 2 / std::sqrt(3.0) : 1.0);
}

struct HourglassModuli {
  double bending;       ///< Eb of one_point.hpp, Pa
  double shear;         ///< mu, Pa
  double uniaxial;      ///< Young's modulus, Pa
  double poisson;       ///< 1
  double yield_energy;  ///< w_y of one_point.hpp, J/m^3
  double perturbation;  ///< coefficient of Flanagan and Belytschko times hourglass_modulus, Pa

  template <class LawType>
  static HourglassModuli of(const LawType& law, double coefficient) {
    LinearElastic e = law.elastic();
    if (e.mu == 0) e.mu = hourglass_modulus(e) / 3.5;  // a fluid: as of a solid with this modulus
    const double bending = 4 * e.mu * (e.lambda + e.mu) / (e.lambda + 2 * e.mu),
                 strength = fibre_strength(plasticity_of(law), e.plane);
    return {bending,
            e.mu,
            2 * e.mu * (1 + e.poisson),
            e.poisson,
            strength * strength / (6 * bending),
            coefficient * hourglass_modulus(e)};
  }
};

}  // namespace femsph::fem
