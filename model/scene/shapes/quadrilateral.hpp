#pragma once

#include "model/scene/shapes/structured.hpp"

namespace femsph {

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
  bool names_whole_boundary() const override { return true; }
  std::string describe() const override;
  /// divisions[0] cells along bottom and top, divisions[1] along left and right.
  CellMesh mesh(const std::array<int, 3>& divisions) const override;

 private:
  std::array<Point, 4> corners_;
};

}  // namespace femsph
