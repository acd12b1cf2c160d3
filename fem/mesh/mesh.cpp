#include "fem/mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "fem/mesh/deal_ii.hpp"
#include "fem/mesh/grid.hpp"

namespace femsph::fem {

namespace {

/// Position on the Z-order (Morton) curve: interleaves the bits of three numbers below 2^21.
std::uint64_t interleave(const std::array<std::uint64_t, 3>& k) {
  std::uint64_t r = 0;
  for (int bit = 0; bit < 21; ++bit)
    for (int d = 0; d < 3; ++d) r |= ((k[d] >> bit) & 1) << (3 * bit + d);
  return r;
}

/// Orders the cells in compact blocks (64 x 64, or 16 x 16 x 16: one domain of batches). Blocks follow the
/// Z-order curve; inside a block cells go row by row.
std::vector<std::size_t> compact_order(const std::vector<Point>& centres, const Point& lower,
                                       const Point& size, int dim) {
  using Key = std::array<std::uint64_t, 4>;
  const std::uint64_t block = dim == 2 ? 64 : 16;
  std::vector<Key> keys(centres.size());
  for (std::size_t c = 0; c < centres.size(); ++c) {
    std::array<std::uint64_t, 3> index{}, tile{};
    for (int d = 0; d < dim; ++d) {
      index[d] = static_cast<std::uint64_t>(std::max(0.0, std::floor((centres[c][d] - lower[d]) / size[d])));
      tile[d] = index[d] / block;
    }
    keys[c] = {interleave(tile), index[2], index[1], index[0]};
  }
  std::vector<std::size_t> order(centres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(
      order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

double edge_length(const Point& a, const Point& b) {
  double square = 0;
  for (int d = 0; d < 3; ++d) square += (b[d] - a[d]) * (b[d] - a[d]);
  return std::sqrt(square);
}

/// The longest edge of a cell along its axis `d`.
double extent(const CellMesh& grid, const std::array<int, 8>& cell, int d) {
  double longest = 0;
  for (int a = 0; a < 1 << grid.dim; ++a)
    if (!(a >> d & 1))
      longest = std::max(longest, edge_length(grid.vertices[cell[a]], grid.vertices[cell[a | 1 << d]]));
  return longest;
}

Point centre(const CellMesh& grid, const std::array<int, 8>& cell) {
  Point p{};
  for (int a = 0; a < 1 << grid.dim; ++a)
    for (int d = 0; d < grid.dim; ++d) p[d] += grid.vertices[cell[a]][d];
  for (int d = 0; d < grid.dim; ++d) p[d] /= 1 << grid.dim;
  return p;
}

}  // namespace

Mesh make_mesh(const Shape& shape, const std::array<int, 3>& divisions, double distortion) {
  const CellMesh grid = distortion > 0 ? deal_ii().grid(shape, divisions, distortion)
                                       : make_grid(shape, divisions);
  const std::size_t dim = static_cast<std::size_t>(grid.dim);
  std::vector<Point> centres;
  centres.reserve(grid.cells.size());
  Point size{};  // mean extent of a cell along each axis
  for (const auto& cell : grid.cells) {
    centres.push_back(centre(grid, cell));
    for (std::size_t d = 0; d < dim; ++d)
      size[d] += extent(grid, cell, static_cast<int>(d)) / static_cast<double>(grid.cells.size());
  }
  Mesh mesh;
  mesh.dim = grid.dim;
  mesh.cells.reserve(grid.cells.size() << dim);
  mesh.nodes.reserve(grid.vertices.size() * dim);
  mesh.vertex.reserve(grid.vertices.size());
  std::vector<int> node(grid.vertices.size(), -1);
  const CellMesh* own = shape.cells();
  for (const std::size_t c : compact_order(centres, shape.lower(), size, grid.dim)) {
    if (own && !own->cell_numbers.empty()) mesh.cell_numbers.push_back(own->cell_numbers[c]);
    for (int a = 0; a < mesh.corners(); ++a) {
      const int v = grid.cells[c][a];
      if (node[v] < 0) {
        node[v] = static_cast<int>(mesh.vertex.size());
        mesh.vertex.push_back(v);
        for (std::size_t d = 0; d < dim; ++d) mesh.nodes.push_back(grid.vertices[v][d]);
      }
      mesh.cells.push_back(node[v]);
    }
  }
  return mesh;
}

}  // namespace femsph::fem
