#pragma once
// How much stress a point of a plastic law can bear now: what a reading between points must not exceed.

#include <limits>

#include "model/material/kinematics.hpp"
#include "model/material/law.hpp"

namespace femsph {

/// Pa, of the Cauchy stress.
struct FlowStress {
  double yield = std::numeric_limits<double>::infinity();     ///< bound of von Mises' stress
  double tensile = std::numeric_limits<double>::infinity();   ///< the same where the mean stress is tension;
                                                              ///< other than `yield` by the sign rule only
  double strength = std::numeric_limits<double>::infinity();  ///< bound of the principal stresses
};

/// `cauchy` is the point's own stress, and `share` that over the law's stress. Infinite without return
/// mapping: there the stress passes the yield stress, and rightly by these hypotheses. By Johnson and Cook's
/// rule what the last step's rate and heat make of it, and not below what the point bears: where the strain
/// stands still, stress that a rate held up stays.
FlowStress flow_stress(const Plastic& law, const double* history, double share,
                       const std::array<double, 6>& cauchy);

inline const Plasticity* plasticity_of(const Plastic& law) { return &law.parameters; }
template <class LawType>
const Plasticity* plasticity_of(const LawType&) {
  return nullptr;
}

/// Cauchy stress over the law's stress of a point. `across` is the stretch - 1 normal to the plane.
template <class Kinematics, int dim>
double cauchy_share(const Symmetric<double, dim>& strain, double across) {
  if constexpr (std::is_same_v<Kinematics, LargeStrain>)
    return 1 / ((1 + growth(strain)) * (1 + (dim == 2 ? across : 0.0)));
  else
    return 1;
}

}  // namespace femsph
