#include "model/motion/reactions.hpp"

#include <algorithm>

#include "model/numerics/vectors.hpp"

namespace femsph {

Point place_of(const March& march, const MovingBody& body, std::size_t point) {
  Point x = body.discretization->position(point);
  if (!march.scene().large_motion) return x;
  const Layout& at = body.discretization->layout();
  for (int c = 0; c < at.dim; ++c) x[c] += body.u[at.at(point, c)];
  return x;
}

std::vector<std::pair<Point, Point>> Reaction::forces(const March& march) const {
  std::vector<std::pair<Point, Point>> out;
  out.reserve(parts.size());
  for (const Part& part : parts) {
    Point f{};
    f[part.component] = part.share *
                        march.reaction(*body, body->discretization->layout().at(part.point, part.component));
    out.emplace_back(place_of(march, *body, part.point), f);
  }
  return out;
}

Point Reaction::centroid(const March& march) const {
  Point x{};
  for (const Weight& w : area) x = x + w.weight * place_of(march, *body, w.point);
  return x;
}

std::array<Point, 2> Reaction::resultant(const March& march) const {
  const Point middle = centroid(march);
  std::array<Point, 2> sum{};
  for (const auto& [x, f] : forces(march)) {
    sum[0] = sum[0] + f;
    sum[1] = sum[1] + cross(x - middle, f);
  }
  return sum;
}

namespace {

Reaction reaction_of(const March& march, const Place& place, std::size_t hold) {
  const MovingBody& body = march.body(place.body);
  Reaction out{&body, {}, body.discretization->points_of(place)};
  for (auto first = body.held.begin(); first != body.held.end();) {
    const auto same = [&](const MovingBody::Held& h) {
      return h.point == first->point && h.component == first->component;
    };
    const auto end = std::find_if_not(first, body.held.end(), same);
    for (auto held = first; held != end; ++held)
      if (held->hold == hold) out.parts.push_back({held->point, held->component, 1.0 / double(end - first)});
    first = end;
  }
  return out;
}

}  // namespace

Reaction reaction_of(const March& march, std::size_t hold) {
  return reaction_of(march, march.scene().holds()[hold].place, hold);
}

std::vector<Reaction> all_reactions(const March& march) {
  std::vector<Reaction> out;
  const std::vector<Support> holds = march.scene().holds();
  for (std::size_t h = 0; h < holds.size(); ++h)
    if (!holds[h].mean && !march.scene().bodies[holds[h].place.body].rigid)
      out.push_back(reaction_of(march, holds[h].place, h));
  return out;
}

}  // namespace femsph
