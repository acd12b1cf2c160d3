#include "model/motion/effects/catalogue.hpp"

#include <algorithm>

namespace femsph {

EffectEntry finite_rotation_effect(), plasticity_effect(), supports_effect(), moved_supports_effect(),
    symmetry_effect(), bars_effect(), loads_effect(), initial_velocity_effect(),
    initial_displacement_effect(), rigid_bodies_effect(), contact_effect(), tied_bodies_effect(),
    friction_effect(), gravity_effect(), damping_effect(), settling_effect();

const std::vector<EffectEntry>& effects() {
  static const std::vector<EffectEntry> all = {
      finite_rotation_effect(), plasticity_effect(),       supports_effect(),
      moved_supports_effect(),  symmetry_effect(),         bars_effect(),
      loads_effect(),           initial_velocity_effect(), initial_displacement_effect(),
      rigid_bodies_effect(),    contact_effect(),          tied_bodies_effect(),
      friction_effect(),        gravity_effect(),          damping_effect(),
      settling_effect(),
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
  std::vector<std::string> off;
  for (const EffectEntry& effect : effects())
    if (effect.listed_off && (effect.off ? effect.off(scene) : !effect.on(scene))) off.push_back(effect.word);
  return off;
}

bool pushed_from_outside(const Scene& scene) {
  return std::any_of(effects().begin(), effects().end(),
                     [&](const EffectEntry& effect) { return effect.outside && effect.on(scene); });
}

}  // namespace femsph
