#pragma once
// A shape as that of a rigid body, for its motion and for contact. The axes are those of the undeformed
// shape, rotated with the body; the centre is the middle of the bounding box.

#include <array>

#include "model/numerics/tensor.hpp"

namespace femsph {

/// The projection of a point onto one side of a rigid body.
struct SideProjection {
  Point normal{};     ///< outward unit normal
  double gap = 0;     ///< distance along the normal, m; negative inside
  double beyond = 0;  ///< how far the projection lies outside of the side, m
};

class RigidForm {
 public:
  virtual ~RigidForm() = default;
  virtual Point inertia(double mass) const = 0;  ///< moments of inertia about the axes, kg m^2
  virtual double surface() const = 0;            ///< surface area, m^2; perimeter in 2D, m
  virtual int side_count() const = 0;
  /// `from` (m): the vector from the centre of the body to the point.
  virtual SideProjection project(int side, const Point& from, const std::array<Point, 3>& axes) const = 0;
  /// The depth of a point inside below the surface, m; 0: not known.
  virtual double depth(const Point&) const { return 0; }
};

}  // namespace femsph
