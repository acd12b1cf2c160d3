#pragma once

#include "model/scene/shapes/round.hpp"

namespace femsph {

/// A ball with cells of its own, whole or cut by planes through its axis, whose cells may be finer at the
/// pole where the axis begins (the lowest point along it): for what strikes there.
class OwnBall final : public StructuredShape {
 public:
  using Part = Round::Part;
  struct Size {
    Point centre{};
    double radius = 0;  ///< m
    int axis = 2;
    Part part = Part::whole;
    /// How many times smaller cells are at the pole than in an even mesh; at the other pole they are as many
    /// times larger.
    double finer = 1;
  };
  explicit OwnBall(const Size& size) : size_(size) {}

  int dim() const override { return 3; }
  Point lower() const override;
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  /// Those of the bounding box, and "outer".
  std::vector<std::string> sides() const override;
  bool on_side(const std::string& side, const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  bool is_round() const override { return true; }
  std::string graded_by() const override { return size_.finer > 1 ? "finer" : ""; }
  std::string describe() const override;
  /// In each octant a cube and three blocks from its faces to the rim, all drawn to the pole. Vertices of the
  /// rim lie on it.
  CellMesh mesh(const std::array<int, 3>& divisions) const override;
  const Size& size() const { return size_; }

 private:
  /// The ball's own coordinates: the two axes across, and along.
  std::array<double, 3> own(const Point& p) const;
  Point place(double a, double b, double along) const;
  int first() const { return (size_.axis + 1) % 3; }
  int second() const { return (size_.axis + 2) % 3; }
  int quarters() const { return size_.part == Part::whole ? 4 : size_.part == Part::half ? 2 : 1; }

  Size size_;
};

}  // namespace femsph
