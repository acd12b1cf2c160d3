#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity pressure{
    .word = "pressure",
    .about = "pressure, minus a third of the trace of the stress",
    .unit = "Pa",
    .components = Quantity::Components::scalar,
    .on_material = true,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values {
      return {-(at.stress[0] + at.stress[1] + at.stress[2]) / 3};
    },
    .scalar_name = "pressure"};

}  // namespace femsph::quantity
