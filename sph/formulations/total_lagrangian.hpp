#pragma once
// SPH on the initial neighbours: corrected, or classic in small strain. One step is two passes over the
// particles:
//   1  displacement gradient H; law; Q = (V / K) P B
//   2  force, the exact adjoint of pass 1
// by the operator of gradient_operator.hpp. stiffness_body.hpp has the part that does not depend on the law,
// total_lagrangian_output.hpp the energies and the states of material points.

#include "sph/formulations/stiffness_body.hpp"

namespace femsph::sph {

template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
class TotalLagrangian final : public StiffnessBody<dim, Stencils, correction> {
  using Base = StiffnessBody<dim, Stencils, correction>;
  using Base::bars_, Base::blocks, Base::dilatation_, Base::first, Base::hourglass, Base::kappa_,
      Base::kept_gradient, Base::layout_, Base::mean, Base::operator_, Base::particles_, Base::stride,
      Base::viscosity_, Base::with_mirrored;
  using typename Base::Pull;
  static constexpr int n_symmetric = symmetric_size<dim>, n_state = point_state_size<LawType, dim>;

 public:
  TotalLagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles,
                  const Kernel& kernel, const LawType& law)
      : Base(scene, body, options, std::move(particles), kernel, law.elastic()), law_(law) {
    state_.assign(blocks() * lanes * n_state, 0.0);
  }

  std::size_t bytes() const override { return Base::bytes() + state_.size() * sizeof(double); }

  void internal_force(const double* given, const double* v, [[maybe_unused]] double dt, double* f,
                      double* viscous) override {
    if constexpr (requires { law_.set_step(dt); }) law_.set_step(dt);
    const double* u = with_mirrored(given);
    this->template strain_to_stress<Kinematics>(
        u, [&](std::size_t block, const Symmetric<Pack, dim>& strain) __attribute__((always_inline)) {
          if constexpr (n_state == 0)
            return law_.stress(strain);
          else
            return advance_law<LawType, Pack, dim, Kinematics>(
                law_, strain, reinterpret_cast<Pack*>(&state_[block * n_state * lanes]));
        });
    this->template add_bars<Kinematics>(
        u, bars_.pieces,
        [](const BarLaw& law, double strain, BarState& state) { return law.advance(strain, state); });
    this->mirror_stress();
    this->stress_to_force(f);
    if (viscous) viscosity_->force(with_mirrored(v), layout_, viscous);
  }

  Energies energies(const double* given) const override;
  std::vector<BarPiece> bars(const double* u) const override;
  void material_state(const double* given, std::span<const std::size_t> points,
                      MaterialState& out) const override;
  std::optional<Stiffening> stiffening(const double* given) const override;

  void state(Archive& archive) override {
    if constexpr (n_state > 0) archive("material", state_);
    bars_.state(archive);
  }

 private:
  void mean_stresses_around(const double* u, std::span<const std::size_t> points) const;
  const Pack* history([[maybe_unused]] std::size_t block) const {
    if constexpr (n_state == 0)
      return nullptr;
    else
      return reinterpret_cast<const Pack*>(&state_[(block * n_state + 2 * n_symmetric) * lanes]);
  }

  FEMSPH_INLINE Symmetric<Pack, dim> stress_now([[maybe_unused]] std::size_t block,
                                                const Symmetric<Pack, dim>& strain) const {
    if constexpr (n_state == 0)
      return law_.stress(strain);
    else {
      Symmetric<Pack, dim> s;
      for (int k = 0; k < n_symmetric; ++k) s[k] = load<Pack>(&state_[(block * n_state + k) * lanes]);
      return s;
    }
  }

  Pack misfit(std::size_t block, const double* u, const Tensor<Pack, dim>& H) const;

  LawType law_;
  AlignedVector<double> state_;  ///< of the law, [block][value][lane]
};

}  // namespace femsph::sph
