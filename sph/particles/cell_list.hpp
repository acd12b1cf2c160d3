#pragma once
// Cell list: which points lie within a radius of a point, in O(1) a query. Its memory is bounded wherever the
// points are: where a grid would be too large, space is folded, so that cell c also holds the points of cells
// c + n, c + 2 n, .. Folding adds candidates from far away and never loses one. A point whose coordinates are
// not finite is in no list.

#include <array>
#include <cstddef>
#include <vector>

#include "model/numerics/tensor.hpp"

namespace femsph::sph {

class CellList {
 public:
  CellList(const std::vector<Point>& points, int dim, double radius) { build(points, dim, radius); }
  CellList() = default;

  /// Sorts the points into cells of edge `radius` (counting sort: points of a cell stay in index order).
  void build(const std::vector<Point>& points, int dim, double radius);

  /// Calls take(first, last) for runs of sorted points. The runs contain every point within `radius` of p
  /// once, and some points beyond.
  template <class Take>
  void runs(const Point& p, Take&& take) const {
    Around around[3];
    for (int a = 0; a < 3; ++a) around[a] = cells_around(p, a);
    for (int k = 0; k < around[2].size; ++k)
      for (int j = 0; j < around[1].size; ++j) {
        const std::size_t row = std::size_t(count_[0]) *
                                (std::size_t(around[1].cell[j]) +
                                 std::size_t(count_[1]) * std::size_t(around[2].cell[k]));
        for (int i = 0; i < around[0].size;) {  // cells that follow each other are one run
          const int first = i++;
          while (i < around[0].size && around[0].cell[i] == around[0].cell[i - 1] + 1) ++i;
          take(begin_[row + std::size_t(around[0].cell[first])],
               begin_[row + std::size_t(around[0].cell[i - 1]) + 1]);
        }
      }
  }
  /// Calls take(j) for every point of these runs.
  template <class Take>
  void around(const Point& p, Take&& take) const {
    runs(p, [&](int first, int last) {
      for (int m = first; m < last; ++m) take(items_[std::size_t(m)]);
    });
  }

  const std::vector<int>& items() const { return items_; }                     ///< sorted by cell
  const std::vector<double>& sorted(int axis) const { return sorted_[axis]; }  ///< their coordinates
  int fullest() const;                                                         ///< most points in one cell
  int one_of_fullest() const;                                                  ///< one of these points
  std::size_t bytes() const {
    return (begin_.size() + items_.size()) * sizeof(int) + std::size_t(dim_) * items_.size() * sizeof(double);
  }

 private:
  /// The cells that a query visits along one axis.
  struct Around {
    int cell[3];
    int size;
  };
  Around cells_around(const Point& p, int a) const {
    const int c = place(p, a), n = count_[a];
    if (folded_[a]) return {{c == 0 ? n - 1 : c - 1, c, c == n - 1 ? 0 : c + 1}, 3};
    const int first = c > 0 ? c - 1 : 0, last = c < n - 1 ? c + 1 : n - 1;
    return {{first, first + 1, first + 2}, last - first + 1};
  }
  int place(const Point& p, int a) const;
  std::size_t index(const Point& p) const {
    return std::size_t(place(p, 0)) +
           std::size_t(count_[0]) *
               (std::size_t(place(p, 1)) + std::size_t(count_[1]) * std::size_t(place(p, 2)));
  }

  int dim_ = 2;
  double cell_ = 1;
  Point lower_{};
  std::array<int, 3> count_{1, 1, 1};
  std::array<bool, 3> folded_{};
  std::vector<int> begin_, items_;
  std::array<std::vector<double>, 3> sorted_;
};

}  // namespace femsph::sph
