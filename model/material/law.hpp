#pragma once
// The catalogue of constitutive laws. A law is a struct that computes stress from strain at one material
// point and knows nothing of solvers. A new law is one file in laws/, which is included below, and its name
// in the list `Laws`.
//
// A law describes itself by
//   Parameters             struct: the values of its keys,
//   name                   its name in messages: "neo-Hookean",
//   entry()                its word in scenes, its description and its keys,
//   tables()               its tables within that of the material, if it has any,
//   read(fields, in)       Parameters from a scene. A law in one header takes `auto& fields`, so that kernels
//                          need not include the TOML reader,
//   of(parameters, constants, plane)   the law,
// and, where they apply, by
//   effects(parameters)    its names in the list of effects of a scene; otherwise "NAME law",
//   bar(parameters)        its yield stress for reinforcing bars; otherwise bars cannot have the law,
//   plasticity(parameters) its von Mises plasticity, for theory values and elements that depend on it,
//   large_motion_only      it is for large motion only,
//   fluid                  it has no shear stiffness, and neither "young" nor "poisson".
//
// It works in the co-rotated frame of a material point (kinematics.hpp), and has
//   history_size<dim>      how many doubles of history a point carries (0: none is allocated),
//   path_independent       true when stress follows from the total strain alone,
//   elastic()              its elastic part (for the critical step and hourglass stiffness),
//   wave_speed()           of the undeformed material, m/s,
//   stored_energy(strain, stress, history)   J/m^3,
//   thickness_stress(strain, stress, history), thickness_strain(strain, stress, history)
//                          stress and strain normal to the plane in 2D;
// if path_independent
//   stress(strain)         total strain -> stress; update() too if it is linear: classic SPH in large
//                          motion makes a rate of that,
// if not
//   update(increment, stress, history)       carries stress and history from one step to the next,
//   plastic_strain(history), plastic_work(history)   equivalent plastic strain; work not stored, J/m^3,
// and, where they apply,
//   return_cauchy()        from then on stress and energies are those of the present volume; before, and for
//                          laws without it, kinematics.hpp says which,
//   set_step(dt)           sets the next time step, s, for a law that depends on the strain rate,
//   seldom                 the one entry of its history that few steps read,
//   stiffening(g, J)       how its tangent stiffness grows with the deformation: stiffening.hpp,
//   flow_stress(law, history, share, cauchy)   a free function: its limit of stress, laws/flow_stress.hpp.
// Strain and stress are Symmetric<T, dim>: tensor components, Pa. T is double or Pack.

#include <variant>

#include "model/material/laws/fluid.hpp"
#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/neo_hookean.hpp"
#include "model/material/laws/plastic.hpp"
#include "model/material/laws/plastic_with_eos.hpp"

namespace femsph {

template <class... L>
struct LawList {
  /// A plastic material with an equation of state has the word of Plastic.
  using Law = std::variant<L..., PlasticWithEos>;
  using Parameters = std::variant<typename L::Parameters...>;
};

/// All laws that a scene can name.
using Laws = LawList<LinearElastic, NeoHookean, Plastic, Fluid>;

/// A discretization visits the variant once, when it is made.
using Law = Laws::Law;
using LawParameters = Laws::Parameters;

}  // namespace femsph
