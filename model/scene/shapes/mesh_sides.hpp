#pragma once
// The sides of a mesh's cells (edges in a plane, faces in space), by their vertices.

#include <algorithm>
#include <array>
#include <vector>

#include "model/scene/shapes/shape.hpp"

namespace femsph {

/// The vertices of a side in increasing order; in a plane two entries of -1 come first. Equal sides have
/// equal keys.
using SideKey = std::array<int, 4>;

inline SideKey side_key(const std::array<int, 4>& vertices, int dim) {
  SideKey key{-1, -1, -1, -1};
  std::copy_n(vertices.begin(), 1 << (dim - 1), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/// The vertices of each side of a cell in lexicographic order, counterclockwise seen from outside.
inline constexpr int side_loops_2d[4][2] = {{2, 0}, {1, 3}, {0, 1}, {3, 2}};
inline constexpr int side_loops_3d[6][4] = {
    {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

/// Calls act(cell, loop) with the vertices of each side of each cell.
template <class Act>
void for_each_side(const CellMesh& mesh, Act&& act) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int s = 0; s < 2 * mesh.dim; ++s) {
      std::array<int, 4> loop{-1, -1, -1, -1};
      for (int v = 0; v < 1 << (mesh.dim - 1); ++v)
        loop[v] = mesh.cells[c][mesh.dim == 2 ? side_loops_2d[s][v] : side_loops_3d[s][v]];
      act(int(c), loop);
    }
}

/// A side that belongs to one cell only.
struct FreeSide {
  std::array<int, 4> loop;
  int cell;
};

}  // namespace femsph
