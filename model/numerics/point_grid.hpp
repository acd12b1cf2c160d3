#pragma once
// Finds which of many points may lie in a box, by a uniform grid of bins over all points.

#include <array>
#include <cstddef>
#include <vector>

#include "model/numerics/tensor.hpp"

namespace femsph {

class PointGrid {
 public:
  PointGrid() = default;
  /// Bins of about `size` along each of the first `dim` axes.
  PointGrid(const std::vector<Point>& points, int dim, const Point& size);

  /// The points of all bins that the box overlaps, in the order of their numbers: those in the box, and some
  /// near it.
  std::vector<std::size_t> within(const Point& lower, const Point& upper) const;

 private:
  std::array<std::size_t, 3> bin_of(const Point& x) const;
  std::size_t number(const std::array<std::size_t, 3>& bin) const {
    return (bin[2] * count_[1] + bin[1]) * count_[0] + bin[0];
  }

  Point lower_{};
  Point size_{};  ///< of a bin, m
  std::array<std::size_t, 3> count_{1, 1, 1};
  std::vector<std::size_t> begin_;   ///< bin b holds points_[begin_[b]] .. points_[begin_[b + 1] - 1]
  std::vector<std::size_t> points_;  ///< their numbers, by bins
};

}  // namespace femsph
