#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity strain{
    .word = "strain",
    .about = "small strain; in large motion R (U - 1) R^T, with F = R U",
    .unit = "1",
    .components = Quantity::Components::tensor,
    .on_material = true,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values { return at.strain; }};

}  // namespace femsph::quantity
