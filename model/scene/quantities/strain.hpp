#pragma once

#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity strain{
    .word = "strain",
    .about = "of the law: small strain, or logarithmic at large motion",
    .unit = "1",
    .components = Quantity::Components::tensor,
    .on_material = true,
    .of_stress = false,
    .read = [](const StateAtPoint& at) -> Quantity::Values { return at.strain; }};

}  // namespace femsph::quantity
