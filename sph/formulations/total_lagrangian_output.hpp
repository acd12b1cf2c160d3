#pragma once
// The rest of total_lagrangian.hpp: energies, bars, the states of material points.

#include "model/material/spatial_state.hpp"
#include "model/material/stiffening.hpp"
#include "sph/formulations/stiffness_body_output.hpp"
#include "sph/formulations/total_lagrangian.hpp"

namespace femsph::sph {

/// The hourglass energy is sum_i K_i kappa/2 sum_j scale_ij |H_i x_ij - u_ij|^2, with scale_ij x_ij = w_ij.
template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
Energies TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>::energies(
    const double* given) const {
  const double* u = with_mirrored(given);
  double in_bars = 0;
  this->template each_bar<Kinematics>(
      u, bars_.pieces, [&](const SmearedPiece& piece, double strain, const Pull&) {
        in_bars += bars_.volume(piece) * bars_.rows[piece.row].law.stored(strain, piece.state);
      });
  if constexpr (mean) this->template changes_of_volume<Kinematics, false>(u);
  const auto [stored, controlled, lost] = parallel_sums<3>(blocks(), [&](std::size_t begin, std::size_t end) {
    Pack stored{}, controlled{}, lost{};
    for (std::size_t block = begin; block < end; ++block) {
      Tensor<Pack, dim> H;
      Pack L[dim];
      this->template gradient<false>(block, u, H, L);
      Symmetric<Pack, dim> strain;
      Kinematics::template strain<Pack, dim>(H, strain);
      this->template enlarge<Kinematics>(block, strain);
      const Pack volume = operator_.volume(block);
      stored += volume * law_.stored_energy(strain, stress_now(block, strain), history(block));
      if constexpr (n_state > 0) lost += volume * law_.plastic_work(history(block));
      if constexpr (hourglass)
        controlled += 0.5 * kappa_ * operator_.kernel_volume(block) * misfit(block, u, H);
    }
    return std::array{horizontal_sum(stored), horizontal_sum(controlled), horizontal_sum(lost)};
  });
  return {in_bars + stored, controlled, bars_.dissipated_energy() + lost};
}

/// sum_j scale_ij |H_i x_ij - u_ij|^2 of a block.
template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
Pack TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>::misfit(
    std::size_t block, const double* u, const Tensor<Pack, dim>& H) const {
  Pack sum{};
  if constexpr (requires { operator_.stencils().misfit(block, particles_.position, u, stride(), H); })
    if (operator_.projected())
      return operator_.stencils().misfit(block, particles_.position, u + first(block), stride(), H);
  operator_.stencils().each(block, u + first(block), stride(),
                            [&](const Pack(&difference)[dim], const Pack(&w)[dim], const Pack& scale) {
                              const Pack there = select(scale > 0.0, scale, broadcast<Pack>(1.0));
                              Pack square{};
                              for (int r = 0; r < dim; ++r) {
                                Pack e = H[r][0] * w[0] - scale * difference[r];
                                for (int c = 1; c < dim; ++c) e += H[r][c] * w[c];
                                square += e * e;
                              }
                              sum += square / there;
                            });
  return sum;
}

template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
std::vector<BarPiece> TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>::bars(
    const double* u) const {
  std::vector<BarPiece> out;
  this->template each_bar<Kinematics>(
      with_mirrored(u), bars_.pieces, [&](const SmearedPiece& piece, double strain, const Pull&) {
        const BarRow& row = bars_.rows[piece.row];
        out.push_back({row.bar, particles_.position[piece.particle], row.area, piece.length, strain,
                       row.law.stress(strain, piece.state), piece.state.plastic_strain});
      });
  return out;
}

template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
void TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>::material_state(
    const double* given, std::span<const std::size_t> points, MaterialState& out) const {
  const double* u = with_mirrored(given);
  out.stress.resize(points.size());
  out.strain.resize(points.size());
  out.plastic.resize(n_state == 0 ? 0 : points.size());
  out.resize_flow(plasticity_of(law_), points.size());
  if constexpr (mean) mean_stresses_around(u, points);
  parallel_for(points.size(), lanes, [&](std::size_t begin, std::size_t end) {
    Tensor<Pack, dim> H;
    Symmetric<Pack, dim> strain, stress;
    [[maybe_unused]] Pack excess{};
    std::size_t known = std::size_t(-1);
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t block = points[k] / lanes, lane = points[k] % lanes;
      if (block != known) {
        Pack L[dim];
        this->template gradient<false>(block, u, H, L);
        Kinematics::template strain<Pack, dim>(H, strain);
        this->template enlarge<Kinematics>(block, strain);
        stress = stress_now(block, strain);
        if constexpr (mean) excess = dilatation_->pressure_excess(block);
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
        out.set_flow(k, flow_stress(law_, own, cauchy_share<Kinematics>(e, out.strain[k][2]), out.stress[k]));
      }
      if constexpr (mean) {  // over J, as a Cauchy stress; the law's volume, as the law's stress
        double volume = 1;
        if constexpr (!std::is_same_v<Kinematics, SmallStrain>) volume += volume_change(e);
        for (int c = 0; c < 3; ++c) out.stress[k][c] += excess[lane] / volume;
      }
    }
  });
}

