#pragma once
// SPH on the initial neighbours: classic (small strain), with row scaling or virtual particles, and corrected.
// One step is two passes over the particles:
//   1  H = sum_j (u_j - u_i) (x) w_ij, times the correction B_i if any; law; Q = P B
//   2  f_i = V_i [ sum_j Q_j a_ij + Q_i S_i ]
// which is the exact adjoint of pass 1. Corrected: B_i = (sum_j w_ij (x) x_ij)^-1 makes the gradient of linear fields exact
// (Randles & Libersky 1996; Bonet & Lok 1999) without touching w.

#include <fmt/format.h>

#include <stdexcept>

#include "model/material/kinematics.hpp"
#include "model/material/spatial_state.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "sph/particle_body.hpp"
#include "sph/stencils.hpp"
#include "sph/viscosity.hpp"

namespace femsph::sph {

enum class Correction { none, matrix, matrix_and_hourglass };

template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
class TotalLagrangian final : public ParticleBody {
  static constexpr bool corrected = correction != Correction::none;
  static constexpr bool hourglass = correction == Correction::matrix_and_hourglass;
  static constexpr int n_symmetric = symmetric_size<dim>, n_state = point_state_size<LawType, dim>;

 public:
  TotalLagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel, const LawType& law)
      : ParticleBody(scene, body, options, std::move(particles), kernel), law_(law), stencils_(*rows_of(particles_, kernel, options), particles_.size()) {
    set_operator(*rows_of(particles_, kernel, options));
    if (options.viscosity.on()) viscosity_ = std::make_unique<PairViscosity<dim, Stencils>>(particles_, kernel, options, density_, wave_speed_, thickness_);
  }

  std::size_t bytes() const override {
    const std::size_t arrays = q_.size() + b_.size() + s_.size() + v_.size() + l_.size() + state_.size();
    return ParticleBody::bytes() + stencils_.bytes() + (adjoint_ ? adjoint_->bytes() : 0) + (viscosity_ ? viscosity_->bytes() : 0) + arrays * sizeof(double);
  }

  void internal_force(const double* given, const double* v, [[maybe_unused]] double dt, double* f, double* viscous) override {
    if constexpr (requires { law_.set_step(dt); }) law_.set_step(dt);
    const double* u = with_mirrored(given);
    strain_to_stress<Kinematics>(u, [&](std::size_t block, const Symmetric<Pack, dim>& strain) __attribute__((always_inline)) {
      if constexpr (n_state == 0) return law_.stress(strain);
      else return advance_law<LawType, Pack, dim, Kinematics>(law_, strain, reinterpret_cast<Pack*>(&state_[block * n_state * lanes]));
    });
    add_bars<Kinematics>(u, bars_.pieces, [](const BarLaw& law, double strain, BarState& state) { return law.advance(strain, state); });
    mirror_stress();
    stress_to_force(f);
    if (viscous) viscosity_->force(with_mirrored(v), layout_, viscous);
  }

  void stiffness(const double* given, double* y) const override {
    const double* x = with_mirrored(given);
    const LinearElastic elastic = law_.elastic();
    strain_to_stress<SmallStrain>(x, [&](std::size_t, const Symmetric<Pack, dim>& strain) __attribute__((always_inline)) { return elastic.stress(strain); });
    add_bars<SmallStrain>(x, bars_.pieces, [](const BarLaw& law, double strain, const BarState&) { return law.young * strain; });
    mirror_stress();
    stress_to_force(y);
    for (std::size_t i = 0; i < layout_.size; ++i) y[i] = -y[i];
  }

  bool has_viscosity() const override { return viscosity_ != nullptr; }
  void damping_matrix(const double* x, double* y) const override { viscosity_->matrix(with_mirrored(x), layout_, y); }

  double strain_energy(const double* given) const override {
    const double* u = with_mirrored(given);
    double in_bars = 0;
    each_bar<Kinematics>(u, bars_.pieces, [&](const SmearedPiece& piece, double strain, const Pull&) {
      in_bars += bars_.volume(piece) * bars_.rows[piece.row].law.stored(strain, piece.state);
    });
    return in_bars + sum_over_blocks([&](std::size_t block) {
      Tensor<Pack, dim> H;
      Pack L[dim];
      gradient<false>(block, u, H, L);
      Symmetric<Pack, dim> strain;
      Kinematics::template strain<Pack, dim>(H, strain);
      return volume(block) * law_.stored_energy(strain, stress_now(block, strain), history(block));
    });
  }

