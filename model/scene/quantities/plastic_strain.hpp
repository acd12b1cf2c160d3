#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity plastic_strain{
    .word = "plastic_strain",
    .about = "equivalent plastic strain",
    .unit = "1",
    .components = Quantity::Components::scalar,
    .on_material = true,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values { return {at.plastic}; }};

}  // namespace femsph::quantity
