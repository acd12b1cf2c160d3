#include "model/motion/effects/catalogue.hpp"

namespace femsph {

EffectEntry initial_velocity_effect() {
  EffectEntry e{{"initial velocity", "the motion of a body at t = 0"}};
  e.asked_by = "[[initial]]";
  e.on = [](const Scene& s) { return !s.initial_velocities.empty(); };
  e.rank_off = 5;
  return e;
}

EffectEntry initial_displacement_effect() {
  EffectEntry e{{"initial displacement", "the displacement of a body at t = 0"}};
  e.asked_by = "[[initial_displacements]]";
  e.on = [](const Scene& s) { return !s.initial_displacements.empty(); };
  e.rank_off = 6;
  return e;
}

}  // namespace femsph
