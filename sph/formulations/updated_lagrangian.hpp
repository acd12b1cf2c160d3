#pragma once
// Classic SPH for large motion: neighbours and kernel gradients follow the particles. Velocity gradients are
// taken at the middle of the step, x(n) - dt/2 v(n-1/2). One step is two passes over the particles. Before
// each pass the fields that neighbours read are written as records (particle_records.hpp):
//   1  L_i = dt sum_j V_j (v_j - v_i) (x) grad_i W_ij;  the material point (rate_point.hpp,
//   stretch_point.hpp) makes stress and V_i of it 2  f_i = V_i sum_j V_j (sigma_i + sigma_j) grad_i W_ij,
//   equal and opposite within each pair

#include <fmt/format.h>

#include <algorithm>

#include "model/material/kinematics.hpp"
#include "sph/formulations/discretize.hpp"
#include "sph/formulations/rate_point.hpp"
#include "sph/formulations/stretch_point.hpp"
#include "sph/operators/moving_neighbours.hpp"
#include "sph/operators/particle_records.hpp"

namespace femsph::sph {

/// The material point of a particle with this law.
template <int dim, class LawType>
using UpdatedPoint =
    std::conditional_t<Incremental<LawType>, RatePoint<dim, LawType>, StretchPoint<dim, LawType>>;

template <int dim, class LawType>
class UpdatedLagrangian final : public ParticleBody {
  static constexpr int n = symmetric_size<dim>;
  using State = UpdatedPoint<dim, LawType>;

