#pragma once
// Are two bodies in each other where they stand? Asked once, before the first step.
//
// A deformable body is what its boundary facets enclose, as displaced at the start; a rigid one is its shape.
// Two such bodies are in each other if a point of one lies inside the other (which finds any depth, and a
// body that is wholly inside), or if an edge of one pierces a facet of the other (which finds bodies that
// cross and leave no point inside). Touching is not: less than a tolerance counts as nothing.

#include <optional>
#include <vector>

#include "model/motion/bodies/surface.hpp"
#include "model/numerics/box_grid.hpp"

namespace femsph {

/// A place where two bodies are in each other.
struct Overlap {
  Point at;
  double depth = 0;  ///< m, from there to the other body's boundary; 0: not known
};

/// The closed boundary of a deformable body where it is now (Surface::now). `surface` must outlive it.
class Enclosure {
 public:
  explicit Enclosure(const Surface& surface);
  /// Distance (m) from p to the boundary if p is inside; 0 if it is outside, or nearer to the boundary than
  /// `tolerance`.
  double depth(const Point& p, double tolerance) const;
  /// Where an edge of the other body goes through a facet of this one, by more than `tolerance` on both
  /// sides.
  std::optional<Point> pierced_by(const Surface& other, double tolerance) const;

 private:
  /// How many times the boundary goes round p: facets that the ray from p along x meets, those that it leaves
  /// by less those that it enters by.
  int winding(const Point& p) const;
  double distance(std::size_t facet, const Point& p) const;
  bool reaches(const Point& p, double tolerance) const;  ///< p is in the bounding box

  const Surface& surface_;
  BoxGrid::Box bounds_{};
  BoxGrid grid_, columns_;  ///< of the facets' boxes; of the same seen along x
};

std::optional<Overlap> overlap_of(const Surface& a, const Surface& b, double tolerance);
/// A deformable body and a rigid box or ball that has not moved yet.
std::optional<Overlap> overlap_of(const Surface& a, const Shape& rigid, double tolerance);

}  // namespace femsph
