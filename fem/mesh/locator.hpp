#pragma once
// Finds the cell that contains a point: candidates from a grid of bins, then Newton's method for the
// reference coordinates.

#include <vector>

#include "fem/mesh/mesh.hpp"

namespace femsph::fem {

class Locator {
 public:
  /// `slack`: how far outside of the mesh (in cells) a point may lie and still take the values of the nearest
  /// point of the mesh; for bodies with curved sides, which the mesh replaces by straight edges.
  explicit Locator(const Mesh& mesh, double slack = 0);
  struct Found {
    std::size_t cell;
    Point xi;  ///< reference coordinates, in [-1, 1]
  };
  /// Throws Refusal if the point lies outside by more than 1e-6 of a cell, or by more than the slack: values
  /// are not extrapolated.
  Found find(const Point& p) const;
  /// Every cell that contains the point within that tolerance; several if it lies on a common side or corner.
  /// Throws as find() does.
  std::vector<Found> find_all(const Point& p) const;
  std::size_t bytes() const { return sizeof(int) * (begin_.capacity() + cells_.capacity()); }

 private:
  std::vector<Found> nearest(const Point& p) const;
  std::array<int, 3> bin(const Point& p) const;
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(i);
  }
  const Mesh& mesh_;
  double slack_;
  Point lower_, size_;  ///< lower corner of the grid of bins; size of a bin, m
  std::array<int, 3> count_{1, 1, 1};
  std::vector<int> begin_,
      cells_;  ///< cells that overlap bin b: cells_[begin_[b]] .. cells_[begin_[b + 1] - 1]
};

}  // namespace femsph::fem
