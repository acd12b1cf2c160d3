#pragma once
// The part of TotalLagrangian that does not depend on law and kinematics: the operator, the two passes, and
// the stiffness of the undeformed elastic body. It is compiled once for each dimension, storage form and
// correction.

#include "model/material/kinematics.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "sph/formulations/particle_body.hpp"
#include "sph/operators/gradient_operator.hpp"
#include "sph/operators/mean_dilatation.hpp"
#include "sph/pair_forces/viscosity.hpp"

namespace femsph::sph {

template <int dim, class Stencils, Correction correction>
class StiffnessBody : public ParticleBody {
 protected:
  static constexpr bool corrected = correction != Correction::none;
  static constexpr bool mean = correction == Correction::hourglass_and_mean_dilatation;
  static constexpr bool hourglass = correction == Correction::matrix_and_hourglass || mean;

 public:
  StiffnessBody(const Scene& scene, std::size_t body, const Options& options, Particles particles,
                const Kernel& kernel, const LinearElastic& elastic)
      : ParticleBody(scene, body, options, std::move(particles), kernel),
        elastic_(elastic),
        operator_(particles_, kernel, options, thickness_, uniform_stress_areas()),
        kappa_(options_.hourglass * hourglass_modulus(elastic)) {
    if (!operator_.note().empty()) warnings_.push_back(operator_.note());
    q_.assign(stride() * dim * dim, 0.0);
    if constexpr (hourglass) l_.assign(blocks() * lanes * dim, 0.0);
    if constexpr (mean) {
      dilatation_ = std::make_unique<Dilatations>(particles_, layout_.offset, stride());
      h_.assign(blocks() * lanes * dim * dim, 0.0);
    }
    if (options.viscosity.on())
      viscosity_ = std::make_unique<PairViscosity<dim, Stencils>>(
          particles_, kernel, options, density_, wave_speed_, thickness_);
  }

  std::size_t bytes() const override {
    return ParticleBody::bytes() + operator_.bytes() + (viscosity_ ? viscosity_->bytes() : 0) +
           (q_.size() + l_.size() + h_.size()) * sizeof(double) + (dilatation_ ? dilatation_->bytes() : 0);
  }

  void stiffness(const double* given, double* y) const override {
    const double* x = with_mirrored(given);
    strain_to_stress<SmallStrain>(
        x, [&](std::size_t, const Symmetric<Pack, dim>& strain)
               __attribute__((always_inline)) { return elastic_.stress(strain); });
    add_bars<SmallStrain>(x, bars_.pieces, [](const BarLaw& law, double strain, const BarState&) {
      return law.young * strain;
    });
    mirror_stress();
    stress_to_force(y);
    for (std::size_t i = 0; i < layout_.size; ++i) y[i] = -y[i];
  }

  MaterialUnits material_units() const override;
  std::optional<Trouble> trouble(const double* given) const override;
  bool has_viscosity() const override { return viscosity_ != nullptr; }
  void damping_matrix(const double* x, double* y) const override {
    viscosity_->matrix(with_mirrored(x), layout_, y);
  }

 protected:
  std::size_t blocks() const { return operator_.blocks(); }
  std::size_t first(std::size_t block) const { return layout_.offset + block * lanes; }
  std::size_t stride() const { return layout_.component_stride; }
  using Tensors = typename Stencils::Tensors;
  std::size_t q_slot(std::size_t particle, int r, int c) const {
    return Tensors::at(layout_.offset + particle, r * dim + c, stride());
  }
  template <bool with_scale>
  FEMSPH_INLINE void gradient(std::size_t block, const double* u, Tensor<Pack, dim>& H,
                              Pack (&L)[dim]) const {
    operator_.template gradient<with_scale>(block, u + first(block), stride(), H, L);
  }

