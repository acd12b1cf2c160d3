#pragma once
// Geometry of the mesh at set-up and for output: shape functions, lumped masses, edges, and the weights of
// places.

#include <span>
#include <vector>

#include "fem/mesh/mesh.hpp"
#include "model/motion/bodies/discretization.hpp"

namespace femsph::fem {

/// Q1 shape functions at reference coordinates in [-1, 1]^dim, lexicographic.
std::array<double, 8> shape_functions(int dim, const Point& xi);
/// Image of reference coordinates in a cell.
Point map_point(const Mesh& mesh, std::size_t cell, const Point& xi);
/// Reference coordinates of Gauss point q.
Point gauss_coordinates(int dim, int q);
/// det dX/dxi at Gauss point q.
double jacobian(const Mesh& mesh, std::size_t cell, int q);

/// Row-sum lumping, m_a = integral of density N_a: exact total mass and first moment.
std::vector<double> lumped_mass(const Mesh& mesh, double density, double thickness);
double shortest_edge(const Mesh& mesh);

/// The nodes of a place, each with its share of a unit force: for a side the share of a uniform traction over
/// its facets, for two sides of a solid that over its edges, for corners equal parts, for a point the nearest
/// node alone, for a whole body the share of its mass. `tolerance`: m.
std::vector<Weight> place_weights(const Mesh& mesh, const Shape& shape, const Place& place,
                                  std::span<const double> mass, double tolerance);

}  // namespace femsph::fem
