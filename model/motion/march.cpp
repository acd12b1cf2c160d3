// The flowchart of an explicit run (fig. 1 of the paper), for both solvers:
//
//   (step) -> forces -> (sample, snapshot) -> kick and drift -> next step
//
// with   v(n+1/2) = v(n-1/2) + dt M^-1 f(u(n)),   u(n+1) = u(n) + dt v(n+1/2)   (leap-frog, or central
// difference).

#include "model/motion/march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/motion/critical_step.hpp"
#include "model/motion/gravity.hpp"
#include "model/numerics/parallel.hpp"
#include "model/numerics/simd.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

void March::run(const MarchEvents& events) {
  flush_denormals();
  if (step_ == 0) {
    if (follows_) follow_deformation();
    plan();
  }
  cpu_before_ = cpu_seconds() - price_.cpu, wall_before_ = wall_seconds() - price_.wall;
  running_ = true;
  struct StopClocks {  // however the run ends
    March& march;
    ~StopClocks() { march.read_clocks(), march.running_ = false; }
  } const stop{*this};
  while (true) {
    if (follows_) follow_deformation();
    forces();
    if (step_ == 0)
      start_velocities();
    else
      find_reactions(), count_driven_work();
    const bool at_rest = step_ == 0 || going_back_;
    if (going_back_) start_again_from_rest();
    if (next_dt_ != dt_) change_step();
    if (step_ % watch_every_ == 0 || step_ >= planned_) watch(step_ >= planned_);
    const bool last = settled_ || step_ >= planned_;
    price_.steps = step_;
    if (events.sample && (samples_.due(time(), dt_) || last)) {
      PhaseTimer timer(price_, "sampling");
      events.sample(*this);
    }
    if (events.snapshot && (snapshots_.due(time(), dt_) || last)) {
      PhaseTimer timer(price_, "fields");
      events.snapshot(*this);
    }
    if (events.progress && step_ % watch_every_ == 0) events.progress(*this);
    if (last) break;
    if (kinetic_damping_ && !at_rest && past_kinetic_peak())
      go_back_half_a_step();
    else
      kick_and_drift();
    ++step_;
    if (events.between) events.between(*this);
  }
  if (scene_.settling && !settled_) say_what_did_not_settle();
}

/// When somebody asks, not in every step: the clock of the process is a call of the kernel, which takes as
/// long as a step of a hundred cells.
void March::read_clocks() const {
  if (!running_) return;
  price_.cpu = cpu_seconds() - cpu_before_;
  price_.wall = wall_seconds() - wall_before_;
}

void March::forces() {
  for (RigidBody& body : rigid_) body.load(scene_, time());
  for (MovingBody& body : bodies_) {
    Discretization& d = *body.discretization;
    d.internal_force(body.u.data(), body.v.data(), step_ == 0 ? 0.0 : dt_, body.f.data(),
                     body.viscous.empty() ? nullptr : body.viscous.data());
    for (const MovingBody::NodalLoad& load : body.loads)
      body.f[load.slot] += load.force * scene_.loads[load.load].history.at(time());
    if (scene_.gravity) add_weight(d.layout(), d.mass(), *scene_.gravity, body.f.data());
  }
  for (ContactPair& contact : contacts_) {
    PhaseTimer timer(price_, "contact");
    try {
      contact.add_forces(bodies_, rigid_, step_, dt_);
    } catch (const MotionError& error) {
      if (step_ == 0) throw;
      throw Stopped(Stopped::Watch::contact, error.what());
    }
  }
  if (!ties_.empty()) {
    PhaseTimer timer(price_, "contact");
    const auto [keep, push] = leap(0.5 * (dt_ + next_dt_));
    ties_.add_forces(bodies_, keep, push, next_dt_, dt_, step_ == 0);
  }
  for (MovingBody& body : bodies_) hold_means(body);  // last: reactions answer to every other force
}

