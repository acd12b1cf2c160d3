// Settling: the run ends when the bodies are at rest in equilibrium.
//
// For both methods of damping this means that the unbalanced forces r on free components (mass times
// acceleration) and the remaining motion are small: three ratios are below the scene's `tolerance` in two
// successive checks.
//   force         sum |r| / sum |loads and weight|. The resultant of the reactions differs from that of the
//                 loads by sum r.
//   displacement  |r / m| / (omega^2 |u|) with |x| = (x . M x)^1/2 and omega^2 the Rayleigh quotient of u. In
//   a
//                 mode of angular frequency omega, r is omega^2 m times the displacement that is still to
//                 come; for higher modes the ratio overestimates it. Not used in scenes with contact or rigid
//                 bodies, whose displacement may be rigid-body motion.
//   motion        (kinetic energy / stored energy)^1/2, the amplitude of an oscillation about equilibrium
//   over
//                 the displacement.
// And no load may still change.
//
// Kinetic damping (Cundall 1976; Barnes, Int. J. Space Structures 14 (1999) 89): whenever the kinetic energy
// has passed a peak, all velocities are set to zero at the position of the peak. Here this is the middle of
// the last step before the kinetic energy decreases; at step n that is known from v- . f + v+ . f < 0. A mode
// with phase angle theta per step, 2 sin(theta/2) = omega dt, that starts from rest is then at cos(theta/2)
// cos((n - 1/2) theta) of its initial amplitude: at most sin(theta)/2 at its own peak, for all frequencies up
// to the stability limit, and never more than 1. If the velocities were set to zero where the peak is
// detected, up to one step later, the highest modes would not be damped, and their peaks would stop all
// slower motion every few steps. To go back half a step, the bodies move for one step with minus half of the
// last velocity, so that laws, friction and ties see an ordinary step.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/march.hpp"
#include "model/numerics/parallel.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

/// The sum of part(slot) over all slots, the same to the last bit for any number of threads.
template <class Part>
double sum_over(const MovingBody& body, Part&& part) {
  return parallel_sum(body.u.size(), [&](std::size_t begin, std::size_t end) {
    double s = 0;
    for (std::size_t i = begin; i < end; ++i) s += part(i);
    return s;
  });
}

}  // namespace

void March::settle(const Ledger& l) {
  double inertia = 0, accelerated = 0, left = 0, reactions = 0,
         loads = 0;  // u . M u, a . M a, and sums of magnitudes
  for (const MovingBody& body : motion_.bodies) {
    inertia += sum_over(body, [&](std::size_t i) { return body.mass[i] * body.u[i] * body.u[i]; });
    accelerated += sum_over(
        body, [&](std::size_t i) { return body.inverse_mass[i] * body.force(i) * body.force(i); });
    left += sum_over(
        body, [&](std::size_t i) { return body.inverse_mass[i] == 0 ? 0.0 : std::abs(body.force(i)); });
    const Layout& at = body.discretization->layout();
    for (std::size_t k = 0; k < body.held.size(); ++k) {
      const auto& [point, component, hold] = body.held[k];
      if (k == 0 || body.held[k - 1].point != point || body.held[k - 1].component != component)
        reactions += std::abs(reaction(body, at.at(point, component)));
    }
    for (const Effect* effect : effects_.all()) {
      effect->each_reaction(motion_, body, [&](std::size_t, double f) { reactions += std::abs(f); });
      effect->size_on_body(motion_, body, loads);
    }
  }
  for (const RigidBody& body : motion_.rigid) {
    for (int c = 0; c < 3; ++c) {
      inertia += body.mass * body.moved[c] * body.moved[c];
      (body.held[c] ? reactions : left) += std::abs(body.force[c]);
      if (!body.held_turn[c]) left += std::abs(body.moment[c]) / body.reach();
    }
    loads += body.mass * sum_of_magnitudes(body.gravity);
    for (const Effect* effect : effects_.all()) effect->size_on_rigid(motion_, body, loads);
  }
  const double stored = l.strain + l.hourglass;
  const double omega = inertia > 0 ? std::sqrt(2 * stored / inertia)
                                   : 0.0;                   // Rayleigh quotient of the displacement
  if (adaptive_damping_) motion_.damping_rate = 2 * omega;  // critical damping of the slowest mode
  if (loads == 0) force_scale_ = std::max({force_scale_, reactions, left});  // the largest so far
  const double scale = loads > 0 ? loads : force_scale_;
  const auto share = [](double part, double whole) { return part == 0 ? 0.0 : part / whole; };
  residuals_.force = share(left, scale);
  residuals_.displacement = !effects_.bodies_may_part() && motion_.rigid.empty()
                                ? share(std::sqrt(accelerated), omega * omega * std::sqrt(inertia))
                                : 0.0;
  residuals_.motion = std::sqrt(share(l.kinetic, stored + l.contact));
  const double after = time() + 0.5 * motion_.dt;
  residuals_.loads_change = std::any_of(effects_.all().begin(), effects_.all().end(),
                                        [&](const Effect* effect) { return effect->changes_after(after); });
  const double tolerated = motion_.scene.settling->tolerance;
  const bool still = residuals_.force <= tolerated && residuals_.displacement <= tolerated &&
                     residuals_.motion <= tolerated && !residuals_.loads_change;
  if (!still)
    still_since_ = -1;
  else if (still_since_ < 0)
    still_since_ = time();
  else
    settled_ = true;
}

