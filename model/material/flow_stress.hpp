#pragma once
// For discretizations: the yield stress of their material points.

#include "model/material/kinematics.hpp"
#include "model/material/law.hpp"

namespace femsph {

/// The von Mises plasticity of a law; null if it has none.
template <class LawType>
const Plasticity* plasticity_of(const LawType& law) {
  if constexpr (requires { LawType::plasticity(law.parameters); })
    return LawType::plasticity(law.parameters);
  else
    return nullptr;
}

/// The ratio of the Cauchy stress to the law's stress. `across`: stretch - 1 normal to the plane, in 2D.
template <class Kinematics, int dim>
double cauchy_share(const Symmetric<double, dim>& strain, double across) {
  if constexpr (std::is_same_v<Kinematics, LargeStrain>)
    return 1 / ((1 + volume_change(strain)) * (1 + (dim == 2 ? across : 0.0)));
  else
    return 1;
}

}  // namespace femsph
