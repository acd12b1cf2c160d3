#pragma once
// The SPH gradient on initial neighbours and its exact adjoint (rows.hpp), in SIMD form:
//   H_i = sum_j (u_j - u_i) (x) w_ij, times the correction B_i if any;   f_i = K_i [ sum_j Q_j a_ij + Q_i S_i
//   ],  S_i = sum_j w_ij,
// where Q_i = (V_i / K_i) P_i B_i for a stress P_i that fills the volume V_i.
// Corrected: B_i = (sum_j w_ij (x) x_ij)^-1 makes the gradient of linear fields exact (Randles & Libersky
// 1996; Bonet & Lok 1999) without touching w. A field is one padded row per component, `stride` apart.

#include <memory>

#include "model/numerics/array.hpp"
#include "sph/operators/stencils.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

enum class Correction { none, matrix, matrix_and_hourglass, hourglass_and_mean_dilatation };

std::unique_ptr<RowSource> rows_of(const Particles& particles, const Kernel& kernel, const Options& options);

struct OperatorRows {
  std::unique_ptr<RowSource> rows;
  std::unique_ptr<RowSource> adjoint;  ///< where they are not symmetric: virtual particles, projection
  bool projected = false;
  double fill = 1;   ///< part of V_i that the stress fills: cells with straight sides enclose somewhat less
                     ///< than a round body
  std::string note;  ///< a warning for the user; empty: none
};
/// `area`: the area vectors with which a uniform stress must be in balance (projection.hpp), one for each
/// particle of the body, areas on symmetry planes included; empty: the rows of the kernel are taken.
OperatorRows operator_rows(const Particles& particles, const Kernel& kernel, const Options& options,
                           const std::vector<Point>& area);

/// B of a particle whose row is `row`. With Boundary::weight (fig. 3b of the paper) B is the factor for which
/// the kernel sums to one. Throws Refusal if the particle has too few neighbours.
Tensor<double, 3> correction_of(const Particles& particles, std::size_t particle, const RowSource& rows,
                                const Row& row, Boundary boundary);

template <int dim, class Stencils, bool corrected>
class GradientOperator {
  static constexpr int n_symmetric = symmetric_size<dim>;

 public:
  GradientOperator(const Particles& particles, const Kernel& kernel, const Options& options, double thickness,
                   const std::vector<Point>& area)
      : GradientOperator(
            particles, operator_rows(particles, kernel, options, area), options.boundary, thickness) {}

  std::size_t blocks() const { return stencils_.blocks(); }
  std::size_t bytes() const {
    return stencils_.bytes() + (adjoint_ ? adjoint_->bytes() : 0) +
           (s_.size() + v_.size() + k_.size() + part_.size() + b_.size()) * sizeof(double);
  }
  const Stencils& stencils() const { return stencils_; }
  bool projected() const { return projected_; }
  const std::string& note() const { return note_; }
  /// The volume that the stress fills, with thickness, m^3.
  FEMSPH_INLINE Pack volume(std::size_t block) const { return load<Pack>(&v_[block * lanes]); }
  /// K_i, the volume in the divergence and the hourglass control, with thickness, m^3; fraction(): V_i / K_i.
  FEMSPH_INLINE Pack kernel_volume(std::size_t block) const { return load<Pack>(&k_[block * lanes]); }
  FEMSPH_INLINE Pack fraction(std::size_t block) const { return load<Pack>(&part_[block * lanes]); }
  double fraction_of(std::size_t particle) const { return part_[particle]; }
  double correction(std::size_t particle, int r, int c) const {
    if constexpr (corrected)
      return b_[slot(particle, symmetric_index<dim>(r, c), n_symmetric)];
    else
      return r == c ? 1.0 : 0.0;
  }

  /// H of a block, whose part of the field starts at u; with_scale also L = sum_j scale_ij (u_j - u_i),
  /// uncorrected.
  template <bool with_scale>
  FEMSPH_INLINE void gradient(std::size_t block, const double* u, std::size_t stride, Tensor<Pack, dim>& H,
                              Pack (&L)[dim]) const {
    stencils_.template gradient<with_scale>(block, u, stride, H, L);
    if constexpr (corrected) H = times_correction(block, H);
  }
  /// A B
  FEMSPH_INLINE Tensor<Pack, dim> times_correction(std::size_t block, const Tensor<Pack, dim>& A) const {
    static_assert(corrected);
    Pack B[n_symmetric];
    for (int k = 0; k < n_symmetric; ++k) B[k] = load<Pack>(&b_[(block * n_symmetric + k) * lanes]);
    Tensor<Pack, dim> out;
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c) {
        Pack sum = A[r][0] * B[symmetric_index<dim>(0, c)];
        for (int k = 1; k < dim; ++k) sum += A[r][k] * B[symmetric_index<dim>(k, c)];
        out[r][c] = sum;
      }
    return out;
  }
  /// How the components of Q, which the divergence sums, are stored.
  using Tensors = typename Stencils::Tensors;
  /// Force per K of a block, whose part of Q starts at q.
  FEMSPH_INLINE void divergence(std::size_t block, const double* q, std::size_t stride,
                                Pack (&force)[dim]) const {
    (adjoint_ ? *adjoint_ : stencils_).divergence(block, q, stride, force);
    Pack own[dim * dim];
    Tensors::load(q, stride, own);
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c) force[r] += own[r * dim + c] * load<Pack>(&s_[(block * dim + c) * lanes]);
  }

 private:
  GradientOperator(const Particles& particles, OperatorRows&& made, Boundary boundary, double thickness)
      : stencils_(*made.rows, particles.size()), projected_(made.projected), note_(std::move(made.note)) {
    const RowSource& rows = *made.rows;
    const std::size_t n = particles.size(), padded = round_up(n, lanes);
    s_.assign(padded * dim, 0.0);
    v_.assign(padded, 0.0);
    k_.assign(padded, 0.0);
    part_.assign(padded, 0.0);
    if constexpr (corrected) b_.assign(padded * n_symmetric, 0.0);
    Row row;
    for (std::size_t i = 0; i < n; ++i) {
      rows.row(i, row);
      v_[i] = particles.own_volume(i) * made.fill * thickness;
      k_[i] = particles.kernel_volume[i] * particles.part[i] * thickness;
      part_[i] = particles.volume[i] * made.fill / particles.kernel_volume[i];
      for (const Neighbour& j : row)
        for (int a = 0; a < dim; ++a) s_[slot(i, a, dim)] += j.w[a];
      if constexpr (corrected) {
        const Tensor<double, 3> B = correction_of(particles, i, rows, row, boundary);
        for (int a = 0; a < dim; ++a)
          for (int c = a; c < dim; ++c) b_[slot(i, symmetric_index<dim>(a, c), n_symmetric)] = B[a][c];
      }
    }
    if (made.adjoint) adjoint_ = std::make_unique<Stencils>(*made.adjoint, n);
  }
  static std::size_t slot(std::size_t i, int component, int components) {
    return (i / lanes * components + component) * lanes + i % lanes;
  }

  Stencils stencils_;
  std::unique_ptr<Stencils> adjoint_;  ///< its own rows where they differ: virtual particles, projection
  bool projected_;
  std::string note_;
  AlignedVector<double> s_, v_, k_, part_, b_;  ///< S, V, K, V / K, B: [block][component][lane]
};

}  // namespace femsph::sph
