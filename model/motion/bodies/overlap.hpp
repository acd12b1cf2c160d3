#pragma once
// Whether two bodies overlap. Checked once, before the first step.
//
// A deformable body is the region that its boundary facets enclose, with its initial displacement; a rigid
// one is its shape. Two bodies overlap if a point of one lies inside the other (at any depth), or if an edge
// of one pierces a facet of the other (bodies that cross without a point inside). Depths below a tolerance
// count as touching.

#include <optional>
#include <vector>

#include "model/motion/bodies/surface.hpp"
#include "model/numerics/box_grid.hpp"

namespace femsph {

/// A place where two bodies overlap.
struct Overlap {
  Point at;
  double depth = 0;  ///< m, distance from there to the boundary of the other body; 0: not known
};

/// The region inside a closed surface at its present position (Surface::now). `surface` must outlive it.
class Enclosure {
 public:
  explicit Enclosure(const Surface& surface);
  /// Distance (m) from p to the boundary if p is inside; 0 if it is outside, or nearer to the boundary than
  /// `tolerance`.
  double depth(const Point& p, double tolerance) const;
  /// Where an edge of the other surface goes through a facet of this one, by more than `tolerance` (m) on
  /// both sides.
  std::optional<Point> pierced_by(const Surface& other, double tolerance) const;

 private:
  /// The winding number of the surface about p: on the ray from p along x, the facets through which it leaves
  /// the body minus those through which it enters.
  int winding(const Point& p) const;
  double distance(std::size_t facet, const Point& p) const;
  bool reaches(const Point& p, double tolerance) const;  ///< p is in the bounding box

  const Surface& surface_;
  BoxGrid::Box bounds_{};
  BoxGrid grid_, columns_;  ///< bounding boxes of the facets; the same projected along x
};

std::optional<Overlap> overlap_of(const Surface& a, const Surface& b, double tolerance);
/// The same for a deformable body and the shape of a rigid one, in its initial position.
std::optional<Overlap> overlap_of(const Surface& a, const Shape& rigid, double tolerance);

}  // namespace femsph
