#pragma once
// The check of a mesh for errors that would change the body from the one that was drawn. Messages use the
// numbers of the mesh file.

#include <string>
#include <vector>

#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/mesh_sides.hpp"

namespace femsph {

/// Reverses mirrored cells, and throws std::runtime_error with one sentence for:
///   cells that use a vertex twice, are flat, or are folded at a Gauss point (where elements compute
///   gradients); sides that belong to more than two cells; cells that overlap, on the same side of a common
///   side; open seams, that is, free sides that coincide, or vertices that lie on a side of a cell that does
///   not have them (within a thousandth of the cells' edges); another number of pieces than the scene says.
/// `file` is the name for messages. The time it takes is about that of sorting the sides.
void check_mesh(CellMesh& mesh, const MeshOptions& options, const std::string& file);

/// Cells with a zero or negative Jacobian at a corner, although it is positive at the Gauss points. A method
/// that computes gradients at corners cannot use them.
std::vector<int> cells_with_bad_corners(const CellMesh& mesh);

/// The number in the file, or counted from 1 if there is no file.
std::size_t cell_number(const CellMesh& mesh, int cell);
std::size_t vertex_number(const CellMesh& mesh, int vertex);

/// Throws std::runtime_error if there are open seams between these sides.
void check_seams(const CellMesh& mesh, const std::vector<FreeSide>& sides, const std::string& file);

/// "(1, 0.5) mm"
std::string place_text(const Point& p, int dim);

}  // namespace femsph
