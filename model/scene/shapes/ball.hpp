#pragma once

#include "model/scene/shapes/round_frame.hpp"
#include "model/scene/shapes/structured.hpp"

namespace femsph {

/// A ball that is cut into cells for both solvers; whole, or a half or quarter bounded by planes through its
/// axis. Its cells may be finer at the pole with the lowest coordinate along the axis, for an impact there.
/// (Ball, in disc.hpp, is a disc or sphere without cells.)
class OwnBall final : public StructuredShape {
 public:
  using Part = RoundPart;
  struct Size {
    Point centre{};
    double radius = 0;  ///< m
    int axis = 2;
    Part part = Part::whole;
    /// How many times smaller the cells are at that pole than in an even mesh; at the opposite pole they are
    /// as many times larger.
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
  /// In each octant a cube at the centre and three blocks from its faces to the sphere; all vertices are then
  /// moved towards the finer pole. The vertices of the boundary lie on the sphere.
  CellMesh mesh(const std::array<int, 3>& divisions) const override;
  const Size& size() const { return size_; }

 private:
  RoundFrame frame() const { return {size_.centre, size_.axis, size_.part}; }

  Size size_;
};

}  // namespace femsph
