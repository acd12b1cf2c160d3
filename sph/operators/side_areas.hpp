#pragma once
// Forces of a pressure on a side that cuts the lattice, in balance with a uniform stress.
// The area vectors of the operator are A_i = sum_k V_k G_ki - V_i sum_j G_ij: forces -p A_i balance the
// uniform stress -p I exactly. Near a side that cuts the lattice they spread over three layers. With h^s the
// integrals of the hat functions times the normal over side s, side s has
//   A_i^s = h_i^s + theta_i^s (A_i - sum_t h_i^t) + c_i^s,      theta_i^s = 1 if the piece of the boundary
//   nearest to particle i is of s, else 0.
// Where sides meet, the first two terms alone give a part of one side's force to its neighbour. The exchange
// c_i^s = sum_t w_i (m_s - m_t) corrects that, with rigid motions m_s for which each side has its own force
// and moment. The sum over all sides is A_i.

#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "sph/operators/kernel.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

/// A_i of the body's own particles, m^(dim - 1).
std::vector<Point> operator_areas(const Particles& particles, const Kernel& kernel, const Options& options);

/// A^s of the first side, from the pieces of all sides, the areas `hats` that the pieces of each side give to
/// particles by the hat functions, and the A_i, `areas`.
std::vector<PointArea> balanced_side(
    const Particles& particles, const std::vector<std::vector<SidePiece>>& pieces,
    const std::vector<std::vector<PointArea>>& hats, std::vector<Point> areas, double radius);

/// The free sides of the cells of a mesh, in pieces of about `size`, m.
std::vector<SidePiece> free_sides(const CellMesh& mesh, double size);

}  // namespace femsph::sph
