#pragma once
// The catalogue of effects: what a scene can contain besides bodies of a linear elastic material. Each effect
// is one file of this folder, which states its word, its tables and keys, reads them, and does its work. The
// list is in catalogue.cpp. The time loop, `femsph check`, the run record, the reader of scenes and the page
// of keys follow from it.
//
// To add an effect: write a file here that defines `EffectEntry NAME_effect()`, and name it in catalogue.cpp.

#include <memory>
#include <string>
#include <vector>

#include "model/input/keys.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

class Fields;
struct MadeEffect;
struct Motion;
namespace scene_reader {
struct Reading;
}

/// One effect. Entry::word is its name in `femsph check` and in the run record.
struct EffectEntry : Entry {
  std::string asked_by = "";  ///< the table or key that switches it on: "[gravity]", "[[contacts]] friction"
  /// Whether a scene contains it.
  bool (*on)(const Scene&) = nullptr;
  /// It exchanges momentum with something outside of the bodies, so that the momentum of all bodies together
  /// is not conserved.
  bool outside = false;

  /// Its tables in a scene, with their keys; and the function that reads them from the top level of the file
  /// into reading.scene. Both empty where the tables belong to another effect or to a body or material.
  std::vector<KeyTable> tables = {};
  void (*read)(Fields& root, scene_reader::Reading& reading) = nullptr;

  /// Makes the part of it that the time loop calls (effect.hpp). Null where the work is done elsewhere: by a
  /// law, by a discretization, or by the loop itself. Made where the effect is on; with `needed`, where that
  /// holds.
  MadeEffect (*make)(Motion&) = nullptr;
  bool (*needed)(const Motion&) = nullptr;

  /// The names to list where it is on; null: its word.
  std::vector<std::string> (*words)(const Scene&) = nullptr;
  /// Whether the line "effects off" of `femsph check` lists it; null: where it is not on.
  bool (*off)(const Scene&) = nullptr;
  bool listed_off = true;  ///< false: that line never lists it
};

/// All effects, in the order in which they are listed, read and called.
const std::vector<EffectEntry>& effects();

/// Names of the effects that a scene contains.
std::vector<std::string> effects_on(const Scene& scene);
/// Names of the main effects that it does not contain.
std::vector<std::string> effects_off(const Scene& scene);
/// Whether any effect of the scene exchanges momentum with something outside of the bodies.
bool pushed_from_outside(const Scene& scene);

/// The input of an effect that has no member of its own in Scene: its reader puts it into
/// Scene::effect_inputs under the name of its table. Null if the scene does not have that table.
template <class Input>
const Input* input_of(const Scene& scene, const std::string& table) {
  const auto found = scene.effect_inputs.find(table);
  return found == scene.effect_inputs.end() ? nullptr : dynamic_cast<const Input*>(found->second.get());
}

}  // namespace femsph
