// Effects whose work is done elsewhere: by the kinematics and the law of the material, by discretizations, by
// rigid bodies, and by the kick and the watch of the march.

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry finite_rotation_effect() {
  EffectEntry e{{"finite rotation", "strain and stress in axes that turn with the material"}};
  e.asked_by = "[model] motion = \"large\"";
  e.on = [](const Scene& s) { return s.large_motion; };
  e.rank_off = 1;
  return e;
}

EffectEntry material_effect() {
  EffectEntry e{{"plasticity",
                 "a law other than linear elasticity; each rule that departs from the plain "
                 "law is listed by its own name"}};
  e.asked_by = "[materials.NAME] law";
  e.on = [](const Scene& s) { return !material_effects(s).empty(); };
  e.words = material_effects;
  e.rank_off = 4;
  e.named_off = [](const Scene& s) { return !s.is_plastic(); };
  return e;
}

EffectEntry symmetry_effect() {
  EffectEntry e{{"symmetry", "a plane beyond which a body goes on, mirrored"}};
  e.asked_by = "[[symmetry]]";
  e.on = [](const Scene& s) { return !s.symmetries.empty(); };
  e.outside = true;
  e.rank_off = 2;
  return e;
}

EffectEntry bars_effect() {
  EffectEntry e{{"bars", "reinforcement along an axis, bonded to its body"}};
  e.asked_by = "[bars.NAME]";
  e.on = [](const Scene& s) { return !s.bars.empty(); };
  e.rank_off = 3;
  return e;
}

EffectEntry rigid_bodies_effect() {
  EffectEntry e{{"rigid bodies", "bodies that move and turn as a whole"}};
  e.asked_by = "[bodies.NAME] rigid = true";
  e.on = [](const Scene& s) {
    return std::any_of(s.bodies.begin(), s.bodies.end(), [](const Body& body) { return body.rigid; });
  };
  e.rank_off = 0;
  return e;
}

EffectEntry friction_effect() {
  EffectEntry e{{"friction", "Coulomb friction where bodies press on each other"}};
  e.asked_by = "[[contacts]] friction";
  e.on = [](const Scene& s) {
    return std::any_of(s.contacts.begin(), s.contacts.end(), [](const Contact& c) { return c.friction > 0; });
  };
  e.rank_off = 0;
  return e;
}

EffectEntry damping_effect() {
  EffectEntry e{{"damping", "mass-proportional: a force -c m v on every point, within the kick"}};
  e.asked_by = "[damping]";
  e.on = [](const Scene& s) { return s.damping.has_value(); };
  e.outside = true;
  e.rank_off = 9;
  return e;
}

EffectEntry settling_effect() {
  EffectEntry e{{"settling by damping", "damped until the bodies are at rest"}};
  e.asked_by = "[settling] method = \"damping\"";
  e.on = [](const Scene& s) { return s.settling && s.settling->method == SettlingMethod::damping; };
  e.outside = true;
  e.rank_off = 10;
  e.word_off = "settling";
  e.named_off = [](const Scene& s) { return !s.settling.has_value(); };
  return e;
}

EffectEntry kinetic_settling_effect() {
  EffectEntry e{{"settling by kinetic damping", "from rest again at every peak of the kinetic energy"}};
  e.asked_by = "[settling] method = \"kinetic\"";
  e.on = [](const Scene& s) { return s.settling && s.settling->method == SettlingMethod::kinetic; };
  e.outside = true;
  e.rank_off = 0;
  return e;
}

}  // namespace femsph
