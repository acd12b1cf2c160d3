// The search for the facets near each point. It is repeated when something may have moved by more than the
// skin since the last search.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/bodies/motion.hpp"
#include "model/motion/bodies/overlap.hpp"
#include "model/motion/effects/contact_pair.hpp"
#include "model/numerics/box_grid.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

using Bounds = BoxGrid::Box;

Bounds box_of(const Point* points, std::size_t n, double margin) {
  Bounds box{points[0], points[0]};
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) {
      box.lower[c] = std::min(box.lower[c], points[i][c]);
      box.upper[c] = std::max(box.upper[c], points[i][c]);
    }
  for (int c = 0; c < 3; ++c) box.lower[c] -= margin, box.upper[c] += margin;
  return box;
}

bool overlap(const Bounds& a, const Bounds& b) {
  for (int c = 0; c < 3; ++c)
    if (a.lower[c] > b.upper[c] || b.lower[c] > a.upper[c]) return false;
  return true;
}

bool holds(const Bounds& box, const Point& p) { return overlap(box, {p, p}); }

}  // namespace

void ContactPair::search(Bodies bodies, long step, double dt) {
  double fastest = 0;
  for (Side& side : sides_) {
    if (side.party.rigid) {
      const RigidBody& r = bodies.rigid[side.party.index];
      fastest += norm(r.velocity) + r.reach() * norm(r.rate());
      continue;
    }
    side.surface[0].move_all(bodies.moving[side.party.index]);
    side.surface[0].measure();
    // A wave may accelerate a point before the next search, so no body counts as slower than c / 200.
    fastest += std::max(side.surface[0].fastest(bodies.moving[side.party.index]), wave_speed_ / 200);
  }
  if (step == 0) refuse_overlap(bodies);
  for (Pass& pass : passes_) search(bodies, pass);
  mark_active();
  const double steps = skin_ / (2 * fastest * dt);  // infinite if dt is 0
  next_search_ = step + (std::isfinite(steps) ? std::max(1L, long(steps)) : 1L);
}

void ContactPair::search(Bodies bodies, Pass& pass) {
  pass.points.clear();
  pass.pieces.clear();
  pass.begin.assign(1, 0);
  const Surface& own = sides_[pass.from].surface[0];
  const Side& other = sides_[1 - pass.from];
  const double reach = skin_ + depth_;
  // Pieces within reach of the points' box, and a grid over them.
  std::vector<Bounds> boxes;
  std::vector<int> pieces;
  const Bounds all = box_of(own.now.data(), own.now.size(), reach);
  if (!other.party.rigid) {
    const Surface& surface = other.surface[0];
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
      const std::array<Point, 4> corners = surface.corners(surface.facets[f]);
      const Bounds box = box_of(corners.data(), std::size_t(2 * (surface.dim - 1)), reach);
      if (!overlap(box, all)) continue;
      boxes.push_back(box);
      pieces.push_back(int(f));
    }
    if (boxes.empty()) return;
  }
  const BoxGrid grid(boxes);
  Bounds near = all;
  if (!boxes.empty()) {
    near = boxes[0];
    for (const Bounds& box : boxes)
      for (int c = 0; c < 3; ++c) {
        near.lower[c] = std::min(near.lower[c], box.lower[c]);
        near.upper[c] = std::max(near.upper[c], box.upper[c]);
      }
  }
  for (std::size_t p = 0; p < own.now.size(); ++p) {
    std::vector<int>& list = pass.pieces;
    const std::size_t first = list.size();
    const auto take = [&](int piece) {
      const Projection s = project(bodies, pass, piece, own.now[p]);
      if (std::abs(s.gap) <= reach && s.beyond <= skin_ + overhang_ && dot(own.area[p], s.normal) < 0)
        list.push_back(piece);
    };
    if (!holds(near, own.now[p])) {
      pass.histories[p] = {};
      continue;
    }
    if (other.party.rigid) {
      for (int side = 0; side < bodies.rigid[other.party.index].sides(); ++side) take(side);
    } else {
      grid.any_near(own.now[p], 0, [&](int b) {
        if (holds(boxes[std::size_t(b)], own.now[p])) take(pieces[std::size_t(b)]);
        return false;
      });
    }
    if (list.size() == first) {
      pass.histories[p] = {};
      continue;
    }
    pass.points.push_back(p);
    pass.begin.push_back(int(list.size()));
  }
}

void ContactPair::mark_active() {
  for (int s = 0; s < 2; ++s) {
    if (sides_[s].party.rigid) continue;
    Surface& surface = sides_[s].surface[0];
    for (const std::size_t p : surface.active) surface.force[p] = {};
    std::vector<char> used(surface.point.size(), 0);
    for (const Pass& pass : passes_) {
      if (pass.from == s)
        for (const std::size_t p : pass.points) used[p] = 1;
      else
        for (const int piece : pass.pieces)
          for (int c = 0; c < 2 * (surface.dim - 1); ++c)
            used[surface.facets[std::size_t(piece)].points[c]] = 1;
      if (pass.from == s) continue;
      for (const std::size_t k : pass.points)  // pieces that points have kept from before
        if (pass.histories[k].piece >= 0)
          for (int c = 0; c < 2 * (surface.dim - 1); ++c)
            used[surface.facets[std::size_t(pass.histories[k].piece)].points[c]] = 1;
    }
    surface.active.clear();
    for (std::size_t p = 0; p < used.size(); ++p)
      if (used[p]) surface.active.push_back(p);
  }
}

/// The search for near facets finds only shallow overlaps; this finds all.
void ContactPair::refuse_overlap(Bodies bodies) const {
  const double tolerance = 1e-6 * spacing_;
  const int first = sides_[0].party.rigid ? 1 : 0;  // one that deforms
  const Surface& surface = sides_[first].surface[0];
  const Side& other = sides_[1 - first];
  const auto found = other.party.rigid
                         ? overlap_of(surface, *bodies.rigid[other.party.index].shape, tolerance)
                         : overlap_of(surface, other.surface[0], tolerance);
  if (!found) return;
  const auto is_round = [&](std::size_t body) {
    const Shape& shape = *scene_.bodies[body].shape;
    return !shape.cells() && !shape.is_box();
  };
  std::string what = found->depth > 0
                         ? fmt::format("the bodies overlap by {:.4g} mm at the start", 1e3 * found->depth)
                         : "the bodies cross each other at the start";
  what += "; expected them apart or touching";
  if (found->depth > 0 && found->depth < 0.05 * spacing_ &&
      (is_round(contact_.between[0]) || is_round(contact_.between[1])))
    what +=
        " (round bodies are straight between their points: a finer spacing brings them nearer to their "
        "shapes)";
  fail(what, found->at);
}

}  // namespace femsph
