#pragma once
// The cells of a body before they are put in order: numbered as deal.II numbers them, so that either can
// stand for the other.

#include <array>
#include <optional>

#include "model/scene/shapes/shape.hpp"

namespace femsph::fem {

/// The cells that a body comes with or is cut into; nothing for a box. Throws Refusal if FEM has none.
std::optional<CellMesh> given_cells(const Shape& shape, const std::array<int, 3>& divisions);

/// Throws Refusal unless a box can be cut so.
void require_divisions(int dim, const std::array<int, 3>& divisions);

/// Vertices and cells (of the rest of a CellMesh nothing), no vertex unused, the directions of the edges that
/// cells share equal wherever they can be.
CellMesh make_grid(const Shape& shape, const std::array<int, 3>& divisions);

/// Edges that cells share have one direction in all of them. Where they have not, deal.II turns the cells
/// (Agelek, Anderson, Bangerth and Barth, "On orienting edges of unstructured two- and three-dimensional
/// meshes", 2017), and such a grid comes from its module.
bool edges_agree(const CellMesh& grid);

}  // namespace femsph::fem
