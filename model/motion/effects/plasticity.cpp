// Laws other than linear elasticity. Their keys and their work are in the laws (material/laws/).

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry plasticity_effect() {
  EffectEntry e{
      {"plasticity", "a law other than linear elasticity; its variants are listed by their own names"}};
  e.asked_by = "[materials.NAME] law";
  e.on = [](const Scene& s) { return !material_effects(s).empty(); };
  e.words = material_effects;
  e.off = [](const Scene& s) { return !s.is_plastic(); };
  return e;
}

}  // namespace femsph
