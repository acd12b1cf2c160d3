#include "fem/mesh/grid.hpp"

#include <set>
#include <string>
#include <utility>

#include "fem/mesh/deal_ii.hpp"
#include "fem/mesh/gauss.hpp"
#include "model/input/faults.hpp"

namespace femsph::fem {

namespace {

CellMesh box_grid(const Shape& box, const std::array<int, 3>& divisions) {
  const int dim = box.dim();
  require_divisions(dim, divisions);
  const Point from = box.lower(), to = box.upper();
  std::array<int, 3> n{0, 0, 0};
  Point step{};
  for (int d = 0; d < dim; ++d) n[d] = divisions[d], step[d] = (to[d] - from[d]) / n[d];
  CellMesh grid;
  grid.dim = dim;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        grid.vertices.push_back(
            {from[0] + i * step[0], from[1] + j * step[1], dim == 3 ? from[2] + k * step[2] : 0.0});
  const int row = n[0] + 1, layer = row * (n[1] + 1);
  for (int k = 0; k < (dim == 3 ? n[2] : 1); ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 8> cell{};
        for (int a = 0; a < 1 << dim; ++a)
          cell[a] = i + (a & 1) + row * (j + (a >> 1 & 1)) + layer * (k + (a >> 2));
        grid.cells.push_back(cell);
      }
  return grid;
}

/// Area or volume of a cell, negative if it is left-handed.
template <int dim>
double measure(const CellMesh& grid, const std::array<int, 8>& cell) {
  double X[corners<dim> * dim];
  for (int a = 0; a < corners<dim>; ++a)
    for (int d = 0; d < dim; ++d) X[a * dim + d] = grid.vertices[cell[a]][d];
  const GaussCell<double, dim> x(X);
  double sum = 0;
  Tensor<double, dim> unused;
  for (int q = 0; q < corners<dim>; ++q) sum += cofactors<double, dim>(x.at(q), unused);
  return sum;
}

/// Renumbers the corners of left-handed cells (reversed along the first axis): deal.II expects cells of
/// positive volume.
void mirror_left_handed(CellMesh& grid) {
  for (auto& cell : grid.cells)
    if ((grid.dim == 2 ? measure<2>(grid, cell) : measure<3>(grid, cell)) < 0)
      for (int a = 0; a < 1 << grid.dim; a += 2) std::swap(cell[a], cell[a + 1]);
}

void drop_unused_vertices(CellMesh& grid) {
  std::vector<int> number(grid.vertices.size(), -1);
  for (const auto& cell : grid.cells)
    for (int a = 0; a < 1 << grid.dim; ++a) number[cell[a]] = 0;
  std::size_t used = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] == 0) {
      number[v] = static_cast<int>(used);
      grid.vertices[used++] = grid.vertices[v];
    }
  grid.vertices.resize(used);
  for (auto& cell : grid.cells)
    for (int a = 0; a < 1 << grid.dim; ++a) cell[a] = number[cell[a]];
}

}  // namespace

void require_divisions(int dim, const std::array<int, 3>& divisions) {
  for (int d = 0; d < dim; ++d)
    if (divisions[d] < 1)
      throw Refusal("a box needs at least one cell along each axis, but divisions[" + std::to_string(d) +
                    "] is " + std::to_string(divisions[d]));
}

std::optional<CellMesh> given_cells(const Shape& shape, const std::array<int, 3>& divisions) {
  if (const CellMesh* cells = shape.cells()) return *cells;
  if (shape.is_box()) return std::nullopt;
  if (std::optional<CellMesh> cut = shape.cut(divisions)) return cut;
  throw Refusal("FEM has no mesh for a " + shape.describe() + "; give the body as a mesh (shape = \"mesh\")");
}

bool edges_agree(const CellMesh& grid) {
  std::set<std::pair<int, int>> seen;
  for (const auto& cell : grid.cells)
    for (int d = 0; d < grid.dim; ++d)
      for (int a = 0; a < 1 << grid.dim; ++a) {
        if (a >> d & 1) continue;
        const int from = cell[a], to = cell[a | 1 << d];
        if (seen.count({to, from})) return false;
        seen.insert({from, to});
      }
  return true;
}

CellMesh make_grid(const Shape& shape, const std::array<int, 3>& divisions) {
  std::optional<CellMesh> given = given_cells(shape, divisions);
  if (!given) return box_grid(shape, divisions);
  CellMesh grid;
  grid.dim = shape.dim();
  grid.vertices = std::move(given->vertices);
  grid.cells = std::move(given->cells);
  mirror_left_handed(grid);
  drop_unused_vertices(grid);
  if (!edges_agree(grid)) return deal_ii().grid(shape, divisions, 0.0);
  return grid;
}

}  // namespace femsph::fem
