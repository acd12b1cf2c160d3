// Large motion. Its work is in the kinematics of a material point (material/kinematics.hpp).

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry finite_rotation_effect() {
  EffectEntry e{{"finite rotation", "large motion: strain and stress in axes that rotate with the material"}};
  e.asked_by = "[model] motion = \"large\"";
  e.on = [](const Scene& s) { return s.large_motion; };
  return e;
}

}  // namespace femsph
