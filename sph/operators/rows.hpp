#pragma once
// The gradient operator of each particle as a row of neighbours, before it is packed for speed:
//   H_i = sum_j (u_j - u_i) (x) w_ij,      w_ij = K_j grad_i W_ij
// with K the volume in kernel sums (of whole cells, or V), and its exact adjoint, the force per volume
//   f_i / K_i = sum_j Q_j a_ij + Q_i S_i,  a_ij = -K_j w_ji / K_i (= w_ij without virtual particles),
//   S_i = sum_j w_ij,
// so that sum_i K_i Q_i : H_i(u) = -sum_i f_i . u_i for any Q and u, and linear momentum is conserved to
// round-off. A stress P_i that fills the volume V_i gives Q_i = (V_i / K_i) P_i.

#include <functional>
#include <vector>

#include "sph/operators/kernel.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

struct Neighbour {
  int index;
  double w[3];   ///< K_j grad_i W_ij, 1/m
  double scale;  ///< K_j steepness(r_ij): w = scale (x_j - x_i), 1/m^2
};
using Row = std::vector<Neighbour>;

/// Makes rows one at a time, so that not all of them are in memory at once.
class RowSource {
 public:
  virtual ~RowSource() = default;
  virtual void row(std::size_t i, Row& out) const = 0;
  /// Sum over i itself and its neighbours of K_j W_ij: 1 inside, less near a free surface.
  virtual double kernel_sum(std::size_t i) const = 0;
};

/// Rows of a regular lattice, from integer offsets: particles with the same neighbours have bitwise equal
/// rows.
std::unique_ptr<RowSource> lattice_rows(const Particles& particles, const Kernel& kernel);
/// The same with virtual particles (fig. 3a of the paper) beyond the sides of a box: a ghost g that mirrors
/// particle m in boundary particle b moves with u_g = 2 u_b - u_m, and every volume in the gradient is d^dim.
std::unique_ptr<RowSource> virtual_rows(const Particles& particles, const Kernel& kernel);
/// Rows of particles anywhere, by a cell list.
std::unique_ptr<RowSource> search_rows(const Particles& particles, const Kernel& kernel);

/// Rows that were made before.
std::unique_ptr<RowSource> stored_rows(std::vector<Row> rows);

/// Adjoint rows a_ij of rows that are not symmetric (virtual particles). Holds all rows at once.
std::unique_ptr<RowSource> transposed_rows(const Particles& particles, const RowSource& rows);

}  // namespace femsph::sph
