#pragma once
// Multilinear patches in space: segments, bilinear quadrilaterals and trilinear hexahedra, given by their
// corners.

#include <array>
#include <vector>

#include "model/numerics/box_grid.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// Corners in lexicographic order: 2 (k = 1), 4 (k = 2) or 8 (k = 3).
struct Patch {
  int k;
  std::array<Point, 8> corners;

  int corner_count() const { return 1 << k; }
  Point at(const std::array<double, 3>& xi) const;                      ///< xi in [0, 1]^k
  Point tangent(const std::array<double, 3>& xi, int direction) const;  ///< derivative along xi[direction]
};

/// The distance (m) of p from the patch: exact to round-off if p is near the patch, not too small elsewhere.
double distance(const Patch& patch, const Point& p);

/// A box that contains the patch: the bounding box of its corners.
BoxGrid::Box bounding_box(const Patch& patch);
/// Whether p is within `tolerance` (m) of the patch. The bounding box is tested first, which is much cheaper.
bool is_near(const Patch& patch, const Point& p, double tolerance);

/// The smallest determinant of dx/dxi over the corners of a cell in `dim` dimensions (k = dim), m^dim.
double smallest_corner_jacobian(const Patch& patch);

/// The same over the Gauss points of order 2 a direction, where every element takes its gradients.
double smallest_gauss_jacobian(const Patch& patch);
/// Determinant of dx/dxi of a cell (k = dim).
double determinant(const Patch& patch, const std::array<double, 3>& xi);

/// Area or volume of a cell (k = dim), m^dim.
double measure(const Patch& patch);
/// The integral of x over a cell (k = dim), m^(dim+1).
Point first_moment(const Patch& patch);

/// Cuts a patch with k = dim - 1 into pieces no longer than `size` (m) and appends them. Their area vectors
/// point to the right of a segment from corner 0 to 1, or along the cross product of the tangents of a
/// quadrilateral; times `sign`.
void add_pieces(const Patch& patch, double size, double sign, std::vector<SidePiece>& out);

}  // namespace femsph
