#pragma once
// The cells of a body before mesh.hpp sorts them, numbered as deal.II numbers them: a grid of deal.II's can
// replace one made here.

#include <array>
#include <optional>

#include "model/scene/shapes/shape.hpp"

namespace femsph::fem {

/// The cells that a body comes with or is cut into; nothing for a box. Throws Refusal if FEM has none.
std::optional<CellMesh> given_cells(const Shape& shape, const std::array<int, 3>& divisions);

/// Throws Refusal if one of the divisions is below 1.
void require_divisions(int dim, const std::array<int, 3>& divisions);

/// The vertices and cells of a body, without unused vertices; other members of the CellMesh stay empty. Cells
/// that share an edge agree on its direction wherever that is possible.
CellMesh make_grid(const Shape& shape, const std::array<int, 3>& divisions);

/// Whether every edge has the same direction in all cells that share it. If not, deal.II renumbers the
/// corners of cells (Agelek, Anderson, Bangerth and Barth, "On orienting edges of unstructured two- and
/// three-dimensional meshes", 2017), and make_grid takes the grid of its module.
bool edges_agree(const CellMesh& grid);

}  // namespace femsph::fem
