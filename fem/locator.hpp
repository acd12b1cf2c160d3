#pragma once
// Finds the cell that holds a point: cells in the bins of a grid, then Newton's method on the bilinear map.

#include <vector>

#include "fem/mesh.hpp"

namespace femsph::fem {

class Locator {
 public:
  explicit Locator(const Mesh& mesh);
  struct Found {
    std::size_t cell;
    Point xi;  ///< reference coordinates, in [-1, 1]
  };
  /// Throws std::runtime_error when the point lies outside by more than a fifth of a cell: nothing is extrapolated, and a point between
  /// a curved side and the straight edges that stand for it has the value of the edge.
  Found find(const Point& p) const;
  /// Every cell that holds the point, within the same tolerance: several on a common side or corner. Throws as find does.
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
  Point lower_, size_;  ///< of the grid; of a bin
  std::array<int, 3> count_{1, 1, 1};
  std::vector<int> begin_, cells_;  ///< cells that touch bin b: cells_[begin_[b]] .. cells_[begin_[b + 1] - 1]
};

}  // namespace femsph::fem
