#pragma once
// The reactions of supports.
//
// The reaction on a component with n supports or symmetry planes belongs to each of them with a share of 1/n,
// so that the sum over all supports is the total. Moments are about the centroid of the support's place: the
// mean position of its points, weighted by their area; in large motion at the present positions.

#include <utility>
#include <vector>

#include "model/motion/march.hpp"

namespace femsph {

/// The position of a point (m): in large motion the present one, in small motion the undeformed one.
Point place_of(const March& march, const MovingBody& body, std::size_t point);

struct Reaction {
  const MovingBody* body;
  struct Part {
    std::size_t point;
    int component;
    double share;
  };
  std::vector<Part> parts;
  std::vector<Weight> area;  ///< points of the place with their shares of the area; sum 1

  /// Position (m) and force (N) of each part.
  std::vector<std::pair<Point, Point>> forces(const March& march) const;
  Point centroid(const March& march) const;
  /// The force (N) on the body, and its moment (N m) about the centroid.
  std::array<Point, 2> resultant(const March& march) const;
};

/// The reaction of entry `hold` of Scene::holds(), on a deformable body and not of mode "mean".
Reaction reaction_of(const March& march, std::size_t hold);
/// The reactions of all such entries.
std::vector<Reaction> all_reactions(const March& march);

}  // namespace femsph
