// Classic SPH for large motion: neighbours and kernel gradients follow the particles, the stress follows the Jaumann rate (eq. 9 of the
// paper). Strain increments are taken at the middle of the step, x(n) - dt/2 v(n-1/2), and the spin turns the stress by
// (I - W/2)^-1 (I + W/2) (Hughes & Winget 1980), so that a turn adds no stress of its own.

#include <algorithm>
#include <cmath>

#include "model/material/kinematics.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "sph/cell_list.hpp"
#include "sph/discretize.hpp"

namespace femsph::sph {

namespace {

/// Q = (I - W/2)^-1 (I + W/2) of a spin increment W (skew).
template <int dim>
Tensor<double, dim> turn_of(const Tensor<double, dim>& W) {
  Tensor<double, dim> Q{};
  if constexpr (dim == 2) {
    const double w = 0.5 * W[1][0], d = 1 / (1 + w * w);
    Q[0][0] = Q[1][1] = (1 - w * w) * d;
    Q[1][0] = 2 * w * d;
    Q[0][1] = -Q[1][0];
  } else {  // Cayley's formula with the axial vector a of W/2
    const double a[3] = {0.5 * W[2][1], 0.5 * W[0][2], 0.5 * W[1][0]};
    const double s = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], d = 1 / (1 + s);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) Q[i][j] = d * ((i == j ? 1 - s : 0.0) + 2 * a[i] * a[j] + W[i][j]);
  }
  return Q;
}

template <int dim>
void turn(const Tensor<double, dim>& Q, double* s) {
  Symmetric<double, dim> old;
  for (int k = 0; k < symmetric_size<dim>; ++k) old[k] = s[k];
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      double sum = 0;
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l) sum += Q[i][k] * old(k, l) * Q[j][l];
      s[symmetric_index<dim>(i, j)] = sum;
    }
}

template <int dim, class LawType>
class UpdatedLagrangian final : public ParticleBody {
  static constexpr int n = symmetric_size<dim>, n_history = LawType::template history_size<dim>;

