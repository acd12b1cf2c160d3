#pragma once
// One look at all of a mesh: whatever would make the body another one than its author drew is found here, and
// said by the file's own numbers.

#include <string>
#include <vector>

#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/mesh_sides.hpp"

namespace femsph {

/// Turns mirrored cells, and throws std::runtime_error with one sentence for
///   cells that use a vertex twice, are flat, or are folded at a Gauss point (where every element takes its
///   gradients); sides of more than two cells, and two cells on the same side of the side they share; open
///   seams: free sides that lie on each other, vertices that hang on a side of another cell (within a
///   thousandth of the cells' edges); more or fewer pieces than the scene says.
/// `file` names the mesh. The time is that of sorting the sides.
void check_mesh(CellMesh& mesh, const MeshWish& wish, const std::string& file);

/// Cells that are sound at their Gauss points and not convex at a corner (there the Jacobian is zero or
/// negative). What takes gradients or shares at corners cannot use them.
std::vector<int> cells_with_bad_corners(const CellMesh& mesh);

/// By the file's numbers, or counted from 1 if there is no file.
std::size_t cell_number(const CellMesh& mesh, int cell);
std::size_t vertex_number(const CellMesh& mesh, int vertex);

/// Throws for the open seams among these sides.
void check_seams(const CellMesh& mesh, const std::vector<FreeSide>& sides, const std::string& file);

/// "(1, 0.5) mm"
std::string place_text(const Point& p, int dim);

}  // namespace femsph
