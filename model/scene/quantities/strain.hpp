#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity strain{
    .word = "strain",
    .about = "small strain; at large motion U - 1 of the stretch U, turned to space",
    .unit = "1",
    .components = Quantity::Components::tensor,
    .on_material = true,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values { return at.strain; }};

}  // namespace femsph::quantity