/// Computes theta and p where D needs them for these points: p of their neighbours, and theta of the
/// neighbours of these.
template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
void TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>::mean_stresses_around(
    const double* u, std::span<const std::size_t> points) const {
  std::vector<char> asked(blocks(), 0), near(blocks(), 0), needed(blocks(), 0);
  for (const std::size_t point : points) asked[point / lanes] = 1;
  for (std::size_t block = 0; block < blocks(); ++block)
    if (asked[block]) dilatation_->mark(block, particles_, near);
  for (std::size_t block = 0; block < blocks(); ++block)
    if (near[block]) dilatation_->mark(block, particles_, needed);
  const auto each = [&](const std::vector<char>& marked, auto&& run) {
    parallel_for(
        blocks(), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t block = begin; block < end; ++block)
            if (marked[block]) run(block);
        },
        lanes);
  };
  each(needed, [&](std::size_t block) { this->template change_of_volume<Kinematics, false>(block, u); });
  dilatation_->mirror_volume(particles_);
  each(near, [&](std::size_t block) {
    Symmetric<Pack, dim> strain;
    Kinematics::template strain<Pack, dim>(kept_gradient(block), strain);
    this->template enlarge<Kinematics>(block, strain);
    store(
        dilatation_->pressure(block), VolumeChange<Kinematics, dim>::work(strain, stress_now(block, strain)));
  });
  dilatation_->mirror_pressure(particles_);
}

template <int dim, class Stencils, class Kinematics, class LawType, Correction correction>
std::optional<Stiffening> TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>::stiffening(
    [[maybe_unused]] const double* given) const {
  if constexpr (!Stiffens<LawType>)
    return std::nullopt;
  else {
    const double* u = with_mirrored(given);
    AlignedVector<double> ratio(blocks() * lanes);
    parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        Tensor<Pack, dim> F, inverse;
        Pack L[dim];
        this->template gradient<false>(block, u, F, L);
        for (int a = 0; a < dim; ++a) F[a][a] += 1.0;
        const Pack J = invert(F, inverse);
        store(&ratio[block * lanes], femsph::stiffening<Pack, dim>(law_, inverse, J));
      }
    });
    std::size_t most = 0;
    for (std::size_t i = 1; i < particles_.size(); ++i)
      if (!(ratio[i] <= ratio[most])) most = i;
    return Stiffening{ratio[most] == ratio[most] ? ratio[most] : std::numeric_limits<double>::infinity(),
                      "particle " + std::to_string(most), this->place_now(most, u)};
  }
}

}  // namespace femsph::sph
