#pragma once
// What supports exert on their bodies.
//
// A component that several supports (or symmetry planes) hold counts in each with an equal share, so that the
// sum over all of them is what holds the body; one that only one of them holds counts there whole. Moments
// are taken about the centroid of the support's place: the mean of its points with their shares of the area,
// moving with them in large motion.

#include <utility>
#include <vector>

#include "model/motion/march.hpp"

namespace femsph {

/// Where a point is now; in small motion, where it began.
Point place_of(const March& march, const MovingBody& body, std::size_t point);

struct Reaction {
  const MovingBody* body;
  struct Part {
    std::size_t point;
    int component;
    double share;
  };
  std::vector<Part> parts;
  std::vector<Weight> area;  ///< of the place; sum 1

  /// N, where they act: one for each part.
  std::vector<std::pair<Point, Point>> forces(const March& march) const;
  Point centroid(const March& march) const;
  /// Force (N) on the body, and its moment (N m) about the centroid.
  std::array<Point, 2> resultant(const March& march) const;
};

/// Of entry `hold` of Scene::holds(), which holds every point of its place on a body that deforms.
Reaction reaction_of(const March& march, std::size_t hold);
/// Of all of them.
std::vector<Reaction> all_reactions(const March& march);

}  // namespace femsph