  double dissipated_energy(const double*) const override {
    const double in_bars = bars_.dissipated_energy();
    if constexpr (n_state == 0) return in_bars;
    else return in_bars + sum_over_blocks([&](std::size_t block) { return volume(block) * law_.plastic_work(history(block)); });
  }

  /// sum_i V_i kappa/2 sum_j scale_ij |H_i x_ij - u_ij|^2, with scale_ij x_ij = w_ij.
  double hourglass_energy(const double* given) const override {
    if constexpr (!hourglass) return 0;
    const double* u = with_mirrored(given);
    return sum_over_blocks([&](std::size_t block) {
      Tensor<Pack, dim> H;
      Pack L[dim], sum{};
      gradient<false>(block, u, H, L);
      stencils_.each(block, u + first(block), stride(), [&](const Pack(&difference)[dim], const Pack(&w)[dim], const Pack& scale) {
        const Pack there = select(scale > 0.0, scale, broadcast<Pack>(1.0));
        for (int r = 0; r < dim; ++r) {
          Pack e = H[r][0] * w[0] - scale * difference[r];
          for (int c = 1; c < dim; ++c) e += H[r][c] * w[c];
          sum += e * e / there;
        }
      });
      return 0.5 * kappa_ * volume(block) * sum;
    });
  }

