#pragma once

#include "model/scene/shapes/round_frame.hpp"
#include "model/scene/shapes/structured.hpp"

namespace femsph {

/// Discs and rings in a plane, cylinders and tubes in space: a circular section, solid (inner = 0) or hollow,
/// along an axis.
class Round final : public StructuredShape {
 public:
  using Part = RoundPart;
  struct Size {
    Point centre{};  ///< m, of the section; in space of the end section with the lowest coordinate along the
                     ///< axis
    double inner = 0, outer = 0, length = 0;  ///< m: radii, and in space the length along the axis
    int axis = 2;                             ///< 0, 1, 2: x, y, z; in a plane it has no meaning
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
  /// Hollow: layers across the wall and sectors around it, both of the wanted size at the middle of the wall.
  /// Solid: in each quarter a square block at the centre, and two blocks from its sides to the circle. The
  /// vertices of the boundary lie on the circles.
  CellMesh mesh(const std::array<int, 3>& divisions) const override;
  const Size& size() const { return size_; }

 private:
  RoundFrame frame() const { return {size_.centre, dim_ == 2 ? 2 : size_.axis, size_.part}; }

  int dim_;
  Size size_;
};

}  // namespace femsph
