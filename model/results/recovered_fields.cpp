#include "model/results/recovered_fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/numerics/parallel.hpp"
#include "model/numerics/principal.hpp"
#include "model/results/flow_limit.hpp"
#include "model/results/recovery.hpp"

namespace femsph {

namespace {

constexpr std::array<std::size_t, 6> nine_of_six{0, 4, 8, 1, 5, 2};  ///< xx yy zz xy yz zx in nine

}  // namespace

RecoveredFields::RecoveredFields(const Discretization& d, Plane plane) : plane_(plane) {
  const Recovery rule(d.material_units());
  const std::size_t points = d.layout().points;
  std::vector<std::vector<Weight>> all(points);
  parallel_for(
      points, 64,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) all[i] = rule.unit_weights(d.position(i));
      },
      64);
  begin_.assign(points + 1, 0);
  for (std::size_t i = 0; i < points; ++i) begin_[i + 1] = begin_[i] + all[i].size();
  near_.reserve(begin_.back());
  for (std::vector<Weight>& weights : all) {
    for (const Weight& w : weights) near_.push_back({std::uint32_t(w.point), float(w.weight)});
    std::vector<Weight>().swap(weights);
  }
}

void RecoveredFields::fill(const CellFields& cells) {
  const std::size_t points = begin_.size() - 1;
  values_.stress.resize(9 * points);
  values_.strain.resize(9 * points);
  values_.equivalent.resize(points);
  values_.principal.resize(3 * points);
  values_.plastic.resize(cells.plastic.empty() ? 0 : points);
  parallel_for(
      points, 64,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) value(i, cells);
      },
      32);
}

void RecoveredFields::value(std::size_t i, const CellFields& cells) {
  std::array<double, 6> stress{}, strain{};
  for (std::size_t n = begin_[i]; n < begin_[i + 1]; ++n)
    for (std::size_t c = 0; c < 6; ++c) {
      stress[c] = multiply_add(near_[n].weight, cells.stress[9 * near_[n].unit + nine_of_six[c]], stress[c]);
      strain[c] = multiply_add(near_[n].weight, cells.strain[9 * near_[n].unit + nine_of_six[c]], strain[c]);
    }
  if (!cells.flow.flow_stress.empty()) {
    StressBound bound{};
    bound.yield = kept_within(i, cells.flow.flow_stress);
    bound.tensile = cells.flow.tensile_flow_stress.empty() ? bound.yield
                                                           : kept_within(i, cells.flow.tensile_flow_stress);
    bound.strength = cells.flow.tensile_strength.empty() ? std::numeric_limits<double>::infinity()
                                                         : kept_within(i, cells.flow.tensile_strength);
    stress = limited(stress, bound, plane_);
  }
  for (std::size_t c = 0; c < 9; ++c)
    values_.stress[9 * i + c] = stress[std::size_t(six_of_nine[c])],
                           values_.strain[9 * i + c] = strain[std::size_t(six_of_nine[c])];
  values_.equivalent[i] = von_mises(stress);
  const std::array<double, 3> principal = principal_values(stress);
  std::copy(principal.begin(), principal.end(), &values_.principal[3 * i]);
  if (!cells.plastic.empty()) values_.plastic[i] = kept_within(i, cells.plastic);
}

/// The weighted sum, limited to the range of the units that are used.
double RecoveredFields::kept_within(std::size_t i, const std::vector<double>& of_units) const {
  double sum = 0, low = of_units[near_[begin_[i]].unit], high = low;
  for (std::size_t n = begin_[i]; n < begin_[i + 1]; ++n) {
    const double v = of_units[near_[n].unit];
    if (std::isinf(v)) return v;
    sum = multiply_add(near_[n].weight, v, sum);
    low = std::min(low, v), high = std::max(high, v);
  }
  return std::clamp(sum, low, high);
}

}  // namespace femsph
