#pragma once
// Plain geometry of the mesh, needed once: shape functions, lumped masses, edges, and the shares of places.

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
/// det d X / d xi there.
double jacobian(const Mesh& mesh, std::size_t cell, int q);

/// Row-sum lumping, m_a = integral of density N_a: exact total mass and first moment.
std::vector<double> lumped_mass(const Mesh& mesh, double density, double thickness);
double shortest_edge(const Mesh& mesh);

/// Nodes of a place with the share of a unit total force that a uniform traction gives each: over the facets
/// on one side, along the edges on two sides of a solid, in equal parts on corners; the nearest node of a
/// point; by mass over a whole body.
std::vector<Weight> place_weights(const Mesh& mesh, const Shape& shape, const Place& place,
                                  std::span<const double> mass, double tolerance);

}  // namespace femsph::fem
