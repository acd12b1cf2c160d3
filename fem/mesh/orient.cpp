// One direction for each edge that cells share: what deal.II's GridTools::consistently_order_cells does.

#include <algorithm>
#include <set>
#include <utility>

#include "fem/mesh/grid.hpp"

namespace femsph::fem {

namespace {

using Edge = std::pair<int, int>;

/// Corners of the edge of number e: 4 in the plane, 12 in space; the direction along which it runs.
struct CellEdge {
  int from, to, along;
};
std::vector<CellEdge> edges_of_a_cell(int dim) {
  std::vector<CellEdge> edges;
  for (int d = 0; d < dim; ++d)
    for (int a = 0; a < 1 << dim; ++a)
      if (!(a >> d & 1)) edges.push_back({a, a | 1 << d, d});
  return edges;
}

bool agree(const CellMesh& grid, const std::vector<CellEdge>& edges) {
  std::set<Edge> seen;
  for (const auto& cell : grid.cells)
    for (const CellEdge& e : edges) {
      if (seen.count({cell[e.to], cell[e.from]})) return false;
      seen.insert({cell[e.from], cell[e.to]});
    }
  return true;
}

/// Every edge of the grid once, and the cells around it.
class Edges {
 public:
  Edges(const CellMesh& grid, const std::vector<CellEdge>& in_cell) : grid_(grid), in_cell_(in_cell) {
    for (const auto& cell : grid.cells)
      for (const CellEdge& e : in_cell) all_.push_back(std::minmax(cell[e.from], cell[e.to]));
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
    direction_.assign(all_.size(), 0);
    cells_.resize(all_.size());
    for (std::size_t c = 0; c < grid.cells.size(); ++c)
      for (std::size_t e = 0; e < in_cell.size(); ++e) cells_[number(c, e)].push_back(c);
  }
  /// Directs all edges, those parallel to each other alike; false if a set of them meets itself the other way
  /// round.
  bool direct() {
    for (std::size_t c = 0; c < grid_.cells.size(); ++c)
      for (const int d : {1, 0, 2}) {  // the order that deal.II takes
        if (d >= grid_.dim) continue;
        const std::size_t first = number(c, first_along(d));
        if (direction_[first] == 0 && !direct_parallel(first)) return false;
      }
    return true;
  }
  /// 1: edge e of cell c runs as its corners do; -1: the other way.
  int sign(std::size_t c, std::size_t e) const {
    const auto& cell = grid_.cells[c];
    return (cell[in_cell_[e].from] < cell[in_cell_[e].to] ? 1 : -1) * direction_[number(c, e)];
  }

 private:
  std::size_t number(std::size_t c, std::size_t e) const {
    const auto& cell = grid_.cells[c];
    const Edge edge = std::minmax(cell[in_cell_[e].from], cell[in_cell_[e].to]);
    return static_cast<std::size_t>(std::lower_bound(all_.begin(), all_.end(), edge) - all_.begin());
  }
  std::size_t first_along(int d) const { return static_cast<std::size_t>(d) * (in_cell_.size() / grid_.dim); }

  bool direct_parallel(std::size_t first) {
    direction_[first] = 1;
    std::vector<std::size_t> open{first};
    while (!open.empty()) {
      const std::size_t edge = open.back();
      open.pop_back();
      for (const std::size_t c : cells_[edge])
        for (std::size_t e = 0; e < in_cell_.size(); ++e) {
          if (number(c, e) != edge) continue;
          for (std::size_t other = 0; other < in_cell_.size(); ++other) {
            if (other == e || in_cell_[other].along != in_cell_[e].along) continue;
            const std::size_t n = number(c, other);
            if (direction_[n] == 0) {
              direction_[n] = 1;
              if (sign(c, other) != sign(c, e)) direction_[n] = -1;
              open.push_back(n);
            } else if (sign(c, other) != sign(c, e)) {
              return false;
            }
          }
        }
    }
    return true;
  }

  const CellMesh& grid_;
  const std::vector<CellEdge>& in_cell_;
  std::vector<Edge> all_;       ///< lower vertex first
  std::vector<int> direction_;  ///< 1: from the lower vertex to the higher; -1; 0: not known yet
  std::vector<std::vector<std::size_t>> cells_;
};

/// Turns a cell, keeping its orientation in space, until corner `origin` is the first.
std::array<int, 8> turned(const std::array<int, 8>& cell, int dim, int origin) {
  constexpr int plane[4][4] = {{0, 1, 2, 3}, {1, 3, 0, 2}, {2, 0, 3, 1}, {3, 2, 1, 0}};
  constexpr int space[8][8] = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {1, 5, 3, 7, 0, 4, 2, 6}, {2, 6, 0, 4, 3, 7, 1, 5}, {3, 2, 1, 0, 7, 6, 5, 4},
      {4, 0, 6, 2, 5, 1, 7, 3}, {5, 4, 7, 6, 1, 0, 3, 2}, {6, 7, 4, 5, 2, 3, 0, 1}, {7, 3, 5, 1, 6, 2, 4, 0}};
  std::array<int, 8> out{};
  for (int a = 0; a < 1 << dim; ++a) out[a] = cell[dim == 2 ? plane[origin][a] : space[origin][a]];
  return out;
}

}  // namespace

void orient_consistently(CellMesh& grid) {
  const std::vector<CellEdge> in_cell = edges_of_a_cell(grid.dim);
  if (agree(grid, in_cell)) return;
  Edges edges(grid, in_cell);
  if (!edges.direct()) return;
  std::vector<std::array<int, 8>> cells = grid.cells;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    int origin = 0;  // the corner where an edge along each axis starts
    for (int d = 0; d < grid.dim; ++d)
      if (edges.sign(c, static_cast<std::size_t>(d) * (in_cell.size() / grid.dim)) < 0) origin |= 1 << d;
    cells[c] = turned(grid.cells[c], grid.dim, origin);
  }
  grid.cells = std::move(cells);
}

}  // namespace femsph::fem
