#include "model/motion/bodies/rigid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/numerics/vectors.hpp"

namespace femsph {

RigidBody::RigidBody(const Scene& scene, std::size_t i)
    : name(scene.bodies[i].name),
      index(i),
      dim(scene.dim()),
      shape(scene.bodies[i].shape),
      mass(scene.bodies[i].mass) {
  const Point lower = shape->lower(), upper = shape->upper();
  start = 0.5 * (lower + upper);
  inertia = form().inertia(mass);
  if (dim == 2) held[2] = held_turn[0] = held_turn[1] = true;
  for (const Support& support : scene.supports) {
    if (support.place.body != index) continue;
    for (int c = 0; c < 3; ++c) {
      held[c] = held[c] || support.fixed[c];
      held_turn[c] = held_turn[c] || support.fixed_turn[c];
    }
  }
}

Point RigidBody::rate_of(const Point& s) const {
  Point w{};
  for (int a = 0; a < 3; ++a)
    if (inertia[a] > 0) w = w + (dot(axes[a], s) / inertia[a]) * axes[a];
  for (int c = 0; c < 3; ++c)
    if (held_turn[c]) w[c] = 0;
  return w;
}

Point RigidBody::velocity_at(const Point& x) const { return velocity + cross(rate(), x - centre()); }

void RigidBody::push(const Point& x, const Point& f) {
  force = force + f;
  moment = moment + cross(x - centre(), f);
}

double RigidBody::reach() const { return 0.5 * norm(shape->upper() - shape->lower()); }

double RigidBody::surface() const { return form().surface(); }

double RigidBody::least_mass() const {
  double inverse = held[0] && held[1] && held[2] ? 0.0 : 1 / mass;
  double turning = 0;
  for (int c = 0; c < 3; ++c)
    if (!held_turn[c]) turning = std::max(turning, 1 / inertia[c]);
  inverse += reach() * reach() * turning;
  return inverse > 0 ? 1 / inverse : std::numeric_limits<double>::infinity();
}

int RigidBody::sides() const { return form().side_count(); }

Projection RigidBody::project(int side, const Point& x) const {
  const SideProjection on = form().project(side, x - centre(), axes);
  Projection s;
  s.normal = on.normal, s.gap = on.gap, s.beyond = on.beyond;
  s.foot = x - s.gap * s.normal;
  return s;
}

/// The reader of scenes refuses other shapes; a scene that is made by code may have one.
const RigidForm& RigidBody::form() const {
  if (const RigidForm* form = shape->rigid()) return *form;
  throw Refusal("a rigid body cannot be a " + shape->describe());
}

void RigidBody::begin_forces() {
  force = mass * gravity;
  moment = {};
}

void RigidBody::kick(double keep, double push) {
  for (int c = 0; c < 3; ++c) {
    velocity[c] = held[c] ? 0 : keep * velocity[c] + push * force[c] / mass;
    spin[c] = held_turn[c] ? 0 : keep * spin[c] + push * moment[c];
  }
}

void RigidBody::start_from(double keep, double push) {
  for (int c = 0; c < 3; ++c) {
    velocity[c] = held[c] ? 0 : (2 * velocity[c] - push * force[c] / mass) / (1 + keep);
    spin[c] = held_turn[c] ? 0 : (2 * spin[c] - push * moment[c]) / (1 + keep);
  }
}

std::array<Point, 2> RigidBody::half_way(double keep, double push) const {
  std::array<Point, 2> now{velocity, spin};
  for (int c = 0; c < 3; ++c) {
    now[0][c] = held[c] ? 0 : 0.5 * ((1 + keep) * velocity[c] + push * force[c] / mass);
    now[1][c] = held_turn[c] ? 0 : 0.5 * ((1 + keep) * spin[c] + push * moment[c]);
  }
  return now;
}

double RigidBody::energy_of_kick(double keep, double push) const {
  Point v{}, s{};
  for (int c = 0; c < 3; ++c) {
    v[c] = held[c] ? 0 : (keep - 1) * velocity[c] + push * force[c] / mass;
    s[c] = held_turn[c] ? 0 : (keep - 1) * spin[c] + push * moment[c];
  }
  return mass * dot(v, v) + dot(rate_of(s), s);
}

namespace {

/// x rotated about w by |w| rad (Rodrigues' formula).
Point turned(const Point& x, const Point& w) {
  const double angle = norm(w);
  if (angle == 0) return x;
  const Point n = (1 / angle) * w;
  return std::cos(angle) * x + std::sin(angle) * cross(n, x) + ((1 - std::cos(angle)) * dot(n, x)) * n;
}

}  // namespace

void RigidBody::drift(double dt) {
  moved = moved + dt * velocity;
  if (dot(spin, spin) == 0) return;
  // The inertia tensor rotates with the body: the angular velocity is taken at the middle of the step.
  const std::array<Point, 3> before = axes;
  const Point first = rate();
  for (Point& axis : axes) axis = turned(axis, 0.5 * dt * first);
  const Point middle = rate();
  for (int a = 0; a < 3; ++a) axes[a] = turned(before[a], dt * middle);
  angle += dt * middle[2];
}

double RigidBody::product(double keep, double push, double before, double after) const {
  Point v{}, s{};
  for (int c = 0; c < 3; ++c) {
    v[c] = held[c] ? 0 : before * velocity[c] + after * (keep * velocity[c] + push * force[c] / mass);
    s[c] = held_turn[c] ? 0 : before * spin[c] + after * (keep * spin[c] + push * moment[c]);
  }
  return mass * dot(velocity, v) + dot(rate(), s);
}

void RigidBody::state(Archive& archive) {
  archive("moved", moved);
  archive("velocity", velocity);
  archive("spin", spin);
  for (int a = 0; a < 3; ++a) archive("axis_" + std::to_string(a), axes[a]);
  archive("angle", angle);
}

}  // namespace femsph
