// The update of velocities ("kick") and displacements ("drift") of all bodies, the losses to damping and
// viscosity, and the work of external forces. Damping and artificial viscosity are part of the loop over the
// entries; separate versions of the loop are compiled without them.

#include <algorithm>
#include <cmath>

#include "model/motion/entries.hpp"
#include "model/motion/march.hpp"

namespace femsph {

namespace {

/// Kick and drift of one body. Mass-proportional damping uses the mean vbar of the velocities half a step
/// before and after: v+ = ((1 - c dt/2) v- + dt f/m) / (1 + c dt/2). Damping dissipates c dt m vbar^2 per
/// component, viscosity -f_visc vbar dt.
template <bool damped, bool viscous>
void advance(MovingBody& body, double dt, double rate, double& damping_loss, double& viscous_loss) {
  double* __restrict u = body.u.data();
  double* __restrict v = body.v.data();
  const double* __restrict f = body.f.data();
  const double* __restrict w = body.inverse_mass.data();
  [[maybe_unused]] const double* __restrict g = body.viscous.data();
  [[maybe_unused]] const double* __restrict m = body.mass.data();
  const double keep = (1 - 0.5 * rate * dt) / (1 + 0.5 * rate * dt), push = dt / (1 + 0.5 * rate * dt);
  const std::size_t n = body.u.size();
  if constexpr (!damped && !viscous) {
    const auto loop = [=](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        v[i] += dt * w[i] * f[i];
        u[i] += dt * v[i];
      }
    };
    if (n < entries_for_one_thread)
      loop(0, n);
    else
      parallel_for(n, 512, loop);
  } else {
    const auto loop = [=](std::size_t begin, std::size_t end, double& by_damping, double& by_viscosity) {
      double d = 0, q = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const double force = viscous ? f[i] + g[i] : f[i];
        const double now = damped ? keep * v[i] + push * w[i] * force : v[i] + dt * w[i] * force;
        const double mean = 0.5 * (v[i] + now);
        if constexpr (damped) d += m[i] * mean * mean;
        if constexpr (viscous) q -= g[i] * mean;
        v[i] = now;
        u[i] += dt * now;
      }
      by_damping = d;
      by_viscosity = q;
    };
    // Two sums in one pass: the second one is stored for each chunk and added in the order of the chunks.
    std::vector<double> q((n + 4095) / 4096, 0.0);
    damping_loss += rate * dt * sum_of_entries(n, [&](std::size_t begin, std::size_t end) {
                      double by_damping = 0, by_viscosity = 0;
                      loop(begin, end, by_damping, by_viscosity);
                      q[begin / 4096] = by_viscosity;
                      return by_damping;
                    });
    for (double part : q) viscous_loss += dt * part;
  }
}

}  // namespace

void March::kick_and_drift() {
  for (MovingBody& body : motion_.bodies) {
    const bool damped = motion_.damping_rate > 0, viscous = !body.viscous.empty();
    if (damped && viscous)
      advance<true, true>(body, motion_.dt, motion_.damping_rate, damping_loss_, viscous_loss_);
    else if (damped)
      advance<true, false>(body, motion_.dt, motion_.damping_rate, damping_loss_, viscous_loss_);
    else if (viscous)
      advance<false, true>(body, motion_.dt, 0, damping_loss_, viscous_loss_);
    else
      advance<false, false>(body, motion_.dt, 0, damping_loss_, viscous_loss_);
    for (Effect* effect : effects_.with(Hook::after_kick))
      effect->after_kick(motion_, body, damping_loss_, viscous_loss_);
  }
  move_rigid_bodies();
  work_of_outside();
  reaction_work();
}

void March::move_rigid_bodies() {
  const auto [keep_now, push_now] = motion_.leap(motion_.dt);
  const double keep = keep_now, push = push_now;  // Clang 14 captures no structured binding
  for (RigidBody& body : motion_.rigid) {
    const double before = body.product(keep, push, 1, 2);  // v-.v- + 2 v-.v+
    body.kick(keep, push);
    damping_loss_ += 0.25 * motion_.damping_rate * motion_.dt * (before + body.product(0, 0, 1, 0));
    body.drift(motion_.dt);
  }
}

void March::work_of_outside() {
  const double done = external_work_;
  for (const MovingBody& body : motion_.bodies)
    for (const Effect* effect : effects_.with(Hook::work_on_body))
      effect->work_on_body(motion_, body, external_work_);
  for (const RigidBody& body : motion_.rigid)
    for (const Effect* effect : effects_.with(Hook::work_on_rigid))
      effect->work_on_rigid(motion_, body, external_work_);
  external_passed_ += std::abs(external_work_ - done);
}

/// Called twice in a step: after the drift, and when the next forces are known.
void March::reaction_work() {
  const double done = external_work_;
  for (const Effect* effect : effects_.with(Hook::reaction_work))
    effect->reaction_work(motion_, external_work_);
  external_passed_ += std::abs(external_work_ - done);
}

}  // namespace femsph
