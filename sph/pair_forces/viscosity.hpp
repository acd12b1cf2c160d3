#pragma once
// Artificial viscosity, eq. 5 of the paper (Monaghan 1992), between particles that approach each other:
//   Pi_ij = (-alpha c phi + beta phi^2) / rho,   phi = h v_ij . x_ij / (|x_ij|^2 + gamma h^2) < 0,
//   f_i = - sum_j m_i m_j Pi_ij grad_i W_ij = -V_i sum_j rho (-alpha c phi + beta phi^2) w_ij.
// Without viscosity no PairViscosity is made.

#include <memory>

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/parallel.hpp"
#include "sph/operators/stencils.hpp"

namespace femsph::sph {

/// Rows whose `scale` s_ij gives phi_ij = s_ij (v_j - v_i) . w_ij, with w_ij = V_j grad_i W_ij along x_ij.
class ViscousRows final : public RowSource {
 public:
  ViscousRows(std::unique_ptr<RowSource> rows, double h, double gamma)
      : rows_(std::move(rows)), h_(h), gamma_(gamma) {}
  void row(std::size_t i, Row& out) const override {
    rows_->row(i, out);
    for (Neighbour& n : out) {
      const double c = n.scale, r2 = (n.w[0] * n.w[0] + n.w[1] * n.w[1] + n.w[2] * n.w[2]) / (c * c);
      n.scale = h_ / (c * (r2 + gamma_ * h_ * h_));
    }
  }
  double kernel_sum(std::size_t i) const override { return rows_->kernel_sum(i); }

 private:
  std::unique_ptr<RowSource> rows_;
  double h_, gamma_;
};

template <int dim, class Stencils>
class PairViscosity {
 public:
  PairViscosity(const Particles& p, const Kernel& kernel, const Options& options, double density,
                double sound, double thickness)
      : stencils_(ViscousRows(p.regular ? lattice_rows(p, kernel) : search_rows(p, kernel), kernel.h(),
                              options.viscosity.gamma),
                  p.size()),
        linear_(density * options.viscosity.alpha * sound),
        quadratic_(density * options.viscosity.beta),
        volume_(round_up(p.size(), lanes), 0.0) {
    for (std::size_t i = 0; i < p.size(); ++i) volume_[i] = p.own_volume(i) * thickness;
  }
  std::size_t bytes() const { return stencils_.bytes() + volume_.size() * sizeof(double); }

  /// f = viscous force of velocity v (flat, as `layout` says).
  void force(const double* v, const Layout& layout, double* f) const {
    pairs(
        v, layout, f, [&](const Pack& phi) __attribute__((always_inline)) {
          const Pack closing = select(phi < 0.0, phi, Pack{});
          return (linear_ - quadratic_ * closing) * closing;
        });
  }
  /// y = C x, the linear part of the force as if every pair approached: a bound for the critical step.
  void matrix(const double* x, const Layout& layout, double* y) const {
    pairs(
        x, layout, y, [&](const Pack& phi) __attribute__((always_inline)) { return -linear_ * phi; });
  }

 private:
  template <class Strength>
  void pairs(const double* v, const Layout& layout, double* f, Strength&& strength) const {
    const std::size_t stride = layout.component_stride;
    parallel_for(stencils_.blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        const std::size_t first = layout.offset + block * lanes;
        Pack force[dim] = {};
        stencils_.each(
            block, v + first, stride,
            [&](const Pack(&difference)[dim], const Pack(&w)[dim], const Pack& scale)
                __attribute__((always_inline)) {
                  Pack along = difference[0] * w[0];
                  for (int r = 1; r < dim; ++r) along += difference[r] * w[r];
                  const Pack p = strength(scale * along);
                  for (int r = 0; r < dim; ++r) force[r] += p * w[r];
                });
        for (int r = 0; r < dim; ++r)
          store(f + first + r * stride, load<Pack>(&volume_[block * lanes]) * force[r]);
      }
    });
  }

  Stencils stencils_;
  double linear_, quadratic_;
  AlignedVector<double> volume_;
};

}  // namespace femsph::sph
