#pragma once
// A pressure on a side that cuts a lattice, such that a uniform stress is in balance with it.
// The operator's own area vectors are A_i = sum_k V_k G_ki - V_i sum_j G_ij: forces -p A_i hold the uniform stress -p I exactly. Near a side that the
// lattice fills in steps they are spread over three layers. Side s gets of them
//   A_i^s = h_i^s + (A_i - sum_t h_i^t) if the piece of the boundary nearest to particle i is of s,    h_i^s else,
// with h^t the integrals of the hat functions times n over side t, whose sum is the area vector of t and whose moment is its moment. All sides together
// have the A_i: exact under one pressure all around. Of one side alone, the force may differ from its own by what the layers at its ends exchange.

#include <vector>

#include "model/motion/discretization.hpp"
#include "sph/kernel.hpp"
#include "sph/particles.hpp"

namespace femsph::sph {

/// A_i of the body's own particles, m^(dim - 1).
std::vector<Point> operator_areas(const Particles& particles, const Kernel& kernel, const Options& options);

/// For each particle within `radius` of the boundary: is the nearest piece one of `mine`? A tie counts by its share.
std::vector<double> nearest_to(const Particles& particles, const std::vector<SidePiece>& mine, const std::vector<SidePiece>& others, double radius);

/// Of a mesh: all free sides of its cells.
std::vector<SidePiece> free_sides(const CellMesh& mesh, double size);

}  // namespace femsph::sph
