#pragma once
// The mesh that the cell loops work on.

#include <array>
#include <string>
#include <vector>

#include "model/scene/shapes/shape.hpp"

namespace femsph::fem {

struct Mesh {
  int dim = 2;
  std::vector<double> nodes;  ///< m, interleaved: node * dim + component
  std::vector<int> cells;     ///< 2^dim nodes per cell, lexicographic; cells and nodes ordered so that
                              ///< neighbours are near in memory
  std::vector<int> vertex;    ///< node -> vertex of the grid it came from (grid.hpp)
  std::vector<std::size_t>
      cell_numbers;  ///< numbers in the mesh file; empty if the body does not come from one

  int corners() const { return 1 << dim; }
  std::size_t node_count() const { return nodes.size() / static_cast<std::size_t>(dim); }
  std::size_t cell_count() const { return cells.size() / static_cast<std::size_t>(corners()); }
  /// "cell 12", for messages: by its number in the mesh file, if there is one.
  std::string cell_name(std::size_t c) const {
    return "cell " + std::to_string(cell_numbers.empty() ? c : cell_numbers[c]);
  }
  const int* cell(std::size_t c) const { return cells.data() + c * static_cast<std::size_t>(corners()); }
  Point node(std::size_t i) const {
    const double* x = nodes.data() + i * static_cast<std::size_t>(dim);
    return {x[0], x[1], dim == 3 ? x[2] : 0.0};
  }
};

/// A box becomes divisions[0] x divisions[1] (x divisions[2]) cells, a shape with cells keeps them. Inner
/// vertices are then moved in random directions (fixed seed) by up to `distortion` of their shortest edge.
/// Throws std::runtime_error with one sentence.
Mesh make_mesh(const Shape& shape, const std::array<int, 3>& divisions, double distortion);

}  // namespace femsph::fem
