// Results at a whole step: velocities, reactions, and whether the internal forces sum to zero.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/motion/march.hpp"

namespace femsph {

const MovingBody& March::body(std::size_t index) const {
  return *std::find_if(motion_.bodies.begin(), motion_.bodies.end(), [&](const MovingBody& body) {
    return body.index == index;
  });
}

std::vector<Point> March::contact_forces() const {
  std::vector<Point> forces(motion_.scene.contacts.size());
  for (const Effect* effect : effects_.all()) effect->contact_forces(forces);
  return forces;
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
  const auto [keep_now, push_now] = motion_.leap(motion_.dt);
  const double keep = keep_now, push = push_now;  // Clang 14 captures no structured binding
  const double force = body.viscous.empty() ? body.f[slot] : body.f[slot] + body.viscous[slot];
  return 0.5 * ((1 + keep) * body.v[slot] + push * body.inverse_mass[slot] * force);
}

Point March::velocity(const RigidBody& body) const {
  return body.half_way(motion_.leap(motion_.dt).keep, motion_.leap(motion_.dt).push)[0];
}
Point March::spin(const RigidBody& body) const {
  return body.half_way(motion_.leap(motion_.dt).keep, motion_.leap(motion_.dt).push)[1];
}

/// Calls take(position, force) with the internal and viscous force of each point.
template <class Take>
void March::internal_forces(const MovingBody& body, Take&& take) const {
  if (body.internal.empty()) throw std::logic_error("internal forces are kept at samples only");
  const Layout& at = body.discretization->layout();
  for (std::size_t i = 0; i < at.points; ++i) {
    Point p{}, x = body.discretization->position(i);
    for (int c = 0; c < at.dim; ++c) {
      p[c] = body.internal[at.at(i, c)];
      x[c] += motion_.scene.large_motion ? body.u[at.at(i, c)] : 0.0;
    }
    take(x, p);
  }
}

double March::force_imbalance() const {
  double worst = 0;
  for (const MovingBody& body : motion_.bodies) {
    Point sum{}, size{};
    const std::array<bool, 3> mirrored = motion_.scene.mirrored_axes(body.index);
    internal_forces(body, [&](const Point&, const Point& f) {
      for (int c = 0; c < 3; ++c) sum[c] += mirrored[c] ? 0.0 : f[c], size[c] += std::abs(f[c]);
    });
    const double all = size[0] + size[1] + size[2];
    if (all > 0) worst = std::max(worst, (std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2])) / all);
  }
  return worst;
}

double March::moment_imbalance() const {
  double worst = 0;
  for (const MovingBody& body : motion_.bodies) {
    Point sum{};
    double all = 0;
    const std::array<bool, 3> mirrored = motion_.scene.mirrored_axes(body.index);
    internal_forces(body, [&](const Point& x, const Point& f) {
      for (int c = 0; c < 3; ++c) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        if (mirrored[a] || mirrored[b]) continue;
        sum[c] += x[a] * f[b] - x[b] * f[a];
        all += std::abs(x[a] * f[b]) + std::abs(x[b] * f[a]);
      }
    });
    if (all > 0) worst = std::max(worst, (std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2])) / all);
  }
  return worst;
}

}  // namespace femsph
