#pragma once
// The mesh of a body as deal.II makes it.

#include <array>

#include "model/scene/shapes/shape.hpp"

namespace dealii {
template <int, int>
class Triangulation;
}

namespace femsph::fem {

/// A box becomes divisions[0] x divisions[1] (x divisions[2]) cells, a shape with cells keeps them. Inner
/// vertices are then moved in random directions (fixed seed) by up to `distortion` of their shortest edge.
/// Throws std::runtime_error with one sentence.
template <int dim>
void make_triangulation(const Shape& shape, const std::array<int, 3>& divisions, double distortion,
                        dealii::Triangulation<dim, dim>& triangulation);

/// The vertices and cells of that triangulation.
CellMesh triangulated_grid(const Shape& shape, const std::array<int, 3>& divisions, double distortion);

}  // namespace femsph::fem
