// The energies of a run, and their balance.

#include <algorithm>
#include <numeric>

#include "model/motion/entries.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/simd.hpp"

namespace femsph {

// With v+ - v- = dt (f/m - c vbar) + dt g/m (f the forces, g the viscous force, c the damping rate, vbar =
// (v- + v+)/2), the energy 1/2 v- . M v+ changes from step n to n + 1 by 1/2 dt v(n+1/2) . (f(n) + f(n+1)),
// minus losses to damping and viscosity of the same form. So the half of the losses at step n that contains
// v- belongs to the interval before it, the half with v+ to the one after it.
March::Kinetic March::kinetic() const {
  Kinetic k;
  const auto [keep_now, push_now] = motion_.leap(motion_.dt);
  const double keep = keep_now, push = push_now;  // Clang 14 captures no structured binding
  for (const MovingBody& body : motion_.bodies) {
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
          double s[lanes] = {};  // independent sums: no addition waits for the one before
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
    if (motion_.damping_rate > 0)
      k.damping += 0.25 * motion_.damping_rate * motion_.dt *
                   sum([&](std::size_t i, double before, double after) {
                     return (before + after) * before / body.inverse_mass[i];
                   });
    if (viscous)
      k.viscosity -= 0.5 * motion_.dt *
                     sum([&](std::size_t i, double before, double) { return body.viscous[i] * before; });
    for (const MovingBody::Driven& d : body.driven) {  // a free component under its reaction
      const double g = viscous ? body.viscous[d.slot] : 0.0, before = body.v[d.slot],
                   after = keep * before + push * (body.f[d.slot] + g + d.reaction) / d.mass;
      k.energy += 0.5 * d.mass * before * after;
      k.damping += 0.25 * motion_.damping_rate * motion_.dt * d.mass * (before + after) * before;
      k.viscosity -= 0.5 * motion_.dt * g * before;
    }
  }
  for (const RigidBody& body : motion_.rigid) {
    k.energy += 0.5 * body.product(keep, push, 0, 1);
    k.damping += 0.25 * motion_.damping_rate * motion_.dt * body.product(keep, push, 1, 1);
  }
  return k;
}

double March::energy_of_half_a_kick() const {
  const auto [keep_now, push_now] = motion_.leap(motion_.dt);
  const double keep = keep_now, push = push_now;  // Clang 14 captures no structured binding
  double all = 0;
  for (const MovingBody& body : motion_.bodies) {
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
  for (const RigidBody& body : motion_.rigid) all += 0.125 * body.energy_of_kick(keep, push);
  return all;
}

Ledger March::ledger() const {
  Ledger l;
  const Kinetic k = kinetic();
  l.kinetic = std::max(
      0.0, k.energy + energy_of_half_a_kick());  // a sum of squares; negative only by round-off
  l.discrete = k.energy - l.kinetic - (initial_energy_ - initial_whole_);
  for (const MovingBody& body : motion_.bodies) {
    const Energies held = body.discretization->energies(body.u.data());
    l.strain += held.strain;
    l.hourglass += held.hourglass;
    l.plastic += held.plastic;
  }
  l.external = external_work_;
  l.damping = damping_loss_ + k.damping - start_damping_;
  l.viscosity = viscous_loss_ + k.viscosity - start_viscosity_;
  l.initial = initial_whole_;
  for (const Effect* effect : effects_.all()) effect->add_energies(l);
  return l;
}

}  // namespace femsph
