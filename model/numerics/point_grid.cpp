#include "model/numerics/point_grid.hpp"

#include <algorithm>

namespace femsph {

PointGrid::PointGrid(const std::vector<Point>& points, int dim, const Point& size) {
  if (points.empty()) return;
  Point upper = lower_ = points[0];
  for (const Point& x : points)
    for (std::size_t a = 0; a < 3; ++a)
      lower_[a] = std::min(lower_[a], x[a]), upper[a] = std::max(upper[a], x[a]);
  for (std::size_t a = 0; int(a) < dim; ++a)
    count_[a] = std::size_t(std::clamp((upper[a] - lower_[a]) / size[a], 1.0, 1e6));
  while (count_[0] * count_[1] * count_[2] > 8 * points.size() + 64) {  // a thin body at a slant
    std::size_t& longest = *std::max_element(count_.begin(), count_.end());
    longest = (longest + 1) / 2;
  }
  for (std::size_t a = 0; a < 3; ++a) size_[a] = std::max((upper[a] - lower_[a]) / double(count_[a]), 1e-300);

  begin_.assign(count_[0] * count_[1] * count_[2] + 1, 0);
  for (const Point& x : points) ++begin_[number(bin_of(x)) + 1];
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  points_.resize(points.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) points_[next[number(bin_of(points[i]))]++] = i;
}

std::array<std::size_t, 3> PointGrid::bin_of(const Point& x) const {
  std::array<std::size_t, 3> bin{};
  for (std::size_t a = 0; a < 3; ++a)
    bin[a] = std::size_t(std::clamp((x[a] - lower_[a]) / size_[a], 0.0, double(count_[a] - 1)));
  return bin;
}

std::vector<std::size_t> PointGrid::within(const Point& lower, const Point& upper) const {
  std::vector<std::size_t> out;
  if (points_.empty()) return out;
  const auto first = bin_of(lower), last = bin_of(upper);
  for (std::size_t k = first[2]; k <= last[2]; ++k)
    for (std::size_t j = first[1]; j <= last[1]; ++j)
      out.insert(out.end(), points_.begin() + std::ptrdiff_t(begin_[number({first[0], j, k})]),
                 points_.begin() + std::ptrdiff_t(begin_[number({last[0], j, k}) + 1]));
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace femsph
