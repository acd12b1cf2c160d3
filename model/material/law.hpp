#pragma once
// Constitutive laws: plain structs, parameters in, stress out; they know no solver. README.md in this folder
// lists them.
//
// A law works in the co-rotated frame of a material point. It offers
//   history_size<dim>      how many doubles of history a point carries (0: none is allocated),
//   path_independent       true when stress follows from the total strain alone,
//   stress(strain)         only if path_independent: total strain -> stress,
//   update(increment, stress, history)
//                          a strain increment carries stress and history from one step to the next,
//   elastic()              its elastic part (for the critical step and hourglass stiffness),
//   stored_energy(strain, stress, history)   J/m^3,
//   thickness_stress(strain, stress, history), thickness_strain(strain, stress, history)   what happens
//   across the plane in 2D, set_step(dt)           only if it depends on the rate of strain: the step that
//   comes, s, seldom                 only if few steps read one slot of its history: which, stiffening(g, J)
//   only if its tangent grows with the deformation: stiffening.hpp, large_motion_only      only if it is made
//   for large motion alone, plastic_strain(history), plastic_work(history)   only if not path_independent:
//   equivalent plastic strain; work not stored, J/m^3;
//                          and beside the law a function flow_stress(law, history, ..): flow_stress.hpp.
// Strain and stress are Symmetric<T, dim>: tensor components, Pa. T is double or Pack.

#include <variant>

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/neo_hookean.hpp"
#include "model/material/laws/plastic.hpp"

namespace femsph {

/// Every law a scene can name. A discretization visits it once, when it is built.
using Law = std::variant<LinearElastic, Plastic, NeoHookean>;

}  // namespace femsph
