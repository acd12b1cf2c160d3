// The checks of a run: finite numbers, energy, cells and particles, and the time step.
//
// Every watch_every_ steps there is a quick check of the kinetic energy; every eighth time, and at the end, a
// full check.

#include <fmt/format.h>

#include <cmath>

#include "model/motion/march.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph {

namespace {

constexpr long quick_checks = 8;  ///< for each full one

/// Tolerated error of the energy balance, relative to the energy supplied. Belytschko, Liu and Moran
/// (Nonlinear Finite Elements for Continua and Structures, 6.2.3) regard a run as unstable beyond about 1 %;
/// chattering contact comes near that here.
constexpr double tolerance = 0.05;

/// 1/2 v . M v at the last half step, J.
double half_step_kinetic(const MovingBody& body) {
  return parallel_sum(body.v.size(), [&](std::size_t begin, std::size_t end) {
    double s = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double w = body.inverse_mass[i];
      s += w > 0 ? body.v[i] * body.v[i] / w : 0.0;
    }
    return 0.5 * s;
  });
}

std::string in_metres(const Point& x) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]); }

}  // namespace

void March::watch(bool last) {
  PhaseTimer timer(motion_.price, "watching");
  if (motion_.step == 0) {
    if (keep_good_) good_.save(*this);
    return;
  }
  if (!last && !motion_.scene.settling && motion_.step % (quick_checks * watch_every_) != 0) {
    double moving = 0;
    for (const MovingBody& body : motion_.bodies) moving += half_step_kinetic(body);
    if (!(moving <= allowance())) look_at_energy(ledger());
    return;
  }
  const Ledger l = ledger();
  look_at_energy(l);
  if (last || motion_.step % (quick_checks * watch_every_) == 0) {
    look_at_units();
    if (keep_good_) good_.save(*this);
  }
  if (motion_.scene.settling) settle(l);
}

/// The largest kinetic energy at a half step, or stored energy, in a stable run (J): in the leap-frog, either
/// energy of a mode of angular frequency omega and energy E is at most E / (1 - (omega dt / 2)^2), and the
/// sum of all E is the energy supplied.
double March::allowance() const {
  const double share = motion_.dt / critical_now_;
  return (1 + tolerance) * (initial_energy_ + external_passed_ + created_) /
             std::max(0.05, 1 - share * share) +
         1e-12;
}

void March::look_at_energy(const Ledger& l) {
  if (!std::isfinite(l.stored()) || !std::isfinite(l.external))
    fail(
        Stopped::Watch::not_a_number, fastest_point(), "a displacement is not a finite number",
        motion_.scene.large_motion
            ? "a unit may have turned inside out, the march may have become unstable, or a load or material "
              "is out of range: try more [time] "
              "snapshots to see where it begins, a gentler load, or a smaller --safety"
            : "the march has become unstable, or a load or material is out of range: try a smaller --safety");
  created_ = std::max(created_, -l.plastic);
  const double supplied = initial_energy_ + external_passed_ + created_, from_nowhere = -l.imbalance();
  const double held = l.strain + l.hourglass + l.contact, most = allowance();
  double moving = 0;
  for (const MovingBody& body : motion_.bodies) moving += half_step_kinetic(body);
  if (moving <= most && held <= most && from_nowhere <= tolerance * supplied + 1e-12) return;
  look_at_units();  // a folded cell would be the more likely cause
  const std::string place = fastest_point();
  const std::string grown =
      from_nowhere > tolerance * supplied + 1e-12
          ? fmt::format(
                "{:.3g} J of energy have come from nowhere, with {:.3g} J supplied by loads and the start",
                from_nowhere, supplied)
          : fmt::format("the energy has grown to {:.3g} J, with {:.3g} J supplied by loads and the start",
                        std::max(moving, held), supplied);
  const double omega = frequency_of_motion();
  if (omega * motion_.dt > 1.95)
    fail(Stopped::Watch::step, place,
         fmt::format("{}; what grows has a frequency of {:.4g} rad/s, which no step above {:.4g} s can "
                     "follow, and the step is {:.4g} s",
                     grown, omega, 2 / omega, motion_.dt),
         fmt::format("the deformed body is stiffer than at the start: try --safety {:.2g}",
                     0.8 * 2 / omega / critical_now_));
  fail(Stopped::Watch::energy, place, grown,
       "the march or the discretization is unstable there: try a smaller --safety, a finer spacing or "
       "another method");
}

/// The angular frequency (rad/s) of the dominant motion, from one further step: omega^2 = -du . df / (du . M
/// du), a Rayleigh quotient of the tangent stiffness.
double March::frequency_of_motion() {
  double most = 0;
  MemoryArchive here;
  here.save(*this);
  std::vector<AlignedVector<double>> before;
  for (const MovingBody& body : motion_.bodies) before.push_back(body.f);
  try {
    kick_and_drift();
    ++motion_.step;
    keep_internal_ = false;
    forces();
    for (std::size_t b = 0; b < motion_.bodies.size(); ++b) {
      const MovingBody& body = motion_.bodies[b];
      double work = 0, inertia = 0;
      for (std::size_t i = 0; i < body.u.size(); ++i) {
        if (body.inverse_mass[i] == 0) continue;
        work -= body.v[i] * (body.f[i] - before[b][i]);
        inertia += body.v[i] * body.v[i] / body.inverse_mass[i];
      }
      if (work > 0 && std::isfinite(work) && inertia > 0)
        most = std::max(most, std::sqrt(work / (motion_.dt * inertia)));
    }
  } catch (const MotionError&) {  // the contact does not allow that step; the frequency remains unknown
  }
  here.restore(*this);
  for (std::size_t b = 0; b < motion_.bodies.size(); ++b) motion_.bodies[b].f = before[b];
  return most;
}

void March::look_at_units() {
  if (!motion_.scene.large_motion) return;
  for (const MovingBody& body : motion_.bodies)
    if (const auto trouble = body.discretization->trouble(body.u.data()))
      fail(Stopped::Watch::unit, fmt::format("body \"{}\", at {}", body.name, in_metres(trouble->position)),
           trouble->what, trouble->advice);
}

void March::keep_good_states() {
  keep_good_ = motion_.scene.large_motion || motion_.scene.is_plastic() || effects_.bodies_may_part();
}

bool March::return_to_good_state() {
  if (good_.empty()) return false;
  good_.restore(*this);
  return true;
}

/// The point with the largest velocity, the likely place of an instability; or the first one whose velocity
/// is not a finite number.
std::string March::fastest_point() const {
  std::string place = "unknown place";
  double fastest = -1;
  for (const MovingBody& body : motion_.bodies) {
    const Layout& at = body.discretization->layout();
    for (std::size_t i = 0; i < at.points; ++i) {
      double speed = 0;
      for (int c = 0; c < at.dim; ++c)
        speed += body.v[at.at(i, c)] * body.v[at.at(i, c)] + 0 * body.f[at.at(i, c)];
      if (speed <= fastest) continue;
      fastest = speed;
      const Point x = body.discretization->position(i);
      place = fmt::format("body \"{}\", point {} at {}", body.name, i, in_metres(x));
      if (!std::isfinite(speed)) return place;
    }
  }
  return place;
}

void March::fail(Stopped::Watch watch, const std::string& place, const std::string& what,
                 const std::string& advice) const {
  throw Stopped(watch, fmt::format("stopped at step {} (t = {:.6g} s), {}: {}; {}", motion_.step, time(),
                                   place, what, advice));
}

}  // namespace femsph
