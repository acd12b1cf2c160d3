#pragma once
// Vertices of blocks of cells that meet: equal places are one vertex.

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "model/numerics/tensor.hpp"

namespace femsph {

class MergedPoints {
 public:
  /// Points nearer to each other than about 1e-6 of `size` (m, the length of a cell) are one.
  explicit MergedPoints(double size) : grid_(1e-6 * size) {}

  /// The number of the point at p, which is added if there is none.
  int number(const Point& p) {
    const auto bin = [&](double x) { return std::lround(x / grid_); };
    for (const long i : {0, -1, 1})
      for (const long j : {0, -1, 1})
        for (const long k : {0, -1, 1})
          if (const auto known = at_.find({bin(p[0]) + i, bin(p[1]) + j, bin(p[2]) + k}); known != at_.end())
            return known->second;
    points_.push_back(p);
    return at_[{bin(p[0]), bin(p[1]), bin(p[2])}] = int(points_.size()) - 1;
  }
  const std::vector<Point>& points() const { return points_; }

 private:
  double grid_;
  std::vector<Point> points_;
  std::map<std::tuple<long, long, long>, int> at_;
};

}  // namespace femsph
