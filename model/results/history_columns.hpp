#pragma once
// The columns of a scene's history: names and units, known before any run.

#include "model/results/history.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// time, every probe's components (NAME_x, ..), energies, momenta, rigid bodies, contacts, reactions; in the
/// order in which Recorder::sample fills them. Throws InputError when two would have one name.
History history_columns(const Scene& scene);

/// The supports whose reactions are taken, as indices into scene.holds(): of deformable bodies, point by
/// point. Those with a name have columns.
std::vector<std::size_t> holds_with_reactions(const Scene& scene);

/// The columns that hold an energy, J: those of every scene, and those of some effect.
const std::vector<std::string>& energy_columns();

}  // namespace femsph
