#include "fem/limit/triangulation.hpp"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <utility>

#include "fem/limit/points.hpp"
#include "fem/mesh/grid.hpp"

namespace femsph::fem {

namespace {

template <int dim>
void triangulate_box(const Shape& shape, const std::array<int, 3>& divisions,
                     dealii::Triangulation<dim>& triangulation) {
  std::vector<unsigned int> n(dim);
  require_divisions(dim, divisions);
  for (int d = 0; d < dim; ++d) n[d] = static_cast<unsigned int>(divisions[d]);
  dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, n, to_dealii<dim>(shape.lower()), to_dealii<dim>(shape.upper()));
}

/// deal.II expects cells of positive volume whose shared edges have the same direction in both cells. So
/// left-handed cells are reversed and edges reordered; both renumber the corners of a cell, which stay
/// lexicographic.
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

template <int dim>
CellMesh grid_of(const dealii::Triangulation<dim>& triangulation) {
  CellMesh grid;
  grid.dim = dim;
  for (const dealii::Point<dim>& v : triangulation.get_vertices()) grid.vertices.push_back(to_point<dim>(v));
  for (const auto& cell : triangulation.active_cell_iterators()) {
    std::array<int, 8> corners{};
    for (unsigned int a = 0; a < 1u << dim; ++a) corners[a] = static_cast<int>(cell->vertex_index(a));
    grid.cells.push_back(corners);
  }
  return grid;
}

template <int dim>
CellMesh triangulated(const Shape& shape, const std::array<int, 3>& divisions, double distortion) {
  dealii::Triangulation<dim> triangulation;
  make_triangulation<dim>(shape, divisions, distortion, triangulation);
  return grid_of<dim>(triangulation);
}

}  // namespace

template <int dim>
void make_triangulation(const Shape& shape, const std::array<int, 3>& divisions, double distortion,
                        dealii::Triangulation<dim, dim>& triangulation) {
  if (const auto cells = given_cells(shape, divisions))
    triangulate_cells<dim>(*cells, triangulation);
  else
    triangulate_box<dim>(shape, divisions, triangulation);
  if (distortion > 0) dealii::GridTools::distort_random(distortion, triangulation, true, 12345u);
}

template void make_triangulation<2>(const Shape&, const std::array<int, 3>&, double,
                                    dealii::Triangulation<2, 2>&);
template void make_triangulation<3>(const Shape&, const std::array<int, 3>&, double,
                                    dealii::Triangulation<3, 3>&);

CellMesh triangulated_grid(const Shape& shape, const std::array<int, 3>& divisions, double distortion) {
  return shape.dim() == 2 ? triangulated<2>(shape, divisions, distortion)
                          : triangulated<3>(shape, divisions, distortion);
}

}  // namespace femsph::fem
