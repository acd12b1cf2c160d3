#pragma once

#include "model/scene/shapes/rigid_form.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// A disc (in a plane) or a sphere. It can be rigid. SPH fills it with a lattice of particles; FEM cuts a
/// disc as Round does, and takes no sphere.
class Ball final : public Shape, public RigidForm {
 public:
  Ball(int dim, Point centre, double radius) : dim_(dim), centre_(centre), radius_(radius) {}
  int dim() const override { return dim_; }
  Point lower() const override;
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  bool is_round() const override { return true; }
  bool touches_sides_in_points() const override { return true; }
  /// A disc: the cells of Round. A sphere: none.
  std::optional<CellMesh> cut(const std::array<int, 3>& divisions) const override;
  const RigidForm* rigid() const override { return this; }
  Point inertia(double mass) const override;
  double surface() const override;
  int side_count() const override { return 1; }
  SideProjection project(int side, const Point& from, const std::array<Point, 3>& axes) const override;
  double depth(const Point& p) const override;
  std::string describe() const override;
  const Point& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  int dim_;
  Point centre_;
  double radius_;
};

}  // namespace femsph
