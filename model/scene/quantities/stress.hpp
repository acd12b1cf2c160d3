#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity stress{
    .word = "stress",
    .about = "Cauchy stress",
    .unit = "Pa",
    .components = Quantity::Components::tensor,
    .on_material = true,
    .of_stress = true,
    .read = [](const StateAtPoint& at) -> Quantity::Values { return at.stress; }};

}  // namespace femsph::quantity
