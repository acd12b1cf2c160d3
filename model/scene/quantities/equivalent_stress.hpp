#pragma once

#include "model/numerics/principal.hpp"
#include "model/scene/quantities/quantity.hpp"

namespace femsph::quantity {

inline constexpr Quantity equivalent_stress{
    .word = "equivalent_stress",
    .about = "von Mises stress",
    .unit = "Pa",
    .components = Quantity::Components::scalar,
    .on_material = true,
    .of_stress = true,
    .read = [](const StateAtPoint& at) -> Quantity::Values { return {von_mises(at.stress)}; }};

}  // namespace femsph::quantity
