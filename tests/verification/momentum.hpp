#pragma once
// Momentum of everything in a march.

#include "model/motion/march.hpp"

namespace femsph::test {

struct Momentum {
  Point linear{}, angular{};
  double kinetic = 0;
};

/// sum m v and sum x x m v: the leap-frog keeps the second with x(n) and v(n - 1/2), as x(n) x v = (x(n-1) +
/// dt v) x v.
inline Momentum momentum(const March& march) {
  Momentum all;
  const auto add = [&](const Point& x, double m, const Point& v) {
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      all.linear[c] += m * v[c];
      all.angular[c] += m * (x[a] * v[b] - x[b] * v[a]);
    }
  };
  for (const MovingBody& body : march.bodies()) {
    const Discretization& d = *body.discretization;
    for (std::size_t i = 0; i < d.layout().points; ++i) {
      Point x = d.position(i), v{};
      for (int c = 0; c < d.layout().dim; ++c)
        x[c] += body.u[d.layout().at(i, c)], v[c] = body.v[d.layout().at(i, c)];
      add(x, d.mass()[i], v);
    }
  }
  for (const RigidBody& body : march.rigid_bodies()) {
    add(body.centre(), body.mass, body.velocity);
    for (int c = 0; c < 3; ++c) all.angular[c] += body.spin[c];
  }
  return all;
}

}  // namespace femsph::test
