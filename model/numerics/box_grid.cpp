#include "model/numerics/box_grid.hpp"

#include <cmath>

namespace femsph {

BoxGrid::BoxGrid(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  Point upper = boxes[0].upper;
  lower_ = boxes[0].lower;
  for (const Box& box : boxes)
    for (int c = 0; c < 3; ++c) {
      lower_[c] = std::min(lower_[c], box.lower[c]);
      upper[c] = std::max(upper[c], box.upper[c]);
    }

  // About one bucket a box: start from one bucket along the longest direction and halve the buckets while
  // they are fewer than that.
  const double longest = std::max({upper[0] - lower_[0], upper[1] - lower_[1], upper[2] - lower_[2]});
  for (double size = longest; size > 0; size /= 2) {
    Index count;
    for (int c = 0; c < 3; ++c) count[c] = std::max(1, int(std::ceil((upper[c] - lower_[c]) / size)));
    if (double(count[0]) * count[1] * count[2] > 2.0 * double(boxes.size())) break;
    count_ = count;
  }
  for (int c = 0; c < 3; ++c) step_[c] = (upper[c] - lower_[c]) / count_[c];

  const auto for_each_bucket = [&](auto&& act) {
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const auto [first, last] = range(boxes[b]);
      for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
          for (int i = first[0]; i <= last[0]; ++i) act(bucket(i, j, k), int(b));
    }
  };
  start_.assign(bucket(count_[0] - 1, count_[1] - 1, count_[2] - 1) + 2, 0);
  for_each_bucket([&](std::size_t b, int) { ++start_[b + 1]; });
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  entries_.resize(start_.back());
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for_each_bucket([&](std::size_t b, int box) { entries_[next[b]++] = box; });
}

std::pair<BoxGrid::Index, BoxGrid::Index> BoxGrid::range(const Box& box) const {
  const auto index = [&](double x, int c) {
    return step_[c] > 0 ? int(std::clamp(std::floor((x - lower_[c]) / step_[c]), 0.0, double(count_[c] - 1)))
                        : 0;
  };
  std::pair<Index, Index> result;
  for (int c = 0; c < 3; ++c) {
    result.first[c] = index(box.lower[c], c);
    result.second[c] = index(box.upper[c], c);
  }
  return result;
}

}  // namespace femsph