  template <class Motion, class StressOf>
  void strain_to_stress(const double* u, StressOf&& stress_of) const {
    if constexpr (mean) changes_of_volume<Motion, hourglass>(u);
    parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        Tensor<Pack, dim> H, P;
        Pack L[dim];
        if constexpr (mean) {
          H = kept_gradient(block);
          for (int r = 0; r < dim; ++r) L[r] = load<Pack>(&l_[(block * dim + r) * lanes]);
        } else {
          gradient<hourglass>(block, u, H, L);
        }
        Symmetric<Pack, dim> strain;
        const auto frame = Motion::template strain<Pack, dim>(H, strain);
        if constexpr (mean) {
          Symmetric<Pack, dim> enlarged = strain;
          const Pack r = VolumeChange<Motion, dim>::add(dilatation_->volume_excess(block), enlarged);
          const Symmetric<Pack, dim> stress = stress_of(block, enlarged);
          store(dilatation_->pressure(block), VolumeChange<Motion, dim>::work(enlarged, stress));
          Motion::template piola<Pack, dim>(frame, strain, stress, P);
          VolumeChange<Motion, dim>::scale(r, P);
        } else {
          const Symmetric<Pack, dim> stress = stress_of(block, strain);
          Motion::template piola<Pack, dim>(frame, strain, stress, P);
        }
        if constexpr (corrected) {
          P = operator_.times_correction(block, P);
          const Pack part = operator_.fraction(block);
          for (int r = 0; r < dim; ++r)
            for (int c = 0; c < dim; ++c) P[r][c] *= part;
        }
        if constexpr (hourglass)
          for (int r = 0; r < dim; ++r) {
            store(&l_[(block * dim + r) * lanes], L[r]);
            for (int c = 0; c < dim; ++c) P[r][c] -= kappa_ * H[r][c];
          }
        Pack Q[dim * dim];
        for (int r = 0; r < dim; ++r)
          for (int c = 0; c < dim; ++c) Q[r * dim + c] = P[r][c];
        Tensors::store(&q_[q_slot(block * lanes, 0, 0)], stride(), Q);
      }
    });
    if constexpr (mean) add_mean_pressure<Motion>();
  }
  Tensor<Pack, dim> kept_gradient(std::size_t block) const {
    Tensor<Pack, dim> H;
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c) H[r][c] = load<Pack>(&h_[(block * dim * dim + r * dim + c) * lanes]);
    return H;
  }
  /// Computes theta of a block, and stores its gradient.
  template <class Motion, bool with_scale>
  FEMSPH_INLINE void change_of_volume(std::size_t block, const double* u) const {
    Tensor<Pack, dim> H;
    Pack L[dim];
    gradient<with_scale>(block, u, H, L);
    for (int r = 0; r < dim; ++r) {
      if constexpr (with_scale) store(&l_[(block * dim + r) * lanes], L[r]);
      for (int c = 0; c < dim; ++c) store(&h_[(block * dim * dim + r * dim + c) * lanes], H[r][c]);
    }
    store(dilatation_->volume(block), VolumeChange<Motion, dim>::of(H));
  }
  template <class Motion, bool with_scale>
  void changes_of_volume(const double* u) const {
    parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block)
        change_of_volume<Motion, with_scale>(block, u);
    });
    dilatation_->mirror_volume(particles_);
  }
  /// Turns the strain into the one that the law is given, from the changes of volume stored before.
  template <class Motion>
  FEMSPH_INLINE void enlarge([[maybe_unused]] std::size_t block,
                             [[maybe_unused]] Symmetric<Pack, dim>& strain) const {
    if constexpr (mean) VolumeChange<Motion, dim>::add(dilatation_->volume_excess(block), strain);
  }
  /// Q += (V / K) (D p) C B
  template <class Motion>
  void add_mean_pressure() const {
    dilatation_->mirror_pressure(particles_);
    parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        const Pack p = operator_.fraction(block) * dilatation_->pressure_excess(block);
        const Tensor<Pack, dim> CB = operator_.times_correction(
            block, VolumeChange<Motion, dim>::direction(kept_gradient(block)));
        double* q = &q_[q_slot(block * lanes, 0, 0)];
        Pack Q[dim * dim];
        Tensors::load(q, stride(), Q);
        for (int r = 0; r < dim; ++r)
          for (int c = 0; c < dim; ++c) Q[r * dim + c] += p * CB[r][c];
        Tensors::store(q, stride(), Q);
      }
    });
  }

  /// Unit vector along a bar.
  struct Pull {
    double at[dim];
  };
  /// Calls take(piece, strain, pull) for every piece of a bar.
  template <class Motion, class Pieces, class Take>
  void each_bar(const double* u, Pieces& pieces, Take&& take) const {
    Tensor<Pack, dim> H;
    std::size_t known = std::size_t(-1);
    for (auto& piece : pieces) {
      const std::size_t block = piece.particle / lanes, lane = piece.particle % lanes;
      if (block != known) {
        Pack L[dim];
        gradient<false>(block, u, H, L);
        known = block;
      }
      const int axis = bars_.rows[piece.row].axis;
      double g[dim];
      Pull pull;
      for (int r = 0; r < dim; ++r) g[r] = H[r][axis][lane];
      take(piece, bar_strain<Motion, dim>(g, axis, pull.at), pull);
    }
  }
  /// Q += (V / K) (A l / V) sigma pull (x) B e_a.
  template <class Motion, class Pieces, class StressOf>
  void add_bars(const double* u, Pieces& pieces, StressOf&& stress_of) const {
    each_bar<Motion>(u, pieces, [&](auto& piece, double strain, const Pull& pull) {
      const BarRow& row = bars_.rows[piece.row];
      const double p = operator_.fraction_of(piece.particle) * piece.per_cell *
                       stress_of(row.law, strain, piece.state);
      for (int c = 0; c < dim; ++c) {
        const double b = operator_.correction(piece.particle, row.axis, c);
        for (int r = 0; r < dim; ++r) q_[q_slot(piece.particle, r, c)] += p * pull.at[r] * b;
      }
    });
  }
  /// Beyond a symmetry plane Q has the mirrored components: sign_r sign_c Q_rc.
  void mirror_stress() const {
    for (std::size_t k = 0; k < particles_.mirrored.size(); ++k) {
      const Mirrored& m = particles_.mirrored[k];
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c)
          q_[q_slot(particles_.size() + k, r, c)] = m.sign[r] * m.sign[c] * q_[q_slot(m.of, r, c)];
    }
  }

  void stress_to_force(double* f) const {
    parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        const double* q = &q_[q_slot(block * lanes, 0, 0)];
        Pack force[dim];
        operator_.divergence(block, q, stride(), force);
        for (int r = 0; r < dim; ++r) {
          if constexpr (hourglass) force[r] += 2 * kappa_ * load<Pack>(&l_[(block * dim + r) * lanes]);
          store(f + first(block) + r * stride(), operator_.kernel_volume(block) * force[r]);
        }
      }
    });
  }

  LinearElastic elastic_;
  GradientOperator<dim, Stencils, corrected> operator_;
  std::unique_ptr<PairViscosity<dim, Stencils>> viscosity_;
  double kappa_;                     ///< hourglass stiffness, Pa
  mutable AlignedVector<double> q_;  ///< Q, in the layout of the stencils
  mutable AlignedVector<double> l_;  ///< L of the hourglass control, [block][component][lane]
  using Dilatations = MeanDilatation<typename Stencils::OneValue>;
  std::unique_ptr<Dilatations> dilatation_;  ///< only with the mean dilatation
  mutable AlignedVector<double> h_;          ///< H then, [block][component][lane]
};

}  // namespace femsph::sph