 public:
  UpdatedLagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles,
                    const Kernel& kernel, const LawType& law)
      : ParticleBody(scene, body, options, particles, kernel),
        small_(small_motion_body<dim>(scene, body, options, std::move(particles), kernel, law.elastic())),
        law_(law),
        kernel_(kernel),
        blocks_(round_up(particles_.size(), lanes) / lanes),
        neighbours_(particles_.position, layout_, kernel.radius(), 0.3 * particles_.spacing) {
    start_.assign(layout_.size, 0.0);
    volume_.assign(blocks_ * lanes, 0.0);
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      volume_[i] = particles_.volume[i];
      for (int c = 0; c < dim; ++c) start_[layout_.at(i, c)] = particles_.position[i][std::size_t(c)];
    }
    state_.assign(blocks_ * State::size * lanes, 0.0);
    motion_.resize(particles_.size());
    forces_.resize(particles_.size());
  }

  std::string describe() const override { return ParticleBody::describe() + ", updated neighbours"; }
  std::size_t bytes() const override {
    return ParticleBody::bytes() + small_->bytes() + neighbours_.bytes() + motion_.bytes() + forces_.bytes() +
           (start_.size() + volume_.size() + state_.size()) * sizeof(double);
  }
  void stiffness(const double* x, double* y) const override { small_->stiffness(x, y); }
  bool has_viscosity() const override { return options_.viscosity.on(); }
  void damping_matrix(const double* x, double* y) const override { small_->damping_matrix(x, y); }

  Energies energies(const double*) const override {
    const auto [stored, lost] = parallel_sums<2>(blocks_, [&](std::size_t begin, std::size_t end) {
      Pack stored{}, lost{};
      for (std::size_t block = begin; block < end; ++block) {
        stored += State::stored(law_, volume(block), state(block));
        if constexpr (State::plastic) lost += State::lost(state(block));
      }
      return std::array{horizontal_sum(stored), horizontal_sum(lost)};
    });
    return {thickness_ * stored, 0, thickness_ * lost};
  }

  void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) override {
    neighbours_.update(u);
    if constexpr (requires { law_.set_step(dt); }) law_.set_step(dt);
    const bool wendland = kernel_.kind() == KernelKind::wendland_c2;
    const auto step = [&](const double* rate, double time) {
      wendland ? advance<WendlandC2>(u, rate, time) : advance<CubicSpline>(u, rate, time);
    };
    if (dt > 0)
      step(v, dt);
    else if (std::any_of(u, u + layout_.size, [](double x) { return x != 0; }))
      step(u, 1.0);  // an initial displacement, as one step
    lay_down_forces(u, v);
    if (viscous)
      wendland ? pair_forces<WendlandC2, true>(f, viscous) : pair_forces<CubicSpline, true>(f, viscous);
    else
      wendland ? pair_forces<WendlandC2, false>(f, viscous) : pair_forces<CubicSpline, false>(f, viscous);
  }

  /// The neighbour lists are part of the state: after a search at another time the sums would be taken in
  /// another order.
  void state(Archive& archive) override {
    archive("material", state_);
    archive("volume", volume_);
    neighbours_.state(archive);
  }
  std::optional<Trouble> trouble(const double* u) const override;

  void material_state(const double*, std::span<const std::size_t> points, MaterialState& out) const override {
    out.stress.resize(points.size());
    out.strain.resize(points.size());
    out.plastic.resize(State::plastic ? points.size() : 0);
    out.resize_flow(plasticity_of(law_), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      double own[State::size];
      for (int c = 0; c < State::size; ++c) own[c] = state(points[k] / lanes)[c][points[k] % lanes];
      State::show(law_, own, out.stress[k], out.strain[k]);
      if constexpr (State::plastic) {
        out.plastic[k] = State::plastic_strain(law_, own);
        out.set_flow(k, flow_stress(law_, own + State::history, 1.0, out.stress[k]));
      }
    }
  }

 private:
  // The fields in the records: x, v, V for the first pass, and x, V, sigma, v for the second.
  enum Motion { middle = 0, velocity = dim, extent = 2 * dim };
  enum Force { place = 0, measure = dim, pull = dim + 1, speed = dim + 1 + n };
  using MotionRecords = ParticleRecords<1>;
  using ForceRecords = ParticleRecords<(dim + 1 + n + dim + lanes - 1) / lanes>;

  FEMSPH_INLINE Pack* state(std::size_t block) {
    return reinterpret_cast<Pack*>(&state_[block * State::size * lanes]);
  }
  FEMSPH_INLINE const Pack* state(std::size_t block) const {
    return reinterpret_cast<const Pack*>(&state_[block * State::size * lanes]);
  }
  FEMSPH_INLINE Pack volume(std::size_t block) const { return load<Pack>(&volume_[block * lanes]); }
  FEMSPH_INLINE std::size_t slot(std::size_t block, int c) const {
    return layout_.offset + block * lanes + std::size_t(c) * layout_.component_stride;
  }
  template <class Body>
  void for_blocks(Body&& body) const {
    parallel_for(blocks_ * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) body(block);
    });
  }

  template <class Spline>
  void advance(const double* u, const double* v, double dt) {
    for_blocks([&](std::size_t block) {
      Pack own[MotionRecords::fields] = {};
      for (int c = 0; c < dim; ++c) {
        own[velocity + c] = load<Pack>(v + slot(block, c));
        own[middle + c] = load<Pack>(&start_[slot(block, c)]) + load<Pack>(u + slot(block, c)) -
                          0.5 * dt * own[velocity + c];
      }
      own[extent] = volume(block);
      motion_.store_block(block, own);
    });
    const double per_h2 = 1 / (kernel_.h() * kernel_.h()), factor = kernel_.steepness_factor() * dt;
    neighbours_.each_block([&](std::size_t block, const std::int32_t* index, const std::int32_t* end) {
      Pack own[MotionRecords::fields], other[MotionRecords::fields];
      motion_.load_block(block, own);
      Tensor<Pack, dim> L{};
      for (; index != end; index += lanes) {
        motion_.gather(index, other);
        Pack d[dim], r2{};
        for (int c = 0; c < dim; ++c) d[c] = other[middle + c] - own[middle + c], r2 += d[c] * d[c];
        const Pack s = other[extent] * Spline::steepness(square_root(r2 * per_h2));
        for (int c = 0; c < dim; ++c) d[c] *= s;
        for (int r = 0; r < dim; ++r) {
          const Pack dv = other[velocity + r] - own[velocity + r];
          for (int c = 0; c < dim; ++c) L[r][c] += dv * d[c];
        }
      }
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c) L[r][c] *= factor;
      Pack grown = volume(block);
      State::advance(law_, L, grown, state(block));
      store(&volume_[block * lanes], grown);
    });
  }

  void lay_down_forces(const double* u, const double* v) {
    for_blocks([&](std::size_t block) {
      Pack own[ForceRecords::fields] = {};
      for (int c = 0; c < dim; ++c) {
        own[place + c] = load<Pack>(&start_[slot(block, c)]) + load<Pack>(u + slot(block, c));
        own[speed + c] = load<Pack>(v + slot(block, c));
      }
      own[measure] = volume(block);
      const Symmetric<Pack, dim> s = State::pull(state(block));
      for (int k = 0; k < n; ++k) own[pull + k] = s[k];
      forces_.store_block(block, own);
    });
  }

  template <class Spline, bool with_viscosity>
  void pair_forces(double* f, [[maybe_unused]] double* viscous) const {
    const double h = kernel_.h(), per_h2 = 1 / (h * h), factor = kernel_.steepness_factor() * thickness_;
    [[maybe_unused]] const double alpha = options_.viscosity.alpha * wave_speed_ * density_,
                                  beta = options_.viscosity.beta * density_;
    [[maybe_unused]] const double floor = options_.viscosity.gamma * h * h +
                                          1e-300;  // a lane that looks at itself has r = 0
    neighbours_.each_block([&](std::size_t block, const std::int32_t* index, const std::int32_t* end) {
      Pack own[ForceRecords::fields], other[ForceRecords::fields], force[dim] = {}, drag[dim] = {};
      forces_.load_block(block, own);
      for (; index != end; index += lanes) {
        forces_.gather(index, other);
        Pack d[dim], w[dim], r2{};
        for (int c = 0; c < dim; ++c) d[c] = other[place + c] - own[place + c], r2 += d[c] * d[c];
        const Pack s = other[measure] * Spline::steepness(square_root(r2 * per_h2));
        for (int c = 0; c < dim; ++c) w[c] = s * d[c];
        for (int r = 0; r < dim; ++r)
          for (int c = 0; c < dim; ++c) {
            const int k = symmetric_index<dim>(r, c);
            force[r] += (own[pull + k] + other[pull + k]) * w[c];
          }
        if constexpr (with_viscosity) {
          Pack along{};
          for (int r = 0; r < dim; ++r) along += (other[speed + r] - own[speed + r]) * d[r];
          const Pack phi = h * select(along < 0.0, along, Pack{}) / (r2 + floor);
          const Pack p = (alpha - beta * phi) * phi;
          for (int r = 0; r < dim; ++r) drag[r] += p * w[r];
        }
      }
      const Pack scale = own[measure] * factor;
      for (int r = 0; r < dim; ++r) {
        store(f + slot(block, r), scale * force[r]);
        if constexpr (with_viscosity) store(viscous + slot(block, r), scale * drag[r]);
      }
    });
  }

  std::unique_ptr<Discretization> small_;  ///< of the undeformed body: its stiffness, its damping
  LawType law_;
  Kernel kernel_;
  std::size_t blocks_;
  MovingNeighbours neighbours_;
  AlignedVector<double> start_;   ///< undeformed positions, flat
  AlignedVector<double> volume_;  ///< m^dim, without the thickness
  AlignedVector<double> state_;   ///< [block][slot][lane]
  MotionRecords motion_;
  ForceRecords forces_;
};

template <int dim, class LawType>
std::optional<Trouble> UpdatedLagrangian<dim, LawType>::trouble(const double* u) const {
  const auto place = [&](std::size_t i) {
    Point x = particles_.position[i];
    for (int c = 0; c < dim; ++c) x[std::size_t(c)] += u[layout_.at(i, c)];
    return x;
  };
  if (neighbours_.crowded()) return heap_trouble(place(neighbours_.fullest()));
  const auto& loss = neighbours_.loss();
  if (!loss) return std::nullopt;
  return Trouble{
      fmt::format("particle {} has lost its neighbours: {} of {} are left{}", loss->particle,
                  loss->neighbours, loss->at_start,
                  loss->alone > 1 ? fmt::format(", and {} particles more are so", loss->alone - 1) : ""),
      "classic SPH tears under tension by itself (tensile instability): the corrected formulation, or a "
      "larger --smoothing, keeps the body whole",
      place(loss->particle)};
}

}  // namespace femsph::sph
