#pragma once
// The columns of a scene's history: names and units, known before any run.

#include "model/results/history.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// Time, components of the probes (NAME_x, ..), energies, momenta, rigid bodies, contacts and reactions, in
/// the order in which Recorder::sample fills them. Throws InputError if two columns would have the same name.
History history_columns(const Scene& scene);

/// The supports whose reactions are computed, as indices into scene.holds(): those of deformable bodies,
/// except mode "mean". Those with a name have columns.
std::vector<std::size_t> holds_with_reactions(const Scene& scene);

/// The names of the columns of energies, J: first those of every scene, then those of effects.
const std::vector<std::string>& energy_columns();

}  // namespace femsph
