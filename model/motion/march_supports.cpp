// Supports that hold every point of a place: which components they hold, which of them move, and what that
// takes.
//
// A driven component goes from v- to v+ = V h(t(n+1/2)), whatever acts on it. As of any other component m (v+
// - keep v-) / push = f + R, with R the reaction: what accelerates the point's own mass (and overcomes its
// damping) is in it, and the sum of R over the steps is the change of momentum of the whole body, exactly.
// Over a step the reaction does the work 1/2 dt v(n+1/2) (R(n) + R(n+1)), which closes the ledger (see
// kinetic()).
//
// At t = 0 the point has the velocity v(0) that [[initial]] gives its body, like every other: v(-1/2) = 2
// v(0) - v(+1/2). If the support then moves at another speed the reaction of that instant is an impulse, m
// (v(+1/2) - v(0)) in the half step before t = 0 and as much again in the one after: by the trapezoidal rule,
// in which the first row of a history counts for half a step, it is m (v(+1/2) - v(0)).

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/march.hpp"

namespace femsph {

namespace {

/// Whether two that hold the same component want the same of it.
bool agree(const Support& a, const Support& b, int c) {
  if (a.velocity[c] != b.velocity[c]) return false;
  return a.velocity[c] == 0 || (a.history.time == b.history.time && a.history.factor == b.history.factor);
}

std::string wish(const Support& support, int c) {
  return support.velocity[c] == 0
             ? "holds it at rest"
             : fmt::format("moves it at {:g} m/s{}", support.velocity[c],
                           support.history.time.size() > 1 ? " times its history" : "");
}

}  // namespace

void March::hold_and_drive(MovingBody& body, std::size_t index) {
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  const std::vector<Support> holds = scene_.holds();
  for (std::size_t h = 0; h < holds.size(); ++h) {
    if (holds[h].place.body != index || holds[h].mean) continue;
    for (const Weight& w : points_of(body, holds[h].place, "support"))
      for (int c = 0; c < at.dim; ++c)
        if (holds[h].fixed[c]) body.held.push_back({w.point, c, h});
  }
  std::sort(body.held.begin(), body.held.end());
  for (std::size_t k = 0; k < body.held.size(); ++k) {
    const auto [point, c, h] = body.held[k];
    const std::size_t slot = at.at(point, c);
    if (k > 0 && body.held[k - 1].point == point && body.held[k - 1].component == c) {
      const Support &one = holds[body.held[k - 1].hold], &other = holds[h];
      if (agree(one, other, c)) continue;
      const Point x = d.position(point);
      throw InputError(
          scene_.file,
          {Fault{
              other.place.source.line, other.place.source.column,
              fmt::format("this support {} along {} and the one at {}:{}:{} {}: both have the point ({:.6g}, "
                          "{:.6g}, {:.6g}) m of body \"{}\"; "
                          "expected supports that agree there, or places that do not meet (see \"within\")",
                          wish(other, c), "xyz"[c], scene_.file, one.place.source.line,
                          one.place.source.column, wish(one, c), x[0], x[1], x[2], body.name)}});
    }
    double start = 0;
    for (const InitialVelocity& initial : scene_.initial_velocities)
      if (initial.body == index) start += initial.at(d.position(point))[c];
    body.inverse_mass[slot] = 0;
    if (holds[h].velocity[c] == 0 && start == 0) continue;
    body.driven.push_back({slot, holds[h].velocity[c], h, d.mass()[point], start});
    if (!body.mass.empty()) body.mass[slot] = 0;  // drive() counts its damping
  }
  std::sort(
      body.driven.begin(), body.driven.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
}

void March::find_reactions() {
  const Leap over = leap(0.5 * (dt_ + next_dt_));
  const double middle = time() + 0.5 * next_dt_;
  for (MovingBody& body : bodies_)
    for (MovingBody::Driven& d : body.driven) {
      d.after = d.velocity == 0 ? 0.0 : d.velocity * scene_.supports[d.support].history.at(middle);
      if (step_ == 0) body.v[d.slot] = 2 * d.start - d.after;
      d.before = body.v[d.slot];
      const double others = body.f[d.slot] + (body.viscous.empty() ? 0.0 : body.viscous[d.slot]);
      d.reaction = d.mass * (d.after - over.keep * d.before) / over.push - others;
    }
}

void March::drive(MovingBody& body) {
  for (const MovingBody::Driven& d : body.driven) {
    double& v = body.v[d.slot];  // from the kick, which has moved the point by dt v
    const double mean = 0.5 * (d.before + d.after);
    damping_loss_ += damping_rate_ * dt_ * d.mass * mean * mean;
    if (!body.viscous.empty())
      viscous_loss_ -= dt_ * body.viscous[d.slot] *
                       (mean - 0.5 * (d.before + v));  // the kick has counted the latter
    body.u[d.slot] += dt_ * (d.after - v);
    v = d.after;
  }
}

/// The first half is counted after the drift, the second with the next forces.
void March::count_driven_work() {
  const double done = external_work_;
  for (const MovingBody& body : bodies_)
    for (const MovingBody::Driven& d : body.driven) external_work_ += 0.5 * dt_ * body.v[d.slot] * d.reaction;
  external_passed_ += std::abs(external_work_ - done);
}

namespace {

const MovingBody::Driven* driven_at(const MovingBody& body, std::size_t slot) {
  const auto found = std::lower_bound(body.driven.begin(), body.driven.end(), slot,
                                      [](const MovingBody::Driven& d, std::size_t s) { return d.slot < s; });
  return found != body.driven.end() && found->slot == slot ? &*found : nullptr;
}

}  // namespace

double March::reaction(const MovingBody& body, std::size_t slot) const {
  if (const auto* driven = driven_at(body, slot)) return driven->reaction;
  return -body.f[slot] - (body.viscous.empty() ? 0.0 : body.viscous[slot]);
}

double March::velocity(const MovingBody& body, std::size_t slot) const {
  if (body.inverse_mass[slot] == 0) {
    const auto* driven = driven_at(body, slot);
    return driven ? 0.5 * (body.v[slot] + driven->after) : 0.0;
  }
  const auto [keep, push] = leap(dt_);
  const double force = body.viscous.empty() ? body.f[slot] : body.f[slot] + body.viscous[slot];
  return 0.5 * ((1 + keep) * body.v[slot] + push * body.inverse_mass[slot] * force);
}

Point March::velocity(const RigidBody& body) const {
  return body.half_way(leap(dt_).keep, leap(dt_).push)[0];
}
Point March::spin(const RigidBody& body) const { return body.half_way(leap(dt_).keep, leap(dt_).push)[1]; }

}  // namespace femsph
