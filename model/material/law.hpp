#pragma once
// The catalogue of constitutive laws: structs, parameters in, stress out; they know no solver. A new law is
// one file in laws/, included below, and its name in the list `Laws`.
//
// Of itself a law says
//   Parameters             struct: what its own keys say,
//   name                   in messages: "neo-Hookean",
//   entry()                its word in scenes, one line, and its keys; if it has tables within the
//   material's,
//                          tables() states those,
//   read(fields, in)       Parameters from a scene. A law in one header takes `auto& fields`, so that kernels
//                          need not include the TOML reader,
//   of(parameters, constants, plane)   the law,
// and only if it has something to say,
//   effects(parameters)    what it adds to the list of a scene's effects; otherwise "NAME law",
//   bar(parameters)        what reinforcing bars take of it; otherwise they cannot have it,
//   plasticity(parameters) its von Mises plasticity, for theory and elements that go by that,
//   large_motion_only      it is made for large motion alone.
//
// It works in the co-rotated frame of a material point, and offers
//   history_size<dim>      how many doubles of history a point carries (0: none is allocated),
//   path_independent       true when stress follows from the total strain alone,
//   elastic()              its elastic part (for the critical step and hourglass stiffness),
//   wave_speed()           of the undeformed material, m/s,
//   stored_energy(strain, stress, history)   J/m^3,
//   thickness_stress(strain, stress, history), thickness_strain(strain, stress, history)
//                          what happens across the plane in 2D;
// if path_independent
//   stress(strain)         total strain -> stress; update() too if it is linear: classic SPH in large
//                          motion makes a rate of that,
// if not
//   update(increment, stress, history)       carries stress and history from one step to the next,
//   plastic_strain(history), plastic_work(history)   equivalent plastic strain; work not stored, J/m^3,
// and only if it applies
//   set_step(dt)           it depends on the rate of strain: the step that comes, s,
//   seldom                 the one slot of its history that few steps read,
//   stiffening(g, J)       its tangent grows with the deformation: stiffening.hpp,
//   flow_stress(law, history, share, cauchy)   beside it, its bound of stress: laws/flow_stress.hpp.
// Strain and stress are Symmetric<T, dim>: tensor components, Pa. T is double or Pack.

#include <variant>

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/neo_hookean.hpp"
#include "model/material/laws/plastic.hpp"

namespace femsph {

template <class... L>
struct LawList {
  using Law = std::variant<L...>;
  using Parameters = std::variant<typename L::Parameters...>;
};

/// Every law a scene can name.
using Laws = LawList<LinearElastic, NeoHookean, Plastic>;

/// A discretization visits it once, when it is built.
using Law = Laws::Law;
using LawParameters = Laws::Parameters;

}  // namespace femsph
