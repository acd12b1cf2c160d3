#pragma once
// What contact and the motion of a rigid body ask of its shape. Its axes are those of the shape, turned with
// the body; its centre is the middle of the bounding box.

#include <array>

#include "model/numerics/tensor.hpp"

namespace femsph {

/// Where a point stands to one side of a rigid body.
struct SideStand {
  Point normal{};     ///< outward
  double gap = 0;     ///< m; below 0: inside
  double beyond = 0;  ///< m: how far the foot lies beyond the side's edge
};

class RigidForm {
 public:
  virtual ~RigidForm() = default;
  virtual Point inertia(double mass) const = 0;  ///< about the axes, kg m^2
  virtual double surface() const = 0;            ///< area (perimeter in 2D), m^(dim-1)
  virtual int side_count() const = 0;
  /// `from`: from the body's centre to the point.
  virtual SideStand stand(int side, const Point& from, const std::array<Point, 3>& axes) const = 0;
  /// How deep a point within lies under the surface, m; 0: not known.
  virtual double depth(const Point&) const { return 0; }
};

}  // namespace femsph
