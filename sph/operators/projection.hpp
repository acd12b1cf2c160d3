#pragma once
// Rows of corrected SPH on scattered particles for which a uniform stress is in equilibrium with its
// tractions to round-off. A uniform stress P loads particle i with P A_i, where
//   A_i = sum_k V_k G_ki - V_i sum_j G_ij,      G_ij = scale_ij B_i x_ij,   B_i = (sum_j scale_ij x_ij (x)
//   x_ij)^-1.
// Whatever the scales, sum_i A_i = 0 and sum_i x_i (x) A_i = (sum V) I, as for the area vectors a_i of a
// closed surface; but A_i = a_i holds on lattices only. The projection is the smallest relative change of the
// scales for which A_i = a_i:
//   minimise sum_i sum_j (d scale_ij)^2 / scale_ij   subject to   A(scale + d scale) = a.
// Rows stay least-squares fits, scale times x: linear fields stay exact and the gradient costs what it did.
// Only the adjoint needs weights of its own.

#include <memory>
#include <string>
#include <vector>

#include "sph/operators/rows.hpp"

namespace femsph::sph {

struct Projection {
  std::unique_ptr<RowSource> rows;  ///< w_ij = scale_ij x_ij; `scale` is the symmetric mean of rows.hpp's L:
                                    ///< (scale_ij + K_j scale_ji / K_i) / 2
  std::unique_ptr<RowSource> adjoint;  ///< a_ij = (K_j / K_i) scale_ji x_ij
  double left = 0;                     ///< largest remaining |A_i - a_i| over the largest |a_i|
  int iterations = 0;                  ///< of conjugate gradients
  bool needless = false;               ///< the imbalance of the kernel's rows is below `worth_projecting`
};

/// Rows with a smaller imbalance are not projected: those of rings and other bodies of one smooth block,
/// whose displacements the projection makes slightly worse.
inline constexpr double worth_projecting = 0.05;

/// `area`: the a_i of the body's own particles, with sum x (x) a = (sum of `volume`) I. `volume`: the volumes
/// that the stress fills, of the body with its images. The result has no `rows` if no such scales were found;
/// `left` is the imbalance that was reached.
Projection project(const Particles& particles, const RowSource& rows, const std::vector<Point>& area,
                   const std::vector<double>& volume);

}  // namespace femsph::sph
