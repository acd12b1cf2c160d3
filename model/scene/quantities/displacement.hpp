#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity displacement{
    .word = "displacement",
    .about = "displacement from the undeformed position",
    .unit = "m",
    .components = Quantity::Components::vector,
    .on_material = false,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values {
      return {at.displacement[0], at.displacement[1], at.displacement[2]};
    }};

}  // namespace femsph::quantity
