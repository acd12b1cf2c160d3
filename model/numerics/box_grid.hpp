#pragma once
// Finds which of many boxes (parallel to the axes) may contain a point, by a uniform grid of buckets over all
// of them.

#include <algorithm>
#include <array>
#include <vector>

#include "model/numerics/tensor.hpp"

namespace femsph {

class BoxGrid {
 public:
  struct Box {
    Point lower, upper;
  };

  BoxGrid() = default;
  explicit BoxGrid(const std::vector<Box>& boxes);

  /// Whether holds(i) is true for one of the boxes i within `tolerance` of p. It may be called twice for a
  /// box, and is not called further once it is true.
  template <class Predicate>
  bool any_near(const Point& p, double tolerance, Predicate holds) const {
    if (entries_.empty()) return false;
    const auto [first, last] = range({shifted(p, -tolerance), shifted(p, tolerance)});
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i) {
          const std::size_t b = bucket(i, j, k);
          const auto begin = entries_.begin() + start_[b], end = entries_.begin() + start_[b + 1];
          if (std::any_of(begin, end, holds)) return true;
        }
    return false;
  }

 private:
  using Index = std::array<int, 3>;

  static Point shifted(const Point& p, double by) { return {p[0] + by, p[1] + by, p[2] + by}; }
  std::size_t bucket(int i, int j, int k) const { return (std::size_t(k) * count_[1] + j) * count_[0] + i; }
  /// The range of buckets that a box overlaps, limited to the grid.
  std::pair<Index, Index> range(const Box& box) const;

  Point lower_{};
  Point step_{};  ///< size of a bucket, m; 0 across a direction without extent
  Index count_{1, 1, 1};
  std::vector<int> start_;    ///< bucket b holds entries_[start_[b]] .. entries_[start_[b + 1] - 1]
  std::vector<int> entries_;  ///< box numbers
};

}  // namespace femsph
