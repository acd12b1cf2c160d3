#include "model/motion/effects/catalogue.hpp"

#include <algorithm>

namespace femsph {

EffectEntry finite_rotation_effect(), material_effect(), supports_effect(), moved_supports_effect(),
    symmetry_effect(), bars_effect(), loads_effect(), initial_velocity_effect(),
    initial_displacement_effect(), rigid_bodies_effect(), contact_effect(), tied_bodies_effect(),
    friction_effect(), gravity_effect(), damping_effect(), settling_effect(), kinetic_settling_effect();

const std::vector<EffectEntry>& effects() {
  static const std::vector<EffectEntry> all = {
      finite_rotation_effect(), material_effect(),         supports_effect(),
      moved_supports_effect(),  symmetry_effect(),         bars_effect(),
      loads_effect(),           initial_velocity_effect(), initial_displacement_effect(),
      rigid_bodies_effect(),    contact_effect(),          tied_bodies_effect(),
      friction_effect(),        gravity_effect(),          damping_effect(),
      settling_effect(),        kinetic_settling_effect(),
  };
  return all;
}

std::vector<std::string> effects_on(const Scene& scene) {
  std::vector<std::string> on;
  for (const EffectEntry& effect : effects()) {
    if (!effect.on(scene)) continue;
    const std::vector<std::string> words = effect.words ? effect.words(scene) : std::vector{effect.word};
    on.insert(on.end(), words.begin(), words.end());
  }
  return on;
}

std::vector<std::string> effects_off(const Scene& scene) {
  std::vector<const EffectEntry*> named;
  for (const EffectEntry& effect : effects())
    if (effect.rank_off > 0 && (effect.named_off ? effect.named_off(scene) : !effect.on(scene)))
      named.push_back(&effect);
  std::stable_sort(named.begin(), named.end(),
                   [](const EffectEntry* a, const EffectEntry* b) { return a->rank_off < b->rank_off; });
  std::vector<std::string> off;
  for (const EffectEntry* effect : named)
    off.push_back(effect->word_off.empty() ? effect->word : effect->word_off);
  return off;
}

bool pushed_from_outside(const Scene& scene) {
  return std::any_of(effects().begin(), effects().end(),
                     [&](const EffectEntry& effect) { return effect.outside && effect.on(scene); });
}

}  // namespace femsph