/// A mean that stands still stays still if sum_i w_i f_i / m_i = 0: the reactions are f_i += R w_i with R =
/// -(sum w f/m) / (sum w^2/m). They do no work, since sum_i w_i v_i = 0 at every half step.
void March::hold_means(MovingBody& body) {
  const auto project = [&](MovingBody::MeanHold& hold, AlignedVector<double>& f) {
    double sum = 0;
    for (std::size_t k = 0; k < hold.slots.size(); ++k)
      sum += hold.weights[k] * body.inverse_mass[hold.slots[k]] * f[hold.slots[k]];
    const double reaction = -sum / hold.inverse_mass;
    for (std::size_t k = 0; k < hold.slots.size(); ++k) f[hold.slots[k]] += reaction * hold.weights[k];
    return reaction;
  };
  for (MovingBody::MeanHold& hold : body.means) {
    hold.reaction = project(hold, body.f);
    if (!body.viscous.empty()) hold.reaction += project(hold, body.viscous);
  }
}

namespace {

/// Entries of a vector cost a quarter of a particle or less: below this many a loop over them is not worth a
/// fork.
constexpr std::size_t entries_for_one_thread = 4 * serial_below;

/// parallel_sum over the entries of a vector, to the same bits.
template <class Body>
double sum_of_entries(std::size_t n, Body&& body) {
  if (n >= entries_for_one_thread) return parallel_sum(n, body);
  double sum = 0;
  for (std::size_t begin = 0; begin < n; begin += 4096) sum += body(begin, std::min(begin + 4096, n));
  return sum;
}

/// One body's kick and drift. Mass-proportional damping is taken at the mean of the two half-step velocities:
/// v+ = ((1 - c dt/2) v- + dt f/m) / (1 + c dt/2); what it takes is c dt m vbar^2 a component, what viscosity
/// takes is -f_visc vbar dt.
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
    // Two sums in one pass: the second is kept per chunk as well, in chunk order.
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
  for (MovingBody& body : bodies_) {
    const bool damped = damping_rate_ > 0, viscous = !body.viscous.empty();
    if (damped && viscous)
      advance<true, true>(body, dt_, damping_rate_, damping_loss_, viscous_loss_);
    else if (damped)
      advance<true, false>(body, dt_, damping_rate_, damping_loss_, viscous_loss_);
    else if (viscous)
      advance<false, true>(body, dt_, 0, damping_loss_, viscous_loss_);
    else
      advance<false, false>(body, dt_, 0, damping_loss_, viscous_loss_);
    if (!body.driven.empty()) drive(body);
  }
  move_rigid_bodies();
  count_work_of_loads();
  count_driven_work();
}

void March::count_work_of_loads() {
  const double now = time(), next = time_of(step_ + 1), done = external_work_;
  for (const MovingBody& body : bodies_) {
    for (const MovingBody::NodalLoad& load : body.loads) {
      const TimeHistory& h = scene_.loads[load.load].history;
      external_work_ += load.force * 0.5 * (h.at(now) + h.at(next)) * dt_ * body.v[load.slot];
    }
    if (scene_.gravity)
      external_work_ += dt_ * power_of_weight(body.discretization->layout(), body.discretization->mass(),
                                              *scene_.gravity, body.v.data());
  }
  for (const RigidBody& body : rigid_) {
    for (const Load& load : scene_.loads)
      if (load.place.body == body.index)
        external_work_ += 0.5 * (load.history.at(now) + load.history.at(next)) * dt_ *
                          dot(load.force, body.velocity);
    if (scene_.gravity) external_work_ += body.mass * dt_ * dot(*scene_.gravity, body.velocity);
  }
  external_passed_ += std::abs(external_work_ - done);
}

