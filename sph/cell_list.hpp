#pragma once
// Cell list: which points lie within a radius of a point, in O(1) a query.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "model/numerics/tensor.hpp"

namespace femsph::sph {

class CellList {
 public:
  CellList(const std::vector<Point>& points, int dim, double radius) { build(points, dim, radius); }
  CellList() = default;

  /// Sorts the points into cells of edge `radius` (counting sort: points of a cell stay in index order).
  void build(const std::vector<Point>& points, int dim, double radius) {
    dim_ = dim;
    cell_ = radius;
    Point upper{};
    for (int a = 0; a < 3; ++a) {
      lower_[a] = upper[a] = points.empty() ? 0.0 : points[0][a];
      for (const Point& p : points) {
        lower_[a] = std::min(lower_[a], p[a]);
        upper[a] = std::max(upper[a], p[a]);
      }
      count_[a] = a < dim ? int(std::min((upper[a] - lower_[a]) / cell_, 1e6)) + 1 : 1;
    }
    // A body scattered far apart must not ask for a huge empty grid.
    while (double(count_[0]) * count_[1] * count_[2] > 4.0 * double(points.size()) + 1000) {
      cell_ *= 1.5;
      for (int a = 0; a < dim; ++a) count_[a] = int(std::min((upper[a] - lower_[a]) / cell_, 1e6)) + 1;
    }
    begin_.assign(std::size_t(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (const Point& p : points) ++begin_[index(p) + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    items_.resize(points.size());
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) items_[std::size_t(next[index(points[i])]++)] = int(i);
  }

  /// Calls take(j) for every point in the cells around p: all points within `radius`, and some beyond.
  template <class Take>
  void around(const Point& p, Take&& take) const {
    std::array<int, 3> c{};
    for (int a = 0; a < dim_; ++a) c[a] = place(p, a);
    for (int k = dim_ == 3 ? std::max(c[2] - 1, 0) : 0; k <= (dim_ == 3 ? std::min(c[2] + 1, count_[2] - 1) : 0); ++k)
      for (int j = std::max(c[1] - 1, 0); j <= std::min(c[1] + 1, count_[1] - 1); ++j) {
        const std::size_t row = std::size_t(count_[0]) * (std::size_t(j) + std::size_t(count_[1]) * k);
        const int first = begin_[row + std::max(c[0] - 1, 0)], last = begin_[row + std::min(c[0] + 1, count_[0] - 1) + 1];
        for (int m = first; m < last; ++m) take(items_[std::size_t(m)]);
      }
  }

 private:
  int place(const Point& p, int a) const { return std::clamp(int((p[a] - lower_[a]) / cell_), 0, count_[a] - 1); }
  std::size_t index(const Point& p) const {
    return std::size_t(place(p, 0)) + std::size_t(count_[0]) * (std::size_t(place(p, 1)) + std::size_t(count_[1]) * (dim_ == 3 ? place(p, 2) : 0));
  }
  int dim_ = 2;
  double cell_ = 1;
  Point lower_{};
  std::array<int, 3> count_{1, 1, 1};
  std::vector<int> begin_, items_;
};

}  // namespace femsph::sph
