#pragma once
// The catalogue of effects: what a scene can ask for beyond bodies of a linear elastic law that nothing acts
// on. One entry an effect, one list; the march, `femsph check`, the run record, the reader of scenes and the
// page of keys follow from it.
//
// To add one: write a file here that defines `EffectEntry NAME_effect()`, and name it in catalogue.cpp.

#include <memory>
#include <string>
#include <vector>

#include "model/input/keys.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

class Fields;
struct MadeEffect;
struct Motion;

/// Entry::word is what `check` and the record list.
struct EffectEntry : Entry {
  std::string asked_by = "";           ///< what of a scene asks for it: "[gravity]", "[[contacts]] friction"
  bool (*on)(const Scene&) = nullptr;  ///< whether this scene does
  /// It exchanges momentum with the outside: the sum over all bodies is then not kept.
  bool outside = false;
  /// Place in the line "effects off" of `check`; 0: it is not listed there.
  int rank_off = 100;
  std::string word_off = "";                  ///< where several share one word there
  bool (*named_off)(const Scene&) = nullptr;  ///< whether it is listed there; none: where it is not on
  std::vector<std::string> (*words)(const Scene&) = nullptr;  ///< the words of one that goes by several
  /// The march's part of it (effect.hpp); none: the work is done elsewhere (in a law, a discretization, the
  /// kick). It is made where the effect is on, or, if `needed` is given, where that holds.
  MadeEffect (*make)(Motion&) = nullptr;
  bool (*needed)(const Motion&) = nullptr;
  /// Its own table of the scene (`keys` are those of that table), where the scene has no member for it.
  std::string table = "";
  std::shared_ptr<const EffectInput> (*read)(Fields& table, int dim) = nullptr;
};

/// All of them, in the order in which they are listed and do their work.
const std::vector<EffectEntry>& effects();

/// The words of those that a scene asks for; everything else costs nothing.
std::vector<std::string> effects_on(const Scene& scene);
/// The words of the principal ones that it does not ask for.
std::vector<std::string> effects_off(const Scene& scene);
/// Whether something outside pushes on the bodies.
bool pushed_from_outside(const Scene& scene);

/// What the table of an effect holds, as that effect has read it; null if the scene has no such table.
template <class Input>
const Input* input_of(const Scene& scene, const std::string& table) {
  const auto found = scene.effect_inputs.find(table);
  return found == scene.effect_inputs.end() ? nullptr : dynamic_cast<const Input*>(found->second.get());
}

}  // namespace femsph
