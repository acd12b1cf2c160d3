#include "model/results/flow_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/material/laws/tension.hpp"

namespace femsph {

namespace {

/// The weighted sum of the values, limited to their range.
double kept_within(std::span<const Weight> weights, const std::vector<double>& values) {
  double sum = 0, low = values[0], high = values[0];
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isinf(values[k])) return values[k];
    sum += weights[k].weight * values[k];
    low = std::min(low, values[k]), high = std::max(high, values[k]);
  }
  return std::clamp(sum, low, high);
}

}  // namespace

std::optional<StressBound> recovered_bound(std::span<const Weight> weights, const MaterialState& state) {
  if (state.flow_stress.empty()) return {};
  StressBound bound{};
  bound.yield = kept_within(weights, state.flow_stress);
  bound.tensile = state.tensile_flow_stress.empty() ? bound.yield
                                                    : kept_within(weights, state.tensile_flow_stress);
  bound.strength = state.tensile_strength.empty() ? std::numeric_limits<double>::infinity()
                                                  : kept_within(weights, state.tensile_strength);
  return bound;
}

std::array<double, 6> limited(const std::array<double, 6>& stress, const StressBound& bound, Plane plane) {
  std::array<double, 6> s = stress;
  const double mean = (s[0] + s[1] + s[2]) / 3, most = mean > 0 ? bound.tensile : bound.yield,
               q = von_mises(s);
  if (q > most) {
    const double middle = plane == Plane::stress ? 0.0 : mean;
    for (std::size_t c = 0; c < 6; ++c)
      s[c] = c < 3 ? middle + (s[c] - middle) * (most / q) : s[c] * (most / q);
  }
  if (std::isfinite(bound.strength)) {
    plastic::PointStress<double, 3> cut{{s[0], s[1], s[2], s[3], s[4], s[5]}, 0.0};
    plastic::cut_tension<double>(bound.strength, cut);
    for (std::size_t c = 0; c < 6; ++c) s[c] = cut.in[int(c)];
  }
  return s;
}

Recovered recovered(std::span<const Weight> weights, const MaterialState& state, Plane plane) {
  Recovered out;
  for (std::size_t k = 0; k < weights.size(); ++k)
    for (std::size_t c = 0; c < 6; ++c) {
      out.stress[c] += weights[k].weight * state.stress[k][c];
      out.strain[c] += weights[k].weight * state.strain[k][c];
    }
  if (const auto bound = recovered_bound(weights, state)) out.stress = limited(out.stress, *bound, plane);
  if (!state.plastic.empty()) out.plastic = kept_within(weights, state.plastic);
  return out;
}

}  // namespace femsph
