#pragma once
// Shapes that know how to cut themselves into quadrilaterals or hexahedra of a wanted size.

#include "model/scene/shapes/shape.hpp"

namespace femsph {

class StructuredShape : public Shape {
 public:
  /// Cells of about (upper - lower) / divisions along each axis; throws std::runtime_error with one sentence
  /// when that is none.
  virtual CellMesh mesh(const std::array<int, 3>& divisions) const = 0;
};

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
    double finer = 1;  ///< how many times smaller cells are at the pole than in an even mesh; at the other
                       ///< pole they are as many times larger
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

/// A plane quadrilateral by its corners, counterclockwise; sides "bottom" (first to second corner), "right",
/// "top", "left".
class Quadrilateral final : public StructuredShape {
 public:
  explicit Quadrilateral(const std::array<Point, 4>& corners) : corners_(corners) {}
  int dim() const override { return 2; }
  Point lower() const override;
  Point upper() const override;
  bool contains(const Point& p, double tolerance) const override;
  std::vector<std::string> sides() const override;
  bool on_side(const std::string& side, const Point& p, double tolerance) const override;
  double measure() const override;
  Point centroid() const override;
  std::vector<SidePiece> side_pieces(const std::string& side, double size) const override;
  std::string describe() const override;
  /// divisions[0] cells along bottom and top, divisions[1] along left and right.
  CellMesh mesh(const std::array<int, 3>& divisions) const override;

 private:
  std::array<Point, 4> corners_;
};

}  // namespace femsph
