#pragma once
// The material of bond_body.hpp: what depends on the law. In large motion a law whose stress follows from the
// stretch takes stretch_point.hpp, one that carries its stress from step to step flow_point.hpp; in small
// motion both take small_point.hpp.

#include "model/material/kinematics.hpp"
#include "model/material/stiffening.hpp"
#include "sph/formulations/bond_body.hpp"
#include "sph/formulations/flow_point.hpp"
#include "sph/formulations/small_point.hpp"
#include "sph/formulations/stretch_point.hpp"

namespace femsph::sph {

/// Laws without shear stiffness.
template <class LawType>
inline constexpr bool is_fluid = [] {
  if constexpr (requires { LawType::fluid; }) return LawType::fluid;
  return false;
}();

template <int dim, class LawType, bool large>
class BondLaw final : public BondBody<dim> {
  using Base = BondBody<dim>;
  static constexpr bool flows = !LawType::path_independent;
  using State =
      std::conditional_t<!large, SmallPoint<dim, LawType>,
                         std::conditional_t<flows, FlowPoint<dim, LawType>, StretchPoint<dim, LawType>>>;
  using Base::blocks_, Base::for_blocks, Base::kept_, Base::motion, Base::part, Base::particles_,
      Base::thickness_, Base::undeformed;

 public:
  BondLaw(const Scene& scene, std::size_t body, const Options& options, Particles particles,
          const Kernel& kernel, const LawType& law)
      : Base(scene, body, options, std::move(particles), kernel, law.elastic(), is_fluid<LawType>,
             flows && !is_fluid<LawType>),
        law_(law) {
    state_.assign(blocks_ * State::size * lanes, 0.0);
  }

  std::size_t bytes() const override { return Base::bytes() + state_.size() * sizeof(double); }

  Energies energies(const double*) const override {
    const auto [stored, lost] = parallel_sums<2>(blocks_, [&](std::size_t begin, std::size_t end) {
      Pack stored{}, lost{};
      for (std::size_t block = begin; block < end; ++block) {
        const Pack volume = part(block) * undeformed(block);
        stored += State::stored(law_, volume_of_energy(block, volume), own(block));
        if constexpr (flows) lost += volume * law_.plastic_work(own(block) + State::history);
      }
      return std::array{horizontal_sum(stored), horizontal_sum(lost)};
    });
    return {thickness_ * stored, Base::spring_energy(), thickness_ * lost + Base::forgotten_energy()};
  }

  std::optional<Trouble> trouble(const double* u) const override {
    if (auto t = Base::trouble(u)) return t;
    if constexpr (large && !flows) {
      AlignedVector<double> det(blocks_ * lanes);
      for_blocks([&](std::size_t block) { store(&det[block * lanes], State::volume_ratio(own(block))); });
      return Base::inside_out(det, u);
    }
    return std::nullopt;
  }

  void material_state(const double*, std::span<const std::size_t> points, MaterialState& out) const override {
    out.stress.resize(points.size());
    out.strain.resize(points.size());
    out.plastic.resize(flows ? points.size() : 0);
    out.resize_flow(plasticity_of(law_), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      double one[State::size];
      for (int c = 0; c < State::size; ++c) one[c] = own(points[k] / lanes)[c][points[k] % lanes];
      State::show(law_, one, out.stress[k], out.strain[k]);
      if constexpr (flows) {
        double share = 1;
        if constexpr (large) share = State::cauchy_share(one);
        out.plastic[k] = law_.plastic_strain(one + State::history);
        out.set_flow(k, flow_stress(law_, one + State::history, share, out.stress[k]));
      }
    }
  }

 private:
  FEMSPH_INLINE Pack* own(std::size_t block) {
    return reinterpret_cast<Pack*>(&state_[block * State::size * lanes]);
  }
  FEMSPH_INLINE const Pack* own(std::size_t block) const {
    return reinterpret_cast<const Pack*>(&state_[block * State::size * lanes]);
  }

  /// What stored() of the point takes: V0; the stretch takes the present volume.
  FEMSPH_INLINE Pack volume_of_energy([[maybe_unused]] std::size_t block, const Pack& undeformed) const {
    if constexpr (large && !flows)
      return undeformed * State::volume_ratio(own(block));
    else
      return undeformed;
  }

  bool advance_material(double dt) override {
    if constexpr (requires { law_.set_step(dt); }) law_.set_step(dt);
    for_blocks([&](std::size_t block) {
      const Tensor<Pack, dim> L = motion(block);
      if constexpr (!large) {
        Symmetric<Pack, dim> resultant;
        State::advance(law_, L, undeformed(block), own(block), resultant);
        this->set_resultant(block, resultant);
      } else if constexpr (flows) {
        Symmetric<Pack, dim> resultant;
        Pack kept;
        State::advance(law_, L, undeformed(block), own(block), resultant, kept);
        this->set_resultant(block, resultant);
        if (!kept_.empty()) store(&kept_[block * lanes], kept);
      } else {
        Pack volume = undeformed(block);
        State::advance(law_, L, volume, own(block));
        const Pack ratio = undeformed(block) * State::volume_ratio(own(block));
        Symmetric<Pack, dim> s = State::pull(own(block));
        for (int k = 0; k < symmetric_size<dim>; ++k) s[k] *= ratio;
        this->set_resultant(block, s);
      }
    });
    if (!large || kept_.empty() || !(dt > 0)) return false;
    return parallel_sum(blocks_, [&](std::size_t begin, std::size_t end) {
             double flowing = 0;
             for (std::size_t i = begin * lanes; i < end * lanes; ++i) flowing += kept_[i] < 1 ? 1.0 : 0.0;
             return flowing;
           }) > 0;
  }

  void material_archive(Archive& archive) override { archive("material", state_); }

  void stiffen(AlignedVector<double>& ratio) const override {
    if constexpr (large && !Stiffens<LawType>) {
      std::fill(ratio.begin(), ratio.end(), 1.0);
    } else if constexpr (large) {
      for_blocks([&](std::size_t block) {
        Pack& r = *reinterpret_cast<Pack*>(&ratio[block * lanes]);
        if constexpr (flows) {
          r = law_.stiffening(r, exponential(own(block)[State::growth]));
        } else {
          Tensor<Pack, dim> F, inverse;
          for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
              F[i][j] = own(block)[State::gradient + i * dim + j] + (i == j ? 1.0 : 0.0);
          const Pack J = invert(F, inverse);
          r = femsph::stiffening<Pack, dim>(law_, inverse, J);
        }
      });
    }
  }

  LawType law_;
  AlignedVector<double> state_;  ///< [block][slot][lane]
};

template <int dim>
std::unique_ptr<Discretization> bond_body(const Scene& scene, std::size_t body, const Options& options,
                                          Particles particles, const Kernel& kernel) {
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<Discretization> {
        using LawType = std::decay_t<decltype(law)>;
        const auto with = [&]<bool large>() -> std::unique_ptr<Discretization> {
          return std::make_unique<BondLaw<dim, LawType, large>>(
              scene, body, options, std::move(particles), kernel, law);
        };
        if (scene.large_motion) return with.template operator()<true>();
        if constexpr (LargeMotionOnly<LawType>)
          throw std::runtime_error("this material needs motion = \"large\"");
        else
          return with.template operator()<false>();
      },
      scene.material_of(scene.bodies[body]).law(scene.plane));
}

}  // namespace femsph::sph
