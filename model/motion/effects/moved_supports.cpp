// Supports with a prescribed velocity, and supports that stop points which [[initial]] has given a velocity.
//
// The velocity of a prescribed component goes from v- to v+ = V h(t(n+1/2)), with V the velocity of the
// support and h its history, whatever forces act. Its equation of motion, m (v+ - keep v-) / push = f + R
// with keep and push as in Leap, gives the reaction R. So R includes the force that accelerates the mass of
// the point itself and that overcomes its damping, and the sum of R over the steps is exactly the change of
// momentum of the body. The work of the reaction over a step is 1/2 dt v(n+1/2) (R(n) + R(n+1)); with it the
// energy balance closes (see March::kinetic).
//
// At t = 0 the point has the velocity v(0) that [[initial]] gives its body, so v(-1/2) = 2 v(0) - v(+1/2). If
// the support moves with another velocity, the reaction at t = 0 contains an impulse: m (v(+1/2) - v(0)) in
// the half step before t = 0, and the same in the half step after it. The trapezoidal rule over a history, in
// which the first row counts for half a step, gives the impulse m (v(+1/2) - v(0)).

#include <algorithm>

#include "model/motion/effects/effect.hpp"

namespace femsph {

namespace {

class MovedSupports : public Effect {
 public:
  explicit MovedSupports(Motion&) {}

  void find_reactions(Motion& motion) override {
    const Leap over = motion.leap(0.5 * (motion.dt + motion.next_dt));
    const double middle = motion.time() + 0.5 * motion.next_dt;
    for (MovingBody& body : motion.bodies)
      for (MovingBody::Driven& d : body.driven) {
        d.after = d.velocity == 0 ? 0.0 : d.velocity * motion.scene.supports[d.support].history.at(middle);
        if (motion.step == 0) body.v[d.slot] = 2 * d.start - d.after;
        d.before = body.v[d.slot];
        const double others = body.f[d.slot] + (body.viscous.empty() ? 0.0 : body.viscous[d.slot]);
        d.reaction = d.mass * (d.after - over.keep * d.before) / over.push - others;
      }
  }

  void after_kick(const Motion& motion, MovingBody& body, double& damping, double& viscosity) override {
    for (const MovingBody::Driven& d : body.driven) {
      double& v = body.v[d.slot];  // set by the kick, which has also moved the point by dt v
      const double mean = 0.5 * (d.before + d.after);
      damping += motion.damping_rate * motion.dt * d.mass * mean * mean;
      if (!body.viscous.empty())
        viscosity -= motion.dt * body.viscous[d.slot] *
                     (mean - 0.5 * (d.before + v));  // the kick has counted the second mean
      body.u[d.slot] += motion.dt * (d.after - v);
      v = d.after;
    }
  }

  void reaction_work(const Motion& motion, double& work) const override {
    for (const MovingBody& body : motion.bodies)
      for (const MovingBody::Driven& d : body.driven) work += 0.5 * motion.dt * body.v[d.slot] * d.reaction;
  }
};

}  // namespace

EffectEntry moved_supports_effect() {
  EffectEntry e{{"moved supports", "prescribed velocities"}};
  e.asked_by = "[[supports]] velocity";
  e.on = [](const Scene& s) {
    return std::any_of(s.supports.begin(), s.supports.end(),
                       [](const Support& support) { return support.velocity != Point{}; });
  };
  e.outside = true;
  e.listed_off = false;
  e.make = make_effect<MovedSupports>;
  e.needed = [](const Motion& m) {
    return std::any_of(
        m.bodies.begin(), m.bodies.end(), [](const MovingBody& body) { return !body.driven.empty(); });
  };
  return e;
}

}  // namespace femsph
