// Rigid bodies. Their keys are among those of [bodies.NAME]; their motion is in bodies/rigid.hpp.

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry rigid_bodies_effect() {
  EffectEntry e{{"rigid bodies", "bodies that do not deform: they translate and rotate"}};
  e.asked_by = "[bodies.NAME] rigid = true";
  e.on = [](const Scene& s) {
    return std::any_of(s.bodies.begin(), s.bodies.end(), [](const Body& body) { return body.rigid; });
  };
  e.listed_off = false;
  return e;
}

}  // namespace femsph
