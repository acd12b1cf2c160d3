// The time step is adapted to the deformation.
//
// The critical step of the undeformed body follows from its largest eigenvalue (critical_step.hpp). If a law
// gives the Kirchhoff stress with moduli c in the deformed body, tau = tau(c, ln U), the tangent with respect
// to the deformation gradient is
//   dP_iJ/dF_kL = F^-1_Jj c_ijkl F^-1_Ll + (terms of the stress, small beside c in a solid),
// so that a material point becomes stiffer by a factor r of at most c/c_0 / lambda^2, with lambda its
// smallest principal stretch. The largest eigenvalue of the body increases by at most the largest factor of
// its points, so that dt_critical >= dt_0 / sqrt(max r). For both discretizations this is the rule of
// explicit codes that the step is proportional to the shortest side of a cell: a wave crosses it in the time
// lambda d / c. (Belytschko, Liu & Moran, Nonlinear Finite Elements for Continua and Structures, 6.2.3 and
// 6.3.)
//
// The step is only ever reduced. A step that decreases and increases with an oscillation excites the fastest
// modes parametrically. (Trial: a stiff spring whose stiffness a slow one changes by a factor of four, over a
// hundred periods. Its amplitude increased eightyfold with a step that could also increase; it remained
// within the adiabatic factor of 2 with one that could only decrease.) And bodies that are crushed mostly
// remain so.
//
// The step is changed at a whole step n, where u and f are known: v(n+1/2) = v(n-1/2) + (dt_old + dt_new)/2
// a(n). v(n-1/2) is replaced by the velocity half a new step before n, so that all formulas hold with the new
// step. 1/2 v- . M v+ then jumps by 1/8 (dt_old^2 - dt_new^2) a . M a. This is no energy of the body, and is
// added to the initial energy of the balance.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/march.hpp"

namespace femsph {

namespace {

constexpr long longest_wait =
    8;  ///< largest number of steps between two estimates; at a new contact the next is immediate
constexpr double reserve = 0.98;  ///< a reduced step is smaller than its limit by this factor, so that it is
                                  ///< not reduced again at once
constexpr double least_share =
    0.01;  ///< of the step of the undeformed body; with a smaller step the run would not end

}  // namespace

void March::plan() {
  planned_ = planned_steps();
  const auto schedule = [&](int count) {
    const long every = count > 0 ? std::max(1L, planned_ / count) : planned_ + 1;
    return Schedule{double(every) * motion_.dt, 0};
  };
  samples_ = schedule(motion_.scene.samples);
  snapshots_ = schedule(motion_.scene.snapshots);
  watch_every_ = std::clamp(planned_ / 300, 25L, 1000L);
}

void March::follow_deformation() {
  std::size_t touching = 0;
  for (const Effect* effect : effects_.all()) touching += effect->touching();
  const bool hit = touching_ == 0 && touching > 0;
  touching_ = touching;
  if ((motion_.step < next_estimate_ && !hit) || (motion_.step > 0 && motion_.step >= planned_)) return;
  PhaseTimer timer(motion_.price, "step control");
  Stiffening most;
  const MovingBody* stiffest = nullptr;
  for (const MovingBody& body : motion_.bodies)
    if (auto s = body.discretization->stiffening(body.u.data()); s && !(s->ratio <= most.ratio))
      most = *s, stiffest = &body;
  if (!std::isfinite(most.ratio)) look_at_units();
  const double share = 1 / std::sqrt(most.ratio);
  // Until the next estimate the critical step may change, at its present rate, by half of the margin of the
  // safety factor.
  const double allowed = std::clamp(0.5 * (1 / safety_ - 1), 0.005, 0.05);
  const double rate = std::abs(std::log(seen_share_ / share)) /
                      double(std::max(1L, motion_.step - seen_step_));
  const long wait = rate > 0 ? long(std::min(double(longest_wait), allowed / rate)) : longest_wait;
  next_estimate_ = motion_.step + std::clamp(wait, 1L, std::max(1L, 2 * (motion_.step - seen_step_)));
  seen_share_ = share;
  seen_step_ = motion_.step;
  critical_now_ = share * critical_;
  const auto where = [&] {
    return stiffest ? fmt::format("body \"{}\", {} at ({:.6g}, {:.6g}, {:.6g}) m", stiffest->name, most.unit,
                                  most.position[0], most.position[1], most.position[2])
                    : fastest_point();
  };
  if (!(share >= least_share))
    fail(Stopped::Watch::step, where(),
         fmt::format("it is crushed so far that the largest stable step has fallen to {:.3g} s, {:.2g} % of "
                     "the undeformed body's",
                     critical_now_, 100 * share),
         "the load is more than this discretization can follow: try a gentler load, other divisions there, a "
         "finer spacing, or a stronger material");
  if (given_step_) {
    if (motion_.dt > (1 + 1e-9) * critical_now_)
      fail(Stopped::Watch::step, where(),
           fmt::format(
               "the step of {:.4g} s is over the limit: deformed as it is now, the body bears {:.4g} s",
               motion_.dt, critical_now_),
           fmt::format("march without --step, and the step follows the deformation, or with --step {:.2g}",
                       0.8 * critical_now_));
    return;
  }
  const double limit = safety_ * critical_now_;
  if (motion_.dt > (1 + 1e-9) * limit)
    motion_.next_dt = reserve * limit;  // not for the round-off of an undeformed body
  if (motion_.step == 0) motion_.dt = motion_.price.dt = smallest_step_ = motion_.next_dt;
}

void March::change_step() {
  const Kinetic before = kinetic();
  const Leap over = motion_.leap(0.5 * (motion_.dt + motion_.next_dt)), then = motion_.leap(motion_.next_dt);
  for (MovingBody& body : motion_.bodies) {
    const bool viscous = !body.viscous.empty();
    for (std::size_t i = 0; i < body.v.size(); ++i) {
      const double w = body.inverse_mass[i];
      if (w == 0) continue;
      const double a = w * (viscous ? body.f[i] + body.viscous[i] : body.f[i]);
      body.v[i] = (over.keep * body.v[i] + (over.push - then.push) * a) / then.keep;
    }
  }
  for (RigidBody& body : motion_.rigid) body.kick(over.keep / then.keep, (over.push - then.push) / then.keep);
  motion_.since_time = time();
  motion_.since_step = motion_.step;
  motion_.dt = motion_.next_dt;
  smallest_step_ = std::min(smallest_step_, motion_.dt);
  ++step_changes_;
  planned_ = planned_steps();
  const Kinetic after = kinetic();
  initial_energy_ += after.energy - before.energy + after.damping - before.damping + after.viscosity -
                     before.viscosity;
}

}  // namespace femsph