  /// det F <= 0 at a particle.
  std::optional<Trouble> trouble(const double* given) const override {
    const double* u = with_mirrored(given);
    AlignedVector<double> det(stencils_.blocks() * lanes);
    parallel_for(stencils_.blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        Tensor<Pack, dim> F;
        Pack L[dim];
        gradient<false>(block, u, F, L);
        for (int a = 0; a < dim; ++a) F[a][a] += 1.0;
        Pack d = F[0][0] * F[1][1] - F[0][1] * F[1][0];
        if constexpr (dim == 3)
          d = d * F[2][2] + (F[0][2] * F[1][0] - F[0][0] * F[1][2]) * F[2][1] + (F[0][1] * F[1][2] - F[0][2] * F[1][1]) * F[2][0];
        store(&det[block * lanes], d);
      }
    });
    return inside_out(det, u);
  }

  void state(Archive& archive) override {
    if constexpr (n_state > 0) archive("material", state_);
    bars_.state(archive);
  }

  std::vector<BarPiece> bars(const double* u) const override {
    std::vector<BarPiece> out;
    each_bar<Kinematics>(with_mirrored(u), bars_.pieces, [&](const SmearedPiece& piece, double strain, const Pull&) {
      const BarRow& row = bars_.rows[piece.row];
      out.push_back({row.bar, particles_.position[piece.particle], row.area, piece.length, strain, row.law.stress(strain, piece.state), piece.state.plastic_strain});
    });
    return out;
  }

  void material_state(const double* given, std::span<const std::size_t> points, MaterialState& out) const override {
    const double* u = with_mirrored(given);
    out.stress.resize(points.size());
    out.strain.resize(points.size());
    out.plastic.resize(n_state == 0 ? 0 : points.size());
    Tensor<Pack, dim> H;
    Symmetric<Pack, dim> strain, stress;
    std::size_t known = std::size_t(-1);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::size_t block = points[k] / lanes, lane = points[k] % lanes;
      if (block != known) {
        Pack L[dim];
        gradient<false>(block, u, H, L);
        Kinematics::template strain<Pack, dim>(H, strain);
        stress = stress_now(block, strain);
        known = block;
      }
      Tensor<double, dim> h;
      Symmetric<double, dim> s, e;
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c) h[r][c] = H[r][c][lane];
      for (int c = 0; c < n_symmetric; ++c) s[c] = stress[c][lane], e[c] = strain[c][lane];
      if constexpr (n_state == 0) {
        spatial_state<Kinematics>(law_, h, s, e, nullptr, out.stress[k], out.strain[k]);
      } else {
        double own[n_state - 2 * n_symmetric];
        for (int c = 0; c < n_state - 2 * n_symmetric; ++c) own[c] = history(block)[c][lane];
        spatial_state<Kinematics>(law_, h, s, e, own, out.stress[k], out.strain[k]);
        out.plastic[k] = law_.plastic_strain(own);
      }
    }
  }

 private:
  static std::unique_ptr<RowSource> rows_of(const Particles& p, const Kernel& kernel, const Options& options) {
    if (options.boundary == Boundary::virtual_particles) return virtual_rows(p, kernel);
    return p.regular ? lattice_rows(p, kernel) : search_rows(p, kernel);
  }

  /// S, V, B of every particle; the adjoint's own rows where they differ.
  void set_operator(const RowSource& rows) {
    const std::size_t n = particles_.size(), padded = round_up(n, lanes);
    q_.assign(stride() * dim * dim, 0.0);
    s_.assign(padded * dim, 0.0);
    v_.assign(padded, 0.0);
    if constexpr (corrected) b_.assign(padded * n_symmetric, 0.0);
    if constexpr (hourglass) l_.assign(padded * dim, 0.0);
    state_.assign(padded * n_state, 0.0);
    const LinearElastic elastic = law_.elastic();
    kappa_ = options_.hourglass * hourglass_modulus(elastic);
    Row row;
    for (std::size_t i = 0; i < n; ++i) {
      rows.row(i, row);
      v_[i] = particles_.own_volume(i) * thickness_;
      for (const Neighbour& j : row)
        for (int a = 0; a < dim; ++a) s_[slot(i, a, dim)] += j.w[a];
      if constexpr (corrected) set_correction(i, rows, row);
    }
    if (options_.boundary == Boundary::virtual_particles) adjoint_ = std::make_unique<Stencils>(*transposed_rows(particles_, rows), n);
  }

  void set_correction(std::size_t i, const RowSource& rows, const Row& row) {
    double m[3][3] = {};
    if (options_.boundary == Boundary::weight) {  // fig. 3b: the row's weights grown so that the kernel sums to one
      for (int a = 0; a < dim; ++a) m[a][a] = rows.kernel_sum(i);
    } else {
      for (const Neighbour& j : row)
        for (int a = 0; a < dim; ++a)
          for (int c = 0; c < dim; ++c) m[a][c] += j.w[a] * offset(i, j, c);
    }
    if constexpr (dim == 2) m[2][2] = 1;
    double cofactor[3][3];
    for (int a = 0; a < 3; ++a)
      for (int c = 0; c < 3; ++c) {
        const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        cofactor[a][c] = m[a1][c1] * m[a2][c2] - m[a1][c2] * m[a2][c1];
      }
    const double det = m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
    if (!(det > 1e-6)) {
      const Point& x = particles_.position[i];
      throw std::runtime_error(fmt::format("particle {} at ({:g}, {:g}, {:g}) m has too few neighbours for a corrected gradient; take a finer spacing or a larger "
                                           "smoothing length", i, x[0], x[1], x[2]));
    }
    for (int a = 0; a < dim; ++a)
      for (int c = a; c < dim; ++c) b_[slot(i, symmetric_index<dim>(a, c), n_symmetric)] = cofactor[c][a] / det;
  }
  double offset(std::size_t i, const Neighbour& j, int c) const { return particles_.position[std::size_t(j.index)][c] - particles_.position[i][c]; }

  static std::size_t slot(std::size_t i, int component, int components) { return (i / lanes * components + component) * lanes + i % lanes; }
  std::size_t first(std::size_t block) const { return layout_.offset + block * lanes; }
  std::size_t stride() const { return layout_.component_stride; }
  FEMSPH_INLINE Pack volume(std::size_t block) const { return load<Pack>(&v_[block * lanes]); }

  /// Corrected displacement gradient of a block; L as in the stencils, of the uncorrected sum.
  template <bool with_scale>
  FEMSPH_INLINE void gradient(std::size_t block, const double* u, Tensor<Pack, dim>& H, Pack (&L)[dim]) const {
    stencils_.template gradient<with_scale>(block, u + first(block), stride(), H, L);
    if constexpr (corrected) H = times_correction(block, H);
  }
  FEMSPH_INLINE Tensor<Pack, dim> times_correction(std::size_t block, const Tensor<Pack, dim>& A) const {
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

  template <class Motion, class StressOf>
  void strain_to_stress(const double* u, StressOf&& stress_of) const {
    parallel_for(stencils_.blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        Tensor<Pack, dim> H, P;
        Pack L[dim];
        gradient<hourglass>(block, u, H, L);
        Symmetric<Pack, dim> strain;
        const auto frame = Motion::template strain<Pack, dim>(H, strain);
        const Symmetric<Pack, dim> stress = stress_of(block, strain);
        Motion::template piola<Pack, dim>(frame, strain, stress, P);
        if constexpr (corrected) P = times_correction(block, P);
        if constexpr (hourglass)
          for (int r = 0; r < dim; ++r) {
            store(&l_[(block * dim + r) * lanes], L[r]);
            for (int c = 0; c < dim; ++c) P[r][c] -= kappa_ * H[r][c];
          }
        for (int r = 0; r < dim; ++r)
          for (int c = 0; c < dim; ++c) store(&q_[first(block) + (r * dim + c) * stride()], P[r][c]);
      }
    });
  }

  /// Direction in which a bar pulls.
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
  /// Q += (A l / V) sigma pull (x) B e_a.
  template <class Motion, class Pieces, class StressOf>
  void add_bars(const double* u, Pieces& pieces, StressOf&& stress_of) const {
    each_bar<Motion>(u, pieces, [&](auto& piece, double strain, const Pull& pull) {
      const BarRow& row = bars_.rows[piece.row];
      const double p = piece.per_cell * stress_of(row.law, strain, piece.state);
      for (int c = 0; c < dim; ++c) {
        double b = c == row.axis ? 1.0 : 0.0;
        if constexpr (corrected) b = b_[slot(piece.particle, symmetric_index<dim>(row.axis, c), n_symmetric)];
        for (int r = 0; r < dim; ++r) q_[layout_.offset + piece.particle + (r * dim + c) * stride()] += p * pull.at[r] * b;
      }
    });
  }
  /// Beyond a symmetry plane Q has the mirrored components: sign_r sign_c Q_rc.
  void mirror_stress() const {
    for (std::size_t k = 0; k < particles_.mirrored.size(); ++k) {
      const Mirrored& m = particles_.mirrored[k];
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c) {
          double* q = &q_[layout_.offset + (r * dim + c) * stride()];
          q[particles_.size() + k] = m.sign[r] * m.sign[c] * q[m.of];
        }
    }
  }

  void stress_to_force(double* f) const {
    const Stencils& adjoint = adjoint_ ? *adjoint_ : stencils_;
    parallel_for(stencils_.blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        const double* q = &q_[first(block)];
        Pack force[dim];
        adjoint.divergence(block, q, stride(), force);
        for (int r = 0; r < dim; ++r) {
          for (int c = 0; c < dim; ++c) force[r] += load<Pack>(q + (r * dim + c) * stride()) * load<Pack>(&s_[(block * dim + c) * lanes]);
          if constexpr (hourglass) force[r] += 2 * kappa_ * load<Pack>(&l_[(block * dim + r) * lanes]);
          store(f + first(block) + r * stride(), volume(block) * force[r]);
        }
      }
    });
  }

  const Pack* history([[maybe_unused]] std::size_t block) const {
    if constexpr (n_state == 0) return nullptr;
    else return reinterpret_cast<const Pack*>(&state_[(block * n_state + 2 * n_symmetric) * lanes]);
  }

  FEMSPH_INLINE Symmetric<Pack, dim> stress_now([[maybe_unused]] std::size_t block, const Symmetric<Pack, dim>& strain) const {
    if constexpr (n_state == 0) return law_.stress(strain);
    else {
      Symmetric<Pack, dim> s;
      for (int k = 0; k < n_symmetric; ++k) s[k] = load<Pack>(&state_[(block * n_state + k) * lanes]);
      return s;
    }
  }

  template <class Part>
  double sum_over_blocks(Part&& part) const {
    return parallel_sum(stencils_.blocks(), [&](std::size_t begin, std::size_t end) {
      Pack sum{};
      for (std::size_t block = begin; block < end; ++block) sum += part(block);
      return horizontal_sum(sum);
    });
  }

  LawType law_;
  Stencils stencils_;
  std::unique_ptr<Stencils> adjoint_;
  std::unique_ptr<PairViscosity<dim, Stencils>> viscosity_;
  double kappa_ = 0;                       ///< hourglass stiffness, Pa
  mutable AlignedVector<double> q_;        ///< Q, one padded row per component
  mutable AlignedVector<double> l_;        ///< L of the hourglass control, [block][component][lane]
  AlignedVector<double> s_, v_, b_;        ///< S, V (with thickness, m^3), B: [block][component][lane]
  AlignedVector<double> state_;            ///< of the law, [block][value][lane]
};

}  // namespace femsph::sph