// With v+ - v- = dt (f/m - c vbar) + dt g/m, the energy 1/2 v-.M v+ changes from step n to n + 1 by
// 1/2 dt v(n+1/2) . (f(n) + f(n+1)) less what damping and viscosity take the same way. So the losses at step
// n count with v- for the interval before it and with v+ for the one after it: together vbar, and half of it
// at the ends.
March::Kinetic March::kinetic() const {
  Kinetic k;
  const auto [keep_now, push_now] = leap(dt_);
  const double keep = keep_now, push = push_now;  // Clang 14 captures no structured binding
  for (const MovingBody& body : bodies_) {
    const bool viscous = !body.viscous.empty();
    const auto sum = [&](auto&& part) {
      return parallel_sum(body.v.size(), [&](std::size_t begin, std::size_t end) {
        const double *w = body.inverse_mass.data(), *v = body.v.data(), *f = body.f.data(),
                     *g = body.viscous.data();
        const auto add_up = [=](auto&& force) {
          const auto entry = [=](std::size_t i) {
            const double value = part(i, v[i], keep * v[i] + push * w[i] * force(i));
            return w[i] == 0 ? 0.0 : value;
          };
          double s[lanes] = {};  // side by side: no addition waits for the one before
          std::size_t i = begin;
          for (; i + lanes <= end; i += lanes)
            for (int l = 0; l < lanes; ++l) s[l] += entry(i + std::size_t(l));
          for (; i < end; ++i) s[0] += entry(i);
          return std::accumulate(s, s + lanes, 0.0);
        };
        return viscous ? add_up([=](std::size_t i) { return f[i] + g[i]; })
                       : add_up([=](std::size_t i) { return f[i]; });
      });
    };
    k.energy += sum([w = body.inverse_mass.data()](std::size_t i, double before, double after) {
      return 0.5 / w[i] * before * after;
    });
    if (damping_rate_ > 0)
      k.damping += 0.25 * damping_rate_ * dt_ * sum([&](std::size_t i, double before, double after) {
                     return (before + after) * before / body.inverse_mass[i];
                   });
    if (viscous)
      k.viscosity -= 0.5 * dt_ *
                     sum([&](std::size_t i, double before, double) { return body.viscous[i] * before; });
    for (const MovingBody::Driven& d : body.driven) {  // free, under its reaction
      const double g = viscous ? body.viscous[d.slot] : 0.0, before = body.v[d.slot],
                   after = keep * before + push * (body.f[d.slot] + g + d.reaction) / d.mass;
      k.energy += 0.5 * d.mass * before * after;
      k.damping += 0.25 * damping_rate_ * dt_ * d.mass * (before + after) * before;
      k.viscosity -= 0.5 * dt_ * g * before;
    }
  }
  for (const RigidBody& body : rigid_) {
    k.energy += 0.5 * body.product(keep, push, 0, 1);
    k.damping += 0.25 * damping_rate_ * dt_ * body.product(keep, push, 1, 1);
  }
  return k;
}

double March::energy_of_half_a_kick() const {
  const auto [keep, push] = leap(dt_);
  double all = 0;
  for (const MovingBody& body : bodies_) {
    const bool viscous = !body.viscous.empty();
    all += sum_of_entries(body.v.size(), [&, keep = keep, push = push](std::size_t begin, std::size_t end) {
      double s = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const double w = body.inverse_mass[i];
        if (w == 0) continue;
        const double kick = (keep - 1) * body.v[i] +
                            push * w * (viscous ? body.f[i] + body.viscous[i] : body.f[i]);
        s += 0.125 * kick * kick / w;
      }
      return s;
    });
    for (const MovingBody::Driven& d : body.driven) {
      const double kick = (keep - 1) * body.v[d.slot] +
                          push * (body.f[d.slot] + (viscous ? body.viscous[d.slot] : 0.0) + d.reaction) /
                              d.mass;
      all += 0.125 * d.mass * kick * kick;
    }
  }
  for (const RigidBody& body : rigid_) all += 0.125 * body.energy_of_kick(keep, push);
  return all;
}

Ledger March::ledger() const {
  Ledger l;
  const Kinetic k = kinetic();
  l.kinetic = std::max(0.0, k.energy + energy_of_half_a_kick());  // a sum of squares: below zero is round-off
  l.discrete = k.energy - l.kinetic - (initial_energy_ - initial_whole_);
  for (const MovingBody& body : bodies_) {
    const Energies held = body.discretization->energies(body.u.data());
    l.strain += held.strain;
    l.hourglass += held.hourglass;
    l.plastic += held.plastic;
  }
  for (const ContactPair& contact : contacts_) {
    l.contact += contact.stored();
    l.friction += contact.friction_loss();
  }
  l.contact += ties_.taken();
  l.external = external_work_;
  l.damping = damping_loss_ + k.damping - start_damping_;
  l.viscosity = viscous_loss_ + k.viscosity - start_viscosity_;
  l.initial = initial_whole_;
  return l;
}

}  // namespace femsph