 public:
  UpdatedLagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel, const LawType& law)
      : ParticleBody(scene, body, options, particles, kernel), law_(law), kernel_(kernel), skin_(0.3 * particles_.spacing), volume_(particles_.volume) {
    Scene small = scene;  // the undeformed body moves little: its stiffness is that of the fixed neighbours
    small.large_motion = false;
    small.materials.at(small.bodies[body].material).plasticity.reset();
    small_ = discretize(small, body, options);
    const std::size_t count = particles_.size();
    stress_.assign(count * n, 0.0);
    strain_.assign(count * n, 0.0);
    history_.assign(count * n_history, 0.0);
    work_.assign(count, 0.0);
  }

  std::string describe() const override { return ParticleBody::describe() + ", updated neighbours"; }
  std::size_t bytes() const override {
    return ParticleBody::bytes() + small_->bytes() + neighbours_.size() * sizeof(int) + begin_.size() * sizeof(std::size_t) +
           (stress_.size() + strain_.size() + history_.size() + work_.size() + volume_.size() + 6 * particles_.size()) * sizeof(double);
  }
  void stiffness(const double* x, double* y) const override { small_->stiffness(x, y); }
  bool has_viscosity() const override { return options_.viscosity.on(); }
  void damping_matrix(const double* x, double* y) const override { small_->damping_matrix(x, y); }
  double strain_energy(const double*) const override {
    if constexpr (LawType::path_independent) return work_done();
    else
      return parallel_sum(work_.size(), [&](std::size_t begin, std::size_t end) {
        double s = 0;
        for (std::size_t i = begin; i < end; ++i) {
          Symmetric<double, dim> stress;
          for (int k = 0; k < n; ++k) stress[k] = stress_[i * n + std::size_t(k)];
          s += volume_[i] * thickness_ * law_.stored_energy(stress, stress, &history_[i * n_history]);
        }
        return s;
      });
  }
  double dissipated_energy(const double*) const override {
    if constexpr (LawType::path_independent) return 0;
    else return work_done();
  }

  void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) override {
    place(u);
    if (neighbours_stale()) search();
    if constexpr (requires { law_.set_step(dt); }) law_.set_step(dt);
    if (dt > 0) advance_stress(v, dt);
    else if (std::any_of(u, u + layout_.size, [](double x) { return x != 0; })) advance_stress(u, 1.0);  // an initial displacement, as one step
    if (viscous) pair_forces<true>(v, f, viscous);
    else pair_forces<false>(v, f, viscous);
  }

  void material_state(const double*, std::span<const std::size_t> points, MaterialState& out) const override {
    out.stress.assign(points.size(), {});
    out.strain.assign(points.size(), {});
    out.plastic.resize(LawType::path_independent ? 0 : points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double *s = &stress_[points[k] * n], *e = &strain_[points[k] * n];
      if constexpr (dim == 2) {
        const Symmetric<double, 2> stress{s[0], s[1], s[2]}, strain{e[0], e[1], e[2]};
        const double* own = history_.data() + points[k] * n_history;
        out.stress[k] = {s[0], s[1], law_.thickness_stress(strain, stress, own), s[2], 0, 0};
        out.strain[k] = {e[0], e[1], law_.thickness_strain(strain, stress, own), e[2], 0, 0};
      } else {
        for (std::size_t c = 0; c < 6; ++c) out.stress[k][c] = s[c], out.strain[k][c] = e[c];
      }
      if constexpr (!LawType::path_independent) out.plastic[k] = law_.plastic_strain(history_.data() + points[k] * n_history);
    }
  }

 private:
  double work_done() const {
    return parallel_sum(work_.size(), [&](std::size_t begin, std::size_t end) {
      double s = 0;
      for (std::size_t i = begin; i < end; ++i) s += work_[i];
      return s;
    });
  }
  void place(const double* u) {
    now_.resize(particles_.size());
    for (std::size_t i = 0; i < now_.size(); ++i)
      for (int a = 0; a < 3; ++a) now_[i][a] = particles_.position[i][a] + (a < dim ? u[layout_.at(i, a)] : 0.0);
  }
  /// Pairs are listed up to the kernel's radius and a skin: valid until a particle has moved half the skin.
  bool neighbours_stale() const {
    if (listed_.size() != now_.size()) return true;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      double moved = 0;
      for (int a = 0; a < dim; ++a) moved += (now_[i][a] - listed_[i][a]) * (now_[i][a] - listed_[i][a]);
      if (moved > 0.25 * skin_ * skin_) return true;
    }
    return false;
  }
  void search() {
    const double radius = kernel_.radius() + skin_;
    CellList cells(now_, dim, radius);
    begin_.assign(1, 0);
    neighbours_.clear();
    for (std::size_t i = 0; i < now_.size(); ++i) {
      cells.around(now_[i], [&](int j) {
        double r2 = 0;
        for (int a = 0; a < dim; ++a) r2 += (now_[std::size_t(j)][a] - now_[i][a]) * (now_[std::size_t(j)][a] - now_[i][a]);
        if (j != int(i) && r2 < radius * radius) neighbours_.push_back(j);
      });
      std::sort(neighbours_.begin() + std::ptrdiff_t(begin_.back()), neighbours_.end());
      begin_.push_back(neighbours_.size());
    }
    listed_ = now_;
  }

  /// Calls take(j, x_j - x_i, steepness) for the pairs of i at positions `x`.
  template <class Take>
  void each_pair(std::size_t i, const std::vector<Point>& x, Take&& take) const {
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
      const std::size_t j = std::size_t(neighbours_[k]);
      double d[dim], r2 = 0;
      for (int a = 0; a < dim; ++a) d[a] = x[j][a] - x[i][a], r2 += d[a] * d[a];
      if (r2 < kernel_.radius() * kernel_.radius()) take(j, d, r2);
    }
  }

  void advance_stress(const double* v, double dt) {
    middle_ = now_;
    for (std::size_t i = 0; i < middle_.size(); ++i)
      for (int a = 0; a < dim; ++a) middle_[i][a] -= 0.5 * dt * v[layout_.at(i, a)];
    grown_.resize(volume_.size());
    parallel_for(now_.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Tensor<double, dim> L{};
        each_pair(i, middle_, [&](std::size_t j, const double (&d)[dim], double r2) {
          const double s = volume_[j] * kernel_.steepness(std::sqrt(r2)) * dt;
          for (int r = 0; r < dim; ++r) {
            const double dv = v[layout_.at(j, r)] - v[layout_.at(i, r)];
            for (int c = 0; c < dim; ++c) L[r][c] += dv * s * d[c];
          }
        });
        advance_particle(i, L);
      }
    });
    volume_.swap(grown_);
  }

  /// L: velocity gradient times dt.
  void advance_particle(std::size_t i, const Tensor<double, dim>& L) {
    Symmetric<double, dim> D, stress, before;
    Tensor<double, dim> W;
    double growth = 0;
    for (int r = 0; r < dim; ++r) {
      growth += L[r][r];
      for (int c = 0; c < dim; ++c) {
        W[r][c] = 0.5 * (L[r][c] - L[c][r]);
        D(r, c) = 0.5 * (L[r][c] + L[c][r]);
      }
    }
    const Tensor<double, dim> Q = turn_of<dim>(W);
    turn<dim>(Q, &stress_[i * n]);
    turn<dim>(Q, &strain_[i * n]);
    for (int k = 0; k < n; ++k) before[k] = stress[k] = stress_[i * n + std::size_t(k)];
    double* own = history_.data() + i * n_history;
    [[maybe_unused]] double taken = 0;
    if constexpr (!LawType::path_independent) taken = law_.plastic_work(own);
    law_.update(D, stress, own);
    for (int k = 0; k < n; ++k) {
      stress_[i * n + std::size_t(k)] = stress[k];
      strain_[i * n + std::size_t(k)] += D[k];
      before[k] = 0.5 * (before[k] + stress[k]);
    }
    if constexpr (LawType::path_independent) work_[i] += contract(before, D) * volume_[i] * thickness_;
    else work_[i] += (law_.plastic_work(own) - taken) * volume_[i] * thickness_;
    grown_[i] = volume_[i] * (1 + growth);
  }

  template <bool with_viscosity>
  void pair_forces(const double* v, double* f, [[maybe_unused]] double* viscous) const {
    const double h = kernel_.h(), alpha = options_.viscosity.alpha * wave_speed_ * density_, beta = options_.viscosity.beta * density_;
    parallel_for(now_.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double force[dim] = {}, drag[dim] = {};
        each_pair(i, now_, [&](std::size_t j, const double (&d)[dim], double r2) {
          const double s = volume_[j] * kernel_.steepness(std::sqrt(r2));
          for (int r = 0; r < dim; ++r)
            for (int c = 0; c < dim; ++c) {
              const std::size_t k = std::size_t(symmetric_index<dim>(r, c));
              force[r] += (stress_[i * n + k] + stress_[j * n + k]) * s * d[c];
            }
          if constexpr (with_viscosity) {
            double along = 0;
            for (int r = 0; r < dim; ++r) along += (v[layout_.at(j, r)] - v[layout_.at(i, r)]) * d[r];
            const double phi = h * std::min(along, 0.0) / (r2 + options_.viscosity.gamma * h * h);
            for (int r = 0; r < dim; ++r) drag[r] += (alpha - beta * phi) * phi * s * d[r];
          }
        });
        for (int r = 0; r < dim; ++r) {
          f[layout_.at(i, r)] = volume_[i] * thickness_ * force[r];
          if constexpr (with_viscosity) viscous[layout_.at(i, r)] = volume_[i] * thickness_ * drag[r];
        }
      }
    });
  }

  LawType law_;
  Kernel kernel_;
  double skin_;
  std::unique_ptr<Discretization> small_;
  std::vector<double> volume_, grown_;  ///< m^dim, without the thickness
  std::vector<Point> now_, middle_, listed_;
  std::vector<std::size_t> begin_;
  std::vector<int> neighbours_;
  std::vector<double> stress_, strain_, history_;
  std::vector<double> work_;  ///< J: of the stress if the law stores it all, else what it does not store
};

}  // namespace

std::unique_ptr<Discretization> updated_lagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel) {
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<Discretization> {
        using LawType = std::decay_t<decltype(law)>;
        if constexpr (LargeMotionOnly<LawType>)
          throw std::runtime_error("classic SPH on updated neighbours sums rates of stress, and a neo-Hookean material has none; take corrected SPH or law = \"elastic\"");
        else if (particles.dim == 2) return std::make_unique<UpdatedLagrangian<2, LawType>>(scene, body, options, std::move(particles), kernel, law);
        else return std::make_unique<UpdatedLagrangian<3, LawType>>(scene, body, options, std::move(particles), kernel, law);
      },
      scene.material_of(scene.bodies[body]).law(scene.plane));
}

}  // namespace femsph::sph
