#pragma once
// A pressure on a side that cuts a lattice, such that a uniform stress is in balance with it.
// The operator's own area vectors are A_i = sum_k V_k G_ki - V_i sum_j G_ij: forces -p A_i hold the uniform
// stress -p I exactly. Near a side that the lattice fills in steps they are spread over three layers. With
// h^s the integrals of the hat functions times n over side s, side s has
//   A_i^s = h_i^s + theta_i^s (A_i - sum_t h_i^t) + c_i^s,      theta_i^s = 1 if the piece of the boundary
//   nearest to particle i is of s, else 0.
// Where sides meet, this would take from one what belongs to the next: c hands it back, particle by particle,
// c_i^s = sum_t w_i (m_s - m_t), with rigid motions m_s such that each side has its own force and moment. All
// sides together have A_i.

#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "sph/operators/kernel.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

/// A_i of the body's own particles, m^(dim - 1).
std::vector<Point> operator_areas(const Particles& particles, const Kernel& kernel, const Options& options);

/// A^s of the first side; what `pieces` of all sides give to particles by the hats is `hats`, and `areas` are
/// the A_i.
std::vector<PointArea> balanced_side(
    const Particles& particles, const std::vector<std::vector<SidePiece>>& pieces,
    const std::vector<std::vector<PointArea>>& hats, std::vector<Point> areas, double radius);

/// Of a mesh: all free sides of its cells.
std::vector<SidePiece> free_sides(const CellMesh& mesh, double size);

}  // namespace femsph::sph
