// Supports that move, or that stop points which are in motion at the start.
//
// A driven component goes from v- to v+ = V h(t(n+1/2)), whatever acts on it. As of any other component m (v+
// - keep v-) / push = f + R, with R the reaction: what accelerates the point's own mass (and overcomes its
// damping) is in it, and the sum of R over the steps is the change of momentum of the whole body, exactly.
// Over a step the reaction does the work 1/2 dt v(n+1/2) (R(n) + R(n+1)), which closes the ledger (see
// March::kinetic).
//
// At t = 0 the point has the velocity v(0) that [[initial]] gives its body, like every other: v(-1/2) = 2
// v(0) - v(+1/2). If the support then moves at another speed the reaction of that instant is an impulse, m
// (v(+1/2) - v(0)) in the half step before t = 0 and as much again in the one after: by the trapezoidal rule,
// in which the first row of a history counts for half a step, it is m (v(+1/2) - v(0)).

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
      double& v = body.v[d.slot];  // from the kick, which has moved the point by dt v
      const double mean = 0.5 * (d.before + d.after);
      damping += motion.damping_rate * motion.dt * d.mass * mean * mean;
      if (!body.viscous.empty())
        viscosity -= motion.dt * body.viscous[d.slot] *
                     (mean - 0.5 * (d.before + v));  // the kick has counted the latter
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
  EffectEntry e{{"moved supports", "held displacements that follow a velocity in time"}};
  e.asked_by = "[[supports]] velocity";
  e.on = [](const Scene& s) {
    return std::any_of(s.supports.begin(), s.supports.end(),
                       [](const Support& support) { return support.velocity != Point{}; });
  };
  e.outside = true;
  e.rank_off = 0;
  e.make = make_effect<MovedSupports>;
  e.needed = [](const Motion& m) {
    return std::any_of(
        m.bodies.begin(), m.bodies.end(), [](const MovingBody& body) { return !body.driven.empty(); });
  };
  return e;
}

}  // namespace femsph
