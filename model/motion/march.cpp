// The time loop of both solvers (flowchart: fig. 1 of the paper):
//
//   (step) -> forces -> (sample, snapshot) -> kick and drift -> next step
//
// with v(n+1/2) = v(n-1/2) + dt M^-1 f(u(n)), u(n+1) = u(n) + dt v(n+1/2) (leap-frog, or central difference).
// All other forces and constraints are effects (effects/effect.hpp).

#include "model/motion/march.hpp"

#include <algorithm>

#include "model/numerics/parallel.hpp"
#include "model/numerics/simd.hpp"

namespace femsph {

void March::run(const MarchEvents& events) {
  flush_denormals();
  if (motion_.step == 0) {
    if (follows_) follow_deformation();
    plan();
  }
  cpu_before_ = cpu_seconds() - motion_.price.cpu, wall_before_ = wall_seconds() - motion_.price.wall;
  running_ = true;
  struct StopClocks {  // also when an exception ends the run
    March& march;
    ~StopClocks() { march.read_clocks(), march.running_ = false; }
  } const stop{*this};
  while (true) {
    if (follows_) follow_deformation();
    keep_internal_ = (events.sample && samples_.is_due(time(), motion_.dt)) || may_be_last();
    forces();
    if (motion_.step == 0) {
      start_velocities();
    } else {
      for (Effect* effect : effects_.with(Hook::find_reactions)) effect->find_reactions(motion_);
      reaction_work();
    }
    const bool at_rest = motion_.step == 0 || going_back_;
    if (going_back_) start_again_from_rest();
    if (motion_.next_dt != motion_.dt) change_step();
    if (motion_.step % watch_every_ == 0 || motion_.step >= planned_) watch(motion_.step >= planned_);
    const bool last = settled_ || motion_.step >= planned_;
    motion_.price.steps = motion_.step;
    if (events.sample && (samples_.due(time(), motion_.dt) || last)) {
      PhaseTimer timer(motion_.price, "sampling");
      events.sample(*this);
    }
    if (events.snapshot && (snapshots_.due(time(), motion_.dt) || last)) {
      PhaseTimer timer(motion_.price, "fields");
      events.snapshot(*this);
    }
    if (events.progress && motion_.step % watch_every_ == 0) events.progress(*this);
    if (last) break;
    if (keep_internal_)
      for (MovingBody& body : motion_.bodies) body.internal = {};
    if (kinetic_damping_ && !at_rest && past_kinetic_peak())
      go_back_half_a_step();
    else
      kick_and_drift();
    ++motion_.step;
    if (events.between) events.between(*this);
  }
  if (motion_.scene.settling && !settled_) say_what_did_not_settle();
}

/// Called on demand and not in every step: reading the CPU time is a system call, which takes as long as a
/// step of a hundred cells.
void March::read_clocks() const {
  if (!running_) return;
  motion_.price.cpu = cpu_seconds() - cpu_before_;
  motion_.price.wall = wall_seconds() - wall_before_;
}

/// A run that settles ends at one of the checks.
bool March::may_be_last() const {
  return motion_.step >= planned_ || (motion_.scene.settling && motion_.step % watch_every_ == 0);
}

void March::forces() {
  for (RigidBody& body : motion_.rigid) {
    body.begin_forces();
    for (Effect* effect : effects_.with(Hook::push_rigid)) effect->push_rigid(motion_, body);
  }
  for (MovingBody& body : motion_.bodies) {
    body.discretization->internal_force(body.u.data(), body.v.data(), motion_.step == 0 ? 0.0 : motion_.dt,
                                        body.f.data(), body.viscous.empty() ? nullptr : body.viscous.data());
    if (keep_internal_) {
      body.internal = body.f;
      for (std::size_t i = 0; i < body.viscous.size(); ++i) body.internal[i] += body.viscous[i];
    }
    for (Effect* effect : effects_.with(Hook::push_body)) effect->push_body(motion_, body);
  }
  for (Effect* effect : effects_.with(Hook::push_between)) effect->push_between(motion_);
  for (Effect* effect : effects_.with(Hook::constrain)) effect->constrain(motion_);
}

}  // namespace femsph
