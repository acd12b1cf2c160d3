#pragma once
// Cells of a mesh (corners in lexicographic order) as cells of a Topology (corners in VTK order).

#include <array>
#include <vector>

#include "model/motion/bodies/discretization.hpp"

namespace femsph::sph {

/// The lexicographic number of a cell's corner in VTK order; of a square the first four.
inline constexpr std::array<std::size_t, 8> lexicographic{0, 1, 3, 2, 4, 5, 7, 6};

inline Topology topology_of(int dim, const std::vector<std::array<int, 8>>& cells) {
  Topology out{dim == 2 ? Topology::Kind::quadrilaterals : Topology::Kind::hexahedra, {}};
  out.cells.reserve(cells.size());
  for (const auto& own : cells) {
    std::array<std::size_t, 8> cell{};
    for (std::size_t v = 0; v < std::size_t(1) << dim; ++v) cell[v] = std::size_t(own[lexicographic[v]]);
    out.cells.push_back(cell);
  }
  return out;
}

}  // namespace femsph::sph
