#include "sph/particles/cell_list.hpp"

#include <algorithm>
#include <cmath>

namespace femsph::sph {

void CellList::build(const std::vector<Point>& points, int dim, double radius) {
  dim_ = dim;
  cell_ = radius;
  count_ = {1, 1, 1};
  folded_ = {};
  for (int a = 0; a < dim; ++a) {
    double lower = INFINITY, upper = -INFINITY;
    for (const Point& p : points)
      if (std::isfinite(p[a])) lower = std::min(lower, p[a]), upper = std::max(upper, p[a]);
    lower_[a] = lower <= upper ? lower : 0.0;
    const double cells = lower <= upper ? (upper - lower) / cell_ : 0.0;
    folded_[a] = !(cells < 1e6);
    count_[a] = folded_[a] ? 1000000 : int(cells) + 1;
  }
  while (double(count_[0]) * count_[1] * count_[2] > 4.0 * double(points.size()) + 1000) {
    const auto longest = std::max_element(count_.begin(), count_.end());
    *longest = std::max(3, (*longest + 1) / 2);  // a cell and its two neighbours along an axis must differ
    folded_[std::size_t(longest - count_.begin())] = true;
  }
  std::vector<int> cell_of(points.size());
  begin_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]) + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    ++begin_[std::size_t(cell_of[i] = int(index(points[i]))) + 1];
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  items_.resize(points.size());
  for (int a = 0; a < dim; ++a) sorted_[a].resize(points.size());
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t slot = std::size_t(next[std::size_t(cell_of[i])]++);
    items_[slot] = int(i);
    for (int a = 0; a < dim; ++a) sorted_[a][slot] = points[i][a];
  }
}

int CellList::fullest() const {
  int most = 0;
  for (std::size_t c = 1; c < begin_.size(); ++c) most = std::max(most, begin_[c] - begin_[c - 1]);
  return most;
}

int CellList::one_of_fullest() const {
  const int most = fullest();
  std::size_t c = 1;
  while (begin_[c] - begin_[c - 1] < most) ++c;
  return items_[std::size_t(begin_[c - 1])];
}

int CellList::place(const Point& p, int a) const {
  if (count_[a] == 1) return 0;
  double c = std::floor((p[a] - lower_[a]) / cell_);
  if (folded_[a]) c -= count_[a] * std::floor(c / count_[a]);
  if (!(c > 0)) return 0;  // NaN: any cell will do
  return c < count_[a] ? int(c) : count_[a] - 1;
}

}  // namespace femsph::sph
