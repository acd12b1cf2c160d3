#pragma once
// What a discretization needs to know of a law to say how much stress its points can bear.

#include "model/material/kinematics.hpp"
#include "model/material/law.hpp"

namespace femsph {

/// Null for laws without von Mises plasticity.
template <class LawType>
const Plasticity* plasticity_of(const LawType& law) {
  if constexpr (requires { LawType::plasticity(law.parameters); })
    return LawType::plasticity(law.parameters);
  else
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
