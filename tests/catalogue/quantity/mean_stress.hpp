#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity mean_stress{
    .word = "mean_stress",
    .about = "a third of the trace of the stress",
    .unit = "Pa",
    .components = Quantity::Components::scalar,
    .on_material = true,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values {
      return {(at.stress[0] + at.stress[1] + at.stress[2]) / 3};
    },
    .scalar_name = "mean"};

}  // namespace femsph::quantity
