#pragma once

#include "model/scene/shapes/structured.hpp"

namespace femsph {

/// Discs and rings in a plane, cylinders and tubes in space: a circular section, solid (inner = 0) or hollow,
/// along an axis.
class Round final : public StructuredShape {
 public:
  /// How much of the section there is, seen from the centre: all, the half where its second axis is positive,
  /// the quarter where both are.
  enum class Part { whole, half, quarter };
  /// `centre` of the section; in space of the end where the axis begins.
  struct Size {
    Point centre{};
    double inner = 0, outer = 0, length = 0;  ///< m; the length in space only
    int axis = 2;
    Part part = Part::whole;
  };
  Round(int dim, Size size) : dim_(dim), size_(size) {}

  int dim() const override { return dim_; }
  Point lower() const override;
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  /// Those of the bounding box, "outer", and if hollow "inner".
  std::vector<std::string> sides() const override;
  bool on_side(const std::string& side, const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  std::vector<SidePiece> side_pieces(const std::string& side, double size) const override;
  bool is_round() const override { return true; }
  std::string describe() const override;
  /// Hollow: layers across the wall and sectors around, both of the wanted size at the middle of the wall.
  /// Solid: a square in the middle of each quarter, and two blocks from its sides to the rim. Vertices of the
  /// rims lie on them.
  CellMesh mesh(const std::array<int, 3>& divisions) const override;
  const Size& size() const { return size_; }

 private:
  /// The section's own coordinates: its two axes, and along it.
  std::array<double, 3> section(const Point& p) const;
  Point place(double a, double b, double along) const;
  int first() const { return dim_ == 2 ? 0 : (size_.axis + 1) % 3; }
  int second() const { return dim_ == 2 ? 1 : (size_.axis + 2) % 3; }
  int quarters() const { return size_.part == Part::whole ? 4 : size_.part == Part::half ? 2 : 1; }

  int dim_;
  Size size_;
};

}  // namespace femsph
