#pragma once

#include "model/numerics/principal.hpp"
#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity principal_stress{
    .word = "principal_stress",
    .about = "principal stresses, the largest first, with the one normal to the plane in a plane scene",
    .unit = "Pa",
    .components = Quantity::Components::principal,
    .on_material = true,
    .of_stress = true,
    .read = [](const StateAtPoint& at) -> Quantity::Values {
      const std::array<double, 3> principal = principal_values(at.stress);
      return {principal[0], principal[1], principal[2]};
    }};

}  // namespace femsph::quantity
