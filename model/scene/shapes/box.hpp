#pragma once

#include "model/scene/shapes/rigid_form.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// A rectangle or cuboid with sides parallel to the axes.
class Box final : public Shape, public RigidForm {
 public:
  Box(int dim, Point origin, Point size) : dim_(dim), origin_(origin), size_(size) {}
  int dim() const override { return dim_; }
  Point lower() const override { return origin_; }
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  const Box* box() const override { return this; }
  const RigidForm* rigid() const override { return this; }
  Point inertia(double mass) const override;
  double surface() const override;
  int side_count() const override { return 2 * dim_; }
  SideProjection project(int side, const Point& from, const std::array<Point, 3>& axes) const override;
  std::string describe() const override;
  const Point& size() const { return size_; }

 private:
  int dim_;
  Point origin_, size_;
};

}  // namespace femsph
