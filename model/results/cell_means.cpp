#include "model/results/cell_means.hpp"

#include <algorithm>
#include <numeric>

#include "model/numerics/parallel.hpp"
#include "model/numerics/principal.hpp"

namespace femsph {

namespace {

constexpr std::array bounds{
    &MaterialState::flow_stress, &MaterialState::tensile_flow_stress, &MaterialState::tensile_strength};

double mean_of(const std::vector<double>& values, std::size_t e, std::size_t k, const double* shares) {
  double sum = 0;
  for (std::size_t n = 0; n < k; ++n) sum += (shares ? shares[n] : 1.0) * values[e * k + n];
  return sum;
}

}  // namespace

std::vector<double> volume_shares(const Discretization& d, std::size_t cells) {
  const std::size_t k = cells ? d.material_points() / cells : 0;
  std::vector<double> share(k > 1 ? d.material_points() : 0);
  if (!share.empty())
    parallel_for(
        cells, 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t e = begin; e < end; ++e) {
            double volume = 0;
            for (std::size_t q = e * k; q < (e + 1) * k; ++q) volume += share[q] = d.material_volume(q);
            for (std::size_t q = e * k; q < (e + 1) * k; ++q) share[q] /= volume;
          }
        },
        k);
  return share;
}

void CellMeans::fill(const Discretization& d, const double* u, const std::vector<double>& share,
                     std::size_t cells, bool with_flow, CellFields& out) {
  const std::size_t k = cells ? d.material_points() / cells : 0;
  const std::size_t at_once = cells ? std::max(std::size_t{16384}, d.material_points() / 8) / k : 0;
  out.stress.resize(9 * cells);
  out.strain.resize(9 * cells);
  out.equivalent.resize(cells);
  out.principal.resize(3 * cells);
  state_.plastic.clear();
  for (std::size_t first = 0; first < cells; first += at_once) {
    const std::size_t count = std::min(at_once, cells - first);
    points_.resize(count * k);
    std::iota(points_.begin(), points_.end(), first * k);
    d.material_state(u, points_, state_);
    if (with_flow)
      for (const auto bound : bounds) (out.flow.*bound).resize((state_.*bound).empty() ? 0 : cells);
    out.plastic.resize(state_.plastic.empty() ? 0 : cells);
    parallel_for(
        count, 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t e = begin; e < end; ++e) {
            const double* shares = share.empty() ? nullptr : &share[(first + e) * k];
            mean(e, first + e, k, shares, out);
            for (const auto bound : bounds)
              if (with_flow && !(state_.*bound).empty())
                (out.flow.*bound)[first + e] = mean_of(state_.*bound, e, k, shares);
          }
        },
        k);
  }
  if (cells == 0) out.plastic.clear();
}

/// The points e k .. e k + k - 1 of state_ belong to `cell`. With k = 1 all values remain the same to the
/// last bit.
void CellMeans::mean(std::size_t e, std::size_t cell, std::size_t k, const double* shares,
                     CellFields& out) const {
  double stress[9] = {}, strain[9] = {}, equivalent = 0, plastic = 0;
  for (std::size_t n = 0; n < k; ++n) {
    const std::size_t q = e * k + n;
    const double share = shares ? shares[n] : 1.0;
    for (int c = 0; c < 9; ++c) {
      stress[c] = multiply_add(share, state_.stress[q][six_of_nine[c]], stress[c]);
      strain[c] = multiply_add(share, state_.strain[q][six_of_nine[c]], strain[c]);
    }
    equivalent += share * von_mises(state_.stress[q]);
    if (!state_.plastic.empty()) plastic += share * state_.plastic[q];
  }
  std::copy_n(stress, 9, &out.stress[9 * cell]);
  std::copy_n(strain, 9, &out.strain[9 * cell]);
  out.equivalent[cell] = equivalent;
  const std::array<double, 3> principal = principal_values(
      {stress[0], stress[4], stress[8], stress[1], stress[5], stress[2]});  // of the mean
  std::copy(principal.begin(), principal.end(), &out.principal[3 * cell]);
  if (!state_.plastic.empty()) out.plastic[cell] = plastic;
}

}  // namespace femsph
