#include "model/motion/conservation.hpp"

#include <algorithm>
#include <cmath>

#include "model/motion/reactions.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

Conservation::Conservation(const March& march) {
  free_ = !pushed_from_outside(march.scene());
  double mass = 0;
  const auto add = [&](const Point& x, double m) {
    mass += m;
    centre_ = centre_ + m * x;
  };
  for (const MovingBody& body : march.bodies())
    for (std::size_t i = 0; i < body.discretization->layout().points; ++i)
      add(body.discretization->position(i), body.discretization->mass()[i]);
  for (const RigidBody& body : march.rigid_bodies()) add(body.start, body.mass);
  centre_ = (1 / mass) * centre_;
}

void Conservation::sample_free(const March& march) {
  std::array<Point, 2> now{};
  std::array<double, 2> size{};
  const auto add = [&](const Point& x, const Point& v, double m) {
    const Point arm = x - centre_;
    now[0] = now[0] + m * v;
    now[1] = now[1] + m * cross(arm, v);
    size[0] += m * norm(v);
    size[1] += m * norm(arm) * norm(v);
  };
  for (const MovingBody& body : march.bodies()) {
    const Layout& at = body.discretization->layout();
    for (std::size_t i = 0; i < at.points; ++i) {
      Point v{};
      for (int c = 0; c < at.dim; ++c) v[c] = march.velocity(body, at.at(i, c));
      add(place_of(march, body, i), v, body.discretization->mass()[i]);
    }
  }
  for (const RigidBody& body : march.rigid_bodies()) {
    add(body.centre(), march.velocity(body), body.mass);
    now[1] = now[1] + march.spin(body);
    size[1] += norm(body.spin);
  }
  if (!started_) start_ = now;
  started_ = true;
  for (int k = 0; k < 2; ++k) {
    change_[k] = std::max(change_[k], norm(now[k] - start_[k]));
    scale_[k] = std::max(scale_[k], size[k]);
  }
}

void Conservation::sample(const March& march) {
  const Ledger l = march.ledger();
  imbalance_ = std::max(imbalance_, std::abs(l.imbalance()));
  energy_ = std::max({energy_, l.stored(), l.initial + std::abs(l.external)});
  hourglass_ = std::max(hourglass_, l.hourglass);
  internal_ = std::max(internal_, l.strain + l.hourglass + l.plastic);
  if (free_)
    sample_free(march);
  else
    samples_.push_back({l.strain + l.hourglass, march.force_imbalance(), march.moment_imbalance()});
}

Drift Conservation::drift() const {
  Drift d;
  if (energy_ > 0) d.energy = imbalance_ / energy_;
  if (internal_ > 0) d.hourglass = hourglass_ / internal_;
  if (scale_[0] > 0) d.momentum = change_[0] / scale_[0];
  if (scale_[1] > 0) d.angular_momentum = change_[1] / scale_[1];
  for (const Sample& s : samples_) {
    if (s.energy < 1e-6 * energy_) continue;
    d.momentum = std::max(d.momentum, s.force);
    d.angular_momentum = std::max(d.angular_momentum, s.moment);
  }
  return d;
}

}  // namespace femsph
