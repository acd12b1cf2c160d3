#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity velocity{
    .word = "velocity",
    .about = "velocity",
    .unit = "m/s",
    .components = Quantity::Components::vector,
    .on_material = false,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values {
      return {at.velocity[0], at.velocity[1], at.velocity[2]};
    }};

}  // namespace femsph::quantity
