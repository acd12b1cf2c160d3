#pragma once
// Finds the cell that holds a point: cells in the bins of a grid, then Newton's method on the bilinear map.

#include <vector>

#include "fem/mesh/mesh.hpp"

namespace femsph::fem {

class Locator {
 public:
  /// `slack`: how far (in cells) a point may lie outside and still have the value of the nearest place, for
  /// bodies whose curved sides the mesh cuts straight.
  explicit Locator(const Mesh& mesh, double slack = 0);
  struct Found {
    std::size_t cell;
    Point xi;  ///< reference coordinates, in [-1, 1]
  };
  /// Throws std::runtime_error when the point lies outside by more than 1e-6 of a cell, or the slack: nothing
  /// is extrapolated.
  Found find(const Point& p) const;
  /// Every cell that holds the point, within the same tolerance: several on a common side or corner. Throws
  /// as find does.
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
  Point lower_, size_;  ///< of the grid; of a bin
  std::array<int, 3> count_{1, 1, 1};
  std::vector<int> begin_,
      cells_;  ///< cells that touch bin b: cells_[begin_[b]] .. cells_[begin_[b + 1] - 1]
};

}  // namespace femsph::fem
