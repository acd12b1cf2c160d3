#include "model/motion/balance.hpp"

#include <cmath>

#include "model/numerics/vectors.hpp"

namespace femsph {
namespace {

/// Sums of forces and of their moments about the origin, and of their magnitudes.
struct Sum {
  Point force{}, moment{};
  double size = 0, moment_size = 0;
  void add(const Point& x, const Point& f, double sign) {
    force = force + sign * f;
    moment = moment + sign * cross(x, f);
    size += norm(f);
    moment_size += norm(x) * norm(f);
  }
  void add_couple(const Point& m, double sign) {
    moment = moment + sign * m;
    moment_size += norm(m);
  }
};

/// Mass times acceleration, and the damping force, of every point: together the force that remains on it.
void add_inertia(const March& march, const MovingBody& body, Sum& sum) {
  const Layout& at = body.discretization->layout();
  for (std::size_t i = 0; i < at.points; ++i) {
    Point f{};
    for (int c = 0; c < at.dim; ++c) {
      const std::size_t slot = at.at(i, c);
      if (body.inverse_mass[slot] > 0)
        f[c] = body.viscous.empty() ? body.f[slot] : body.f[slot] + body.viscous[slot];
    }
    sum.add(place_of(march, body, i), f, 1);
  }
  for (const MovingBody::Driven& d : body.driven) {
    const auto [point, c] = component_of(at, d.slot);
    Point f{};
    f[c] = body.f[d.slot] + (body.viscous.empty() ? 0.0 : body.viscous[d.slot]) + d.reaction;
    sum.add(place_of(march, body, point), f, 1);
  }
}

void add_outside_forces(const March& march, const MovingBody& body, Sum& sum) {
  for (const Effect* effect : march.effects().all()) {
    effect->each_force(march.motion(), body, [&](std::size_t point, const Point& f) {
      sum.add(place_of(march, body, point), f, -1);
    });
    // Corrected to the total of the scene, where the forces on points do not sum to it.
    sum.force = sum.force + effect->excess_force(march.motion(), body);
  }
}

void add_rigid(const March& march, const RigidBody& body, Sum& sum) {
  const Point x = body.centre();
  Point left{}, held{}, turning{};
  for (int c = 0; c < 3; ++c) {
    (body.held[c] ? held : left)[c] = body.force[c];
    if (!body.held_turn[c]) turning[c] = body.moment[c];
  }
  sum.add(x, left, 1);
  sum.add(x, held, 1);  // the reaction is its opposite
  sum.add_couple(turning, 1);
  sum.add_couple(body.moment - turning, 1);
  sum.add(x, body.mass * body.gravity, -1);
  for (const Effect* effect : march.effects().all())
    effect->each_force_on_rigid(march.motion(), body, [&](const Point& f) { sum.add(x, f, -1); });
}

}  // namespace

Momentum momentum(const March& march) {
  Momentum p;
  for (const MovingBody& body : march.bodies()) {
    const Layout& at = body.discretization->layout();
    const std::span<const double> mass = body.discretization->mass();
    for (std::size_t i = 0; i < at.points; ++i) {
      Point mv{};
      for (int c = 0; c < at.dim; ++c) mv[c] = mass[i] * march.velocity(body, at.at(i, c));
      p.linear = p.linear + mv;
      p.angular = p.angular + cross(place_of(march, body, i), mv);
    }
  }
  for (const RigidBody& body : march.rigid_bodies()) {
    const Point mv = body.mass * march.velocity(body);
    p.linear = p.linear + mv;
    p.angular = p.angular + cross(body.centre(), mv) + march.spin(body);
  }
  return p;
}

Balance balance(const March& march, const std::vector<Reaction>& reactions) {
  const Scene& scene = march.scene();
  Sum sum;
  for (const MovingBody& body : march.bodies()) {
    add_inertia(march, body, sum);
    add_outside_forces(march, body, sum);
    for (const Effect* effect : march.effects().all())
      effect->each_reaction(march.motion(), body, [&](std::size_t slot, double reaction) {
        const auto [point, c] = component_of(body.discretization->layout(), slot);
        Point f{};
        f[c] = reaction;
        sum.add(place_of(march, body, point), f, -1);
      });
  }
  for (const Reaction& reaction : reactions)
    for (const auto& [x, f] : reaction.forces(march)) sum.add(x, f, -1);
  for (const RigidBody& body : march.rigid_bodies()) add_rigid(march, body, sum);
  const std::array<bool, 3> mirrored = scene.mirrored_axes();
  Point force = sum.force, moment = sum.moment;
  for (int c = 0; c < 3; ++c) {
    if (mirrored[c]) force[c] = 0;
    if (mirrored[(c + 1) % 3] || mirrored[(c + 2) % 3] || (scene.dim() == 2 && c < 2)) moment[c] = 0;
  }
  Balance out;
  if (sum.size > 0) out.force = norm(force) / sum.size;
  const bool apart = !scene.large_motion &&
                     (march.effects().bodies_may_part() || !march.rigid_bodies().empty());
  if (sum.moment_size > 0 && !apart) out.moment = norm(moment) / sum.moment_size;
  return out;
}

}  // namespace femsph
