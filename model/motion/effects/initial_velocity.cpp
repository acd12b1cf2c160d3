// How the bodies start: velocities, and displacements.

#include "model/motion/effects/effect.hpp"

namespace femsph {

namespace {

class InitialVelocities : public Effect {
 public:
  explicit InitialVelocities(Motion&) {}
  void start(Motion& motion) override {
    for (const InitialVelocity& start : motion.scene.initial_velocities) {
      for (MovingBody& body : motion.bodies)
        if (start.body == body.index) add(start, body);
      for (RigidBody& body : motion.rigid)
        if (start.body == body.index) {
          const Point v = start.at(body.centre());
          for (int c = 0; c < 3; ++c)
            body.velocity[c] += v[c], body.spin[c] += body.inertia[c] * start.spin[c];
        }
    }
  }

 private:
  static void add(const InitialVelocity& start, MovingBody& body) {
    const Layout& at = body.discretization->layout();
    for (std::size_t i = 0; i < at.points; ++i) {
      const Point v = start.at(body.discretization->position(i));
      for (int c = 0; c < at.dim; ++c)
        if (const std::size_t slot = at.at(i, c); body.inverse_mass[slot] != 0) body.v[slot] += v[c];
    }
  }
};

class InitialDisplacements : public Effect {
 public:
  explicit InitialDisplacements(Motion& motion) {
    for (MovingBody& body : motion.bodies) {
      const Layout& at = body.discretization->layout();
      for (const InitialDisplacement& start : motion.scene.initial_displacements)
        if (start.body == body.index)
          for (std::size_t i = 0; i < at.points; ++i) {
            const Point u = start.at(body.discretization->position(i));
            for (int c = 0; c < at.dim; ++c) body.u[at.at(i, c)] = u[c];
          }
    }
  }
  bool strains_the_start() const override { return true; }
};

}  // namespace

EffectEntry initial_velocity_effect() {
  EffectEntry e{{"initial velocity", "the motion of a body at t = 0"}};
  e.asked_by = "[[initial]]";
  e.on = [](const Scene& s) { return !s.initial_velocities.empty(); };
  e.rank_off = 5;
  e.make = make_effect<InitialVelocities>;
  return e;
}

EffectEntry initial_displacement_effect() {
  EffectEntry e{{"initial displacement", "the displacement of a body at t = 0"}};
  e.asked_by = "[[initial_displacements]]";
  e.on = [](const Scene& s) { return !s.initial_displacements.empty(); };
  e.rank_off = 6;
  e.make = make_effect<InitialDisplacements>;
  return e;
}

}  // namespace femsph
