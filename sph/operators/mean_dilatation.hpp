#pragma once
// Mean dilatation over neighbours, for bodies that keep their volume (nearly incompressible, or in plastic
// flow). A gradient at the particles is zero for displacements that alternate from layer to layer, so the
// pressure of a nearly incompressible body can alternate. The law is given the change of volume
//   theta-bar_i = theta_i + (D theta)_i,   (D x)_i = sum_j N_ij (x_j - x_i),   N_ij = r_i r_j V_j
//   2^(-r^2/d^2) / (2^dim d^dim min(f_i, f_j)),  r < 2 d,
// in place of theta_i (small motion: the trace of the strain; large: ln J). On a lattice r_i = 1 and N is the
// product of (1/4, 1/2, 1/4) along each axis, reflected at faces: alternating fields become 0, constants
// stay. Elsewhere r_i makes the sum of a row, with N_ii, one. V_i N_ij is symmetric, so D is its own adjoint,
//   sum_i V_i p_i (D theta)_i = sum_i V_i (D p)_i theta_i,
// and the force is that of the mean stress p_i + (D p)_i, p_i being that of the law; the sum is the stress
// that is written. Energy and momenta are conserved as without it. In finite elements: Nagtegaal, Parks &
// Rice 1974; over the cells around a node: Bonet & Burton 1998.

#include <cmath>

#include "model/material/kinematics.hpp"
#include "model/numerics/elementary.hpp"
#include "sph/operators/stencils.hpp"
#include "sph/particles/cell_list.hpp"

namespace femsph::sph {

/// Rows of N: w[0] = N_ij.
class AveragingRows final : public RowSource {
 public:
  explicit AveragingRows(const Particles& particles);
  void row(std::size_t i, Row& out) const override;
  double kernel_sum(std::size_t) const override { return 1; }

 private:
  void collect(std::size_t i, Row& out) const;
  const Particles& p_;
  CellList cells_;
  std::vector<double> scale_;  ///< r_i
};

/// D, and the two fields that it averages, each stored like one component of a vector field, mirrored
/// particles included.
template <class Stencils>
class MeanDilatation {
 public:
  MeanDilatation(const Particles& particles, std::size_t offset, std::size_t stride)
      : stencils_(AveragingRows(particles), particles.size()),
        offset_(offset),
        volume_(stride, 0.0),
        pressure_(stride, 0.0) {}
  std::size_t bytes() const {
    return stencils_.bytes() + (volume_.size() + pressure_.size()) * sizeof(double);
  }

  double* volume(std::size_t block) { return &volume_[offset_ + block * lanes]; }      ///< theta of a block
  double* pressure(std::size_t block) { return &pressure_[offset_ + block * lanes]; }  ///< p
  FEMSPH_INLINE Pack volume_excess(std::size_t block) const { return excess(block, volume_); }
  FEMSPH_INLINE Pack pressure_excess(std::size_t block) const { return excess(block, pressure_); }
  void mirror_volume(const Particles& p) { mirror(p, volume_); }
  void mirror_pressure(const Particles& p) { mirror(p, pressure_); }
  /// Marks the blocks whose values D needs in a block.
  void mark(std::size_t block, const Particles& p, std::vector<char>& needed) const {
    needed[block] = 1;
    stencils_.each_index(
        block, [&](std::size_t j) { needed[(j < p.size() ? j : p.mirrored[j - p.size()].of) / lanes] = 1; });
  }

 private:
  FEMSPH_INLINE Pack excess(std::size_t block, const AlignedVector<double>& field) const {
    Tensor<Pack, 1> sum;
    Pack none[1];
    stencils_.template gradient<false>(block, &field[offset_ + block * lanes], 0, sum, none);
    return sum[0][0];
  }
  void mirror(const Particles& p, AlignedVector<double>& field) {
    for (std::size_t k = 0; k < p.mirrored.size(); ++k)
      field[offset_ + p.size() + k] = field[offset_ + p.mirrored[k].of];
  }
  Stencils stencils_;
  std::size_t offset_;
  AlignedVector<double> volume_, pressure_;
};

/// The change of volume in small and in large motion.
template <class Motion, int dim>
struct VolumeChange {
  static constexpr bool small = std::is_same_v<Motion, SmallStrain>,
                        biot = std::is_same_v<Motion, FiniteRotation>;

  /// theta
  FEMSPH_INLINE static Pack of(const Tensor<Pack, dim>& H) {
    if constexpr (small) {
      Pack t = H[0][0];
      for (int a = 1; a < dim; ++a) t += H[a][a];
      return t;
    } else {
      return log_of_1_plus(growth_of(H));
    }
  }
  /// Adds x to theta of the strain: e + x/dim, or U <- r U with r = exp(x/dim), which is returned.
  FEMSPH_INLINE static Pack add(const Pack& x, Symmetric<Pack, dim>& e) {
    const Pack share = x * (1.0 / dim);
    if constexpr (small) {
      for (int a = 0; a < dim; ++a) e[a] += share;
      return share;
    } else {
      const Pack r = exponential(share);
      for (int k = 0; k < symmetric_size<dim>; ++k) e[k] *= r;
      for (int a = 0; a < dim; ++a) e[a] += r - 1.0;
      return r;
    }
  }
  /// The work of the law's stress per theta and volume, Pa: its trace / dim, or T : r U / dim of a Biot
  /// stress T.
  FEMSPH_INLINE static Pack work(const Symmetric<Pack, dim>& enlarged, const Symmetric<Pack, dim>& stress) {
    Pack p = trace(stress);
    if constexpr (biot) p += contract(stress, enlarged);
    return p * (1.0 / dim);
  }
  /// The stress that works on the unscaled motion: a Biot stress works on d(r U).
  FEMSPH_INLINE static void scale(const Pack& r, Tensor<Pack, dim>& P) {
    if constexpr (biot)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) P[i][j] *= r;
  }
  /// d theta = C : dH, C = 1 or F^-T.
  FEMSPH_INLINE static Tensor<Pack, dim> direction(const Tensor<Pack, dim>& H) {
    Tensor<Pack, dim> C{}, F = H, inverse;
    for (int a = 0; a < dim; ++a) F[a][a] += 1.0;
    if constexpr (small) {
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) C[i][j] = broadcast<Pack>(i == j ? 1.0 : 0.0);
    } else {
      invert(F, inverse);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) C[i][j] = inverse[j][i];
    }
    return C;
  }

 private:
  /// J - 1 = tr H + (minors of H), accurate for small strains.
  FEMSPH_INLINE static Pack growth_of(const Tensor<Pack, dim>& H) {
    if constexpr (dim == 2)
      return H[0][0] + H[1][1] + (H[0][0] * H[1][1] - H[0][1] * H[1][0]);
    else {
      const Pack xy = H[0][0] * H[1][1] - H[0][1] * H[1][0], yz = H[1][1] * H[2][2] - H[1][2] * H[2][1],
                 zx = H[2][2] * H[0][0] - H[2][0] * H[0][2];
      return H[0][0] + H[1][1] + H[2][2] + (xy + yz + zx) +
             (H[0][0] * yz + H[0][1] * (H[1][2] * H[2][0] - H[1][0] * H[2][2]) +
              H[0][2] * (H[1][0] * H[2][1] - H[1][1] * H[2][0]));
    }
  }
};

}  // namespace femsph::sph