void March::say_what_did_not_settle() {
  const double worst = std::max({residuals_.force, residuals_.displacement, residuals_.motion}),
               tolerated = motion_.scene.settling->tolerance;
  std::string advice = "give it more time ([time] duration)";
  if (residuals_.loads_change)
    advice = "a load still changes: let its history end earlier, or give a longer [time] duration";
  else if (worst < 10 * tolerated)
    advice += ", or a larger [settling] tolerance";
  const bool to_come = !effects_.bodies_may_part() && motion_.rigid.empty();
  warnings_.push_back(fmt::format(
      "not settled within {:g} s: the forces out of balance are still {:.2g} of the loads, {}what moves "
      "{:.2g} of the displacement, for a tolerance of "
      "{:g}; these results are of a body on its way and no static state: {}",
      time(), residuals_.force,
      to_come ? fmt::format("the displacement still to come {:.2g} and ", residuals_.displacement) : "",
      residuals_.motion, tolerated, advice));
}

/// Whether the kinetic energy decreases from the last half step to the next one: dt/2 f . (v- + v+) < 0.
bool March::past_kinetic_peak() const {
  double gain = 0;
  for (const MovingBody& body : motion_.bodies)
    gain += sum_over(body, [&](std::size_t i) {
      const double w = body.inverse_mass[i], f = body.force(i);
      return w == 0 ? 0.0 : f * (2 * body.v[i] + motion_.dt * w * f);
    });
  for (const RigidBody& body : motion_.rigid)
    gain += (body.product(1, motion_.dt, 0, 2) - body.product(1, motion_.dt, 2, 0) +
             body.energy_of_kick(1, motion_.dt)) /
            motion_.dt;
  return gain < 0;
}

double March::work_of_the_step() const {
  double work = 0;
  for (const MovingBody& body : motion_.bodies)
    work += sum_over(body, [&](std::size_t i) { return body.v[i] * body.f[i]; });
  for (const RigidBody& body : motion_.rigid)
    work += dot(body.velocity, body.force) + dot(body.rate(), body.moment);
  return 0.5 * motion_.dt * work;
}

/// Replaces a kick. The kinetic energy, and the work of the forces on the way back, count as losses to
/// damping.
void March::go_back_half_a_step() {
  const Kinetic k = kinetic();
  damping_loss_ += k.energy + k.damping;
  viscous_loss_ += k.viscosity;
  for (MovingBody& body : motion_.bodies)
    for (double& v : body.v) v *= -0.5;
  for (RigidBody& body : motion_.rigid) body.velocity = -0.5 * body.velocity, body.spin = -0.5 * body.spin;
  damping_loss_ += work_of_the_step();
  const double dt = motion_.dt;
  for (MovingBody& body : motion_.bodies) {
    double *u = body.u.data(), *v = body.v.data();
    parallel_for(body.u.size(), 512, [=](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) u[i] += dt * v[i];
    });
  }
  for (RigidBody& body : motion_.rigid) body.drift(motion_.dt);
  work_of_outside();
  going_back_ = true;
}

void March::start_again_from_rest() {
  damping_loss_ += work_of_the_step();
  const auto [keep, push] = motion_.leap(motion_.dt);
  for (MovingBody& body : motion_.bodies)
    for (std::size_t i = 0; i < body.v.size(); ++i)
      body.v[i] = -push / (1 + keep) * body.inverse_mass[i] * body.force(i);
  for (RigidBody& body : motion_.rigid) {
    body.velocity = body.spin = {};
    body.start_from(keep, push);
  }
  const Kinetic k = kinetic();
  damping_loss_ -= k.energy + k.damping;
  viscous_loss_ -= k.viscosity;
  going_back_ = false;
}

}  // namespace femsph
