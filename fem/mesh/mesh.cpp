#include "fem/mesh/mesh.hpp"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "fem/options.hpp"
#include "model/input/faults.hpp"

namespace femsph::fem {

namespace {

template <int dim>
dealii::Point<dim> to_dealii(const Point& p) {
  dealii::Point<dim> r;
  for (int d = 0; d < dim; ++d) r[d] = p[d];
  return r;
}

template <int dim>
void triangulate_box(const Shape& shape, const std::array<int, 3>& divisions,
                     dealii::Triangulation<dim>& triangulation) {
  std::vector<unsigned int> n(dim);
  for (int d = 0; d < dim; ++d) {
    if (divisions[d] < 1)
      throw Refusal("a box needs at least one cell along each axis, but divisions[" + std::to_string(d) +
                    "] is " + std::to_string(divisions[d]));
    n[d] = static_cast<unsigned int>(divisions[d]);
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, n, to_dealii<dim>(shape.lower()), to_dealii<dim>(shape.upper()));
}

/// deal.II wants cells of positive measure, so left-handed ones are mirrored, and shared edges of one
/// direction: both renumber the corners of a cell, lexicographic as they are.
template <int dim>
void triangulate_cells(const CellMesh& mesh, dealii::Triangulation<dim>& triangulation) {
  std::vector<dealii::Point<dim>> vertices;
  for (const Point& p : mesh.vertices) vertices.push_back(to_dealii<dim>(p));
  std::vector<dealii::CellData<dim>> cells;
  for (const auto& c : mesh.cells) {
    dealii::CellData<dim> cell;
    for (unsigned int a = 0; a < cell.vertices.size(); ++a)
      cell.vertices[a] = static_cast<unsigned int>(c[a]);
    if (dealii::GridTools::cell_measure(vertices, dealii::make_array_view(std::as_const(cell.vertices))) < 0)
      for (unsigned int a = 0; a < cell.vertices.size(); a += 2)
        std::swap(cell.vertices[a], cell.vertices[a + 1]);
    cells.push_back(cell);
  }
  dealii::SubCellData none;
  dealii::GridTools::delete_unused_vertices(vertices, cells, none);
  dealii::GridTools::consistently_order_cells(cells);
  triangulation.create_triangulation(vertices, cells, none);
}

/// Interleaves the bits of three numbers below 2^21: the Z-order curve.
std::uint64_t interleave(const std::array<std::uint64_t, 3>& k) {
  std::uint64_t r = 0;
  for (int bit = 0; bit < 21; ++bit)
    for (int d = 0; d < 3; ++d) r |= ((k[d] >> bit) & 1) << (3 * bit + d);
  return r;
}

/// Cells in compact blocks (64 x 64, or 16 x 16 x 16: one domain of batches) along the Z-order curve, row by
/// row inside a block.
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

template <int dim>
Mesh plain_mesh(const dealii::Triangulation<dim>& triangulation, const Shape& shape) {
  constexpr unsigned int corners = 1u << dim;
  std::vector<std::array<int, corners>> cells;
  std::vector<Point> centres;
  Point size{};  // mean extent of a cell along each axis
  for (const auto& cell : triangulation.active_cell_iterators()) {
    std::array<int, corners> v;
    for (unsigned int a = 0; a < corners; ++a) v[a] = static_cast<int>(cell->vertex_index(a));
    cells.push_back(v);
    const auto centre = cell->center();
    Point p{};
    for (int d = 0; d < dim; ++d) {
      p[d] = centre[d];
      size[d] += cell->extent_in_direction(d) / triangulation.n_active_cells();
    }
    centres.push_back(p);
  }
  Mesh mesh;
  mesh.dim = dim;
  std::vector<int> node(triangulation.n_vertices(), -1);
  const CellMesh* own = shape.cells();  // deal.II keeps the order of the cells that it is given
  for (const std::size_t c : compact_order(centres, shape.lower(), size, dim)) {
    if (own && !own->cell_numbers.empty()) mesh.cell_numbers.push_back(own->cell_numbers[c]);
    for (const int v : cells[c]) {
      if (node[v] < 0) {
        node[v] = static_cast<int>(mesh.vertex.size());
        mesh.vertex.push_back(v);
        for (int d = 0; d < dim; ++d) mesh.nodes.push_back(triangulation.get_vertices()[v][d]);
      }
      mesh.cells.push_back(node[v]);
    }
  }
  return mesh;
}

template <int dim>
Mesh make_mesh_of(const Shape& shape, const std::array<int, 3>& divisions, double distortion) {
  dealii::Triangulation<dim> triangulation;
  make_triangulation<dim>(shape, divisions, distortion, triangulation);
  return plain_mesh<dim>(triangulation, shape);
}

}  // namespace

template <int dim>
void make_triangulation(const Shape& shape, const std::array<int, 3>& divisions, double distortion,
                        dealii::Triangulation<dim, dim>& triangulation) {
  if (const CellMesh* cells = shape.cells())
    triangulate_cells<dim>(*cells, triangulation);
  else if (shape.is_box())
    triangulate_box<dim>(shape, divisions, triangulation);
  else if (const std::optional<CellMesh> cut = shape.cut(divisions))
    triangulate_cells<dim>(*cut, triangulation);
  else
    throw Refusal("FEM has no mesh for a " + shape.describe() +
                  "; give it as a body that comes with its own cells (shape = \"mesh\")");
  if (distortion > 0) dealii::GridTools::distort_random(distortion, triangulation, true, 12345u);
}

template void make_triangulation<2>(const Shape&, const std::array<int, 3>&, double,
                                    dealii::Triangulation<2, 2>&);
template void make_triangulation<3>(const Shape&, const std::array<int, 3>&, double,
                                    dealii::Triangulation<3, 3>&);

Mesh make_mesh(const Shape& shape, const std::array<int, 3>& divisions, double distortion) {
  return shape.dim() == 2 ? make_mesh_of<2>(shape, divisions, distortion)
                          : make_mesh_of<3>(shape, divisions, distortion);
}

std::string deal_ii_version() { return DEAL_II_PACKAGE_VERSION; }

}  // namespace femsph::fem
