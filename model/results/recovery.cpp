#include "model/results/recovery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/material/laws/tension.hpp"
#include "model/numerics/principal.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

constexpr double first_radius = 2, growing = 1.25, deviation = 1e-3, ridge = 1e-4, spread = 0.02,
                 least_pivot = 1e-8;
constexpr int spare = 2, idle_growths = 3, most_growths = 40;

constexpr int coefficients_in(int dim) { return (dim + 1) * (dim + 2) / 2; }

std::array<double, 6> factorised(const std::array<double, 6>& s, int dim) {
  std::array<double, 6> L{1, 0, 1, 0, 0, 1};
  L[0] = std::sqrt(s[0]);
  L[1] = s[3] / L[0];
  L[2] = std::sqrt(s[1] - L[1] * L[1]);
  if (dim == 3) {
    L[3] = s[5] / L[0];
    L[4] = (s[4] - L[3] * L[1]) / L[2];
    L[5] = std::sqrt(s[2] - L[3] * L[3] - L[4] * L[4]);
  }
  return L;
}

/// A b = e_0, A symmetric and positive semidefinite, by pivoted elimination; the constant first, and a
/// function whose pivot is below `least_pivot`, which the points do not determine, is left out.
template <std::size_t n>
std::array<double, n> first_column_of_inverse(std::array<std::array<double, n>, n> a, std::size_t size) {
  std::array<std::size_t, n> order{};
  for (std::size_t i = 0; i < size; ++i) order[i] = i;
  std::array<double, n> right{1}, b{};
  std::size_t rank = 0;
  for (; rank < size; ++rank) {
    std::size_t pivot = rank;
    for (std::size_t i = rank + 1; rank > 0 && i < size; ++i)
      if (a[order[i]][order[i]] > a[order[pivot]][order[pivot]]) pivot = i;
    std::swap(order[rank], order[pivot]);
    const std::size_t k = order[rank];
    if (a[k][k] < least_pivot) break;
    for (std::size_t i = rank + 1; i < size; ++i) {
      const double m = a[order[i]][k] / a[k][k];
      for (std::size_t j = rank + 1; j < size; ++j) a[order[i]][order[j]] -= m * a[k][order[j]];
      right[order[i]] -= m * right[k];
    }
  }
  for (std::size_t r = rank; r-- > 0;) {
    double sum = right[order[r]];
    for (std::size_t j = r + 1; j < rank; ++j) sum -= a[order[r]][order[j]] * b[order[j]];
    b[order[r]] = sum / a[order[r]][order[r]];
  }
  return b;
}

/// Their sum is 1 but for round-off, a thousand times larger where the surface's particles hardly count;
/// constants come out to the last digits.
std::vector<Weight> of_sum_one(std::vector<Weight> weights) {
  double sum = 0;
  for (const Weight& w : weights) sum += w.weight;
  for (Weight& w : weights) w.weight /= sum;
  return weights;
}

/// What directions points are spread in: how many eigenvalues of a covariance exceed `spread`.
int spread_directions(const std::array<double, 6>& covariance, int dim) {
  const std::array<double, 3> values = principal_values(covariance);  // the largest first
  int count = 0;
  while (count < dim && values[std::size_t(count)] > spread) ++count;
  return count;
}

}  // namespace

/// The units near a point, and what is fitted to them.
struct Recovery::Patch {
  const Factor* L = nullptr;
  Point reach{};  ///< of the ellipsoid |z| < 1 along the axes
  double radius = 0;
  std::vector<std::size_t> units;
  std::vector<double> weight;  ///< of each
  std::vector<Basis> mean;     ///< of each: the basis functions over its points
  std::array<std::array<double, most>, most> matrix{};
  Basis b{};  ///< the value is sum_c w_c (mean . b) mean s + ..
};

Recovery::Recovery(MaterialUnits units)
    : units_(std::move(units)), coefficients_(coefficients_in(units_.dim)) {
  const std::size_t n = units_.size(), k = units_.points_per_unit;
  if (n == 0) throw std::logic_error("nothing to recover from: the body has no material units");
  centre_.assign(n, Point{});
  volume_.assign(n, 0.0);
  for (std::size_t q = 0; q < units_.place.size(); ++q) volume_[q / k] += units_.volume[q];
  for (std::size_t q = 0; q < units_.place.size(); ++q)
    centre_[q / k] = centre_[q / k] + share(q) * units_.place[q];
  Point upper = lower_ = centre_[0], mean{};
  for (const auto& shape : units_.shape) {
    factor_.push_back(factorised(shape, units_.dim));
    for (std::size_t a = 0; a < 3; ++a)
      extent_[a] = std::max(extent_[a], std::sqrt(shape[a])),
      mean[a] += std::sqrt(shape[a]) / double(units_.shape.size());
  }
  for (const Point& x : centre_)
    for (std::size_t a = 0; a < 3; ++a)
      lower_[a] = std::min(lower_[a], x[a]), upper[a] = std::max(upper[a], x[a]);
  for (std::size_t a = 0; int(a) < units_.dim; ++a)
    count_[a] = std::size_t(std::clamp((upper[a] - lower_[a]) / mean[a], 1.0, 1e6));
  while (count_[0] * count_[1] * count_[2] > 8 * n + 64) {  // a thin body at a slant
    std::size_t& longest = *std::max_element(count_.begin(), count_.end());
    longest = (longest + 1) / 2;
  }
  for (std::size_t a = 0; a < 3; ++a) bin_[a] = std::max((upper[a] - lower_[a]) / double(count_[a]), 1e-300);
  const auto index = [&](const Point& x) {
    const auto b = bin_of(x);
    return (b[2] * count_[1] + b[1]) * count_[0] + b[0];
  };
  begin_.assign(count_[0] * count_[1] * count_[2] + 1, 0);
  for (const Point& x : centre_) ++begin_[index(x) + 1];
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  in_bin_.resize(n);
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t c = 0; c < n; ++c) in_bin_[next[index(centre_[c])]++] = c;
}

std::array<std::size_t, 3> Recovery::bin_of(const Point& p) const {
  std::array<std::size_t, 3> b{};
  for (std::size_t a = 0; a < 3; ++a)
    b[a] = std::size_t(std::clamp((p[a] - lower_[a]) / bin_[a], 0.0, double(count_[a] - 1)));
  return b;
}

/// Units whose centres lie in the box p +- half, and some around; in order.
std::vector<std::size_t> Recovery::within(const Point& p, const Point& half) const {
  const auto low = bin_of(p - half), high = bin_of(p + half);
  std::vector<std::size_t> out;
  for (std::size_t k = low[2]; k <= high[2]; ++k)
    for (std::size_t j = low[1]; j <= high[1]; ++j) {
      const std::size_t row = (k * count_[1] + j) * count_[0];
      out.insert(out.end(), in_bin_.begin() + std::ptrdiff_t(begin_[row + low[0]]),
                 in_bin_.begin() + std::ptrdiff_t(begin_[row + high[0] + 1]));
    }
  std::sort(out.begin(), out.end());
  return out;
}

Point Recovery::scaled(const Factor& L, const Point& x, const Point& p) const {
  Point z = x - p;
  z[0] /= L[0];
  z[1] = (z[1] - L[1] * z[0]) / L[2];
  z[2] = units_.dim == 3 ? (z[2] - L[3] * z[0] - L[4] * z[1]) / L[5] : 0.0;
  return z;
}

Recovery::Basis Recovery::basis(const Point& z) const {
  if (units_.dim == 2) return {1, z[0], z[1], z[0] * z[0], z[1] * z[1], z[0] * z[1]};
  return {1, z[0], z[1], z[2], z[0] * z[0], z[1] * z[1], z[2] * z[2], z[0] * z[1], z[1] * z[2], z[2] * z[0]};
}

/// By each unit's own measure. A unit at less than `reach` by that lies in the box p +- reach extent_.
std::size_t Recovery::nearest(const Point& p) const {
  for (double reach = 1;; reach *= 2) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    const std::vector<std::size_t> units = within(p, reach * extent_);
    for (const std::size_t c : units) {
      const Point z = scaled(factor(c), centre_[c], p);
      if (dot(z, z) < least) least = dot(z, z), best = c;
    }
    if (least <= reach * reach || units.size() == centre_.size()) return best;
  }
}

/// Steps 2 and 3 for one R, and the matrix of step 4.
void Recovery::look(Patch& patch, const Point& p, double radius, bool deviations) const {
  patch.radius = radius;
  patch.units.clear(), patch.weight.clear(), patch.mean.clear(), patch.matrix = {};
  const std::size_t k = units_.points_per_unit, n = std::size_t(coefficients_);
  double sum = 0;
  for (const std::size_t c : within(p, radius * patch.reach)) {
    const Point z = scaled(*patch.L, centre_[c], p);
    const double r = dot(z, z) / (radius * radius);
    if (r >= 1) continue;
    patch.units.push_back(c);
    patch.weight.push_back(
        (units_.quality.empty() ? 1.0 : units_.quality[c]) * volume_[c] * (1 - r) * (1 - r));
    sum += patch.weight.back();
  }
  const auto add = [&](const Basis& q, double weight) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) patch.matrix[i][j] += weight * q[i] * q[j];
  };
  std::array<Basis, 8> own;
  for (std::size_t u = 0; u < patch.units.size(); ++u) {
    patch.weight[u] /= sum;
    Basis mean{};
    for (std::size_t q = 0; q < k; ++q) {
      const std::size_t point = patch.units[u] * k + q;
      own[q] = basis((1 / radius) * scaled(*patch.L, units_.place[point], p));
      for (std::size_t i = 0; i < n; ++i) mean[i] += share(point) * own[q][i];
    }
    add(mean, patch.weight[u]);
    for (std::size_t q = 0; deviations && k > 1 && q < k; ++q) {
      for (std::size_t i = 0; i < n; ++i) own[q][i] -= mean[i];
      add(own[q], deviation * patch.weight[u] * share(patch.units[u] * k + q));
    }
    patch.mean.push_back(mean);
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) patch.matrix[i][j] = patch.matrix[j][i];
}

/// Step 2. A body that is one cell thick, or two, has no spread in that direction at any R: more of it along
/// the others would only blur. So R also ends where three growths have opened no further direction; how many
/// units are enough goes by the directions that are there.
Recovery::Patch Recovery::around(const Point& p, bool deviations) const {
  Patch patch, best;
  const std::size_t unit = nearest(p);
  if (const Point z = scaled(factor(unit), centre_[unit], p); dot(z, z) > first_radius * first_radius)
    throw Refusal(fmt::format(
        "stress is read at ({:g}, {:g}, {:g}) m, where the body has no cell or particle within "
        "two spacings; take a finer spacing",
        p[0], p[1], p[2]));
  const auto& shape = units_.shape[units_.shape.size() > 1 ? unit : 0];
  patch.L = &factor(unit);
  for (std::size_t a = 0; a < 3; ++a) patch.reach[a] = std::sqrt(shape[a]);
  int directions = 0, idle = 0;
  double radius = first_radius;
  for (int turn = 0; turn < most_growths; ++turn, radius *= growing) {
    look(patch, p, radius, deviations);
    if (patch.units.empty()) continue;
    const auto& A = patch.matrix;
    const auto covariance = [&](std::size_t i, std::size_t j) {
      return A[i + 1][j + 1] - A[0][i + 1] * A[0][j + 1];
    };
    const bool space = units_.dim == 3;
    const std::array<double, 6> moments{
        covariance(0, 0),
        covariance(1, 1),
        space ? covariance(2, 2) : 0.0,
        covariance(0, 1),
        space ? covariance(1, 2) : 0.0,
        space ? covariance(2, 0) : 0.0};
    const int now = spread_directions(moments, units_.dim);
    const bool enough = patch.units.size() >= std::size_t(coefficients_in(std::max(now, 1)) + spare);
    if (enough && now > directions)
      best = patch, directions = now, idle = 0;
    else if (directions > 0)
      ++idle;
    if (directions == units_.dim || idle == idle_growths || patch.units.size() == centre_.size()) break;
  }
  return directions > 0 ? best : patch;
}

Recovery::Patch Recovery::fit(const Point& p, bool deviations) const {
  Patch patch = around(p, deviations);
  const std::size_t n = std::size_t(coefficients_), dim = std::size_t(units_.dim);
  // |second degree|^2 = sum_ab c_ab^2 of P = .. + z . c z: the same in any axes.
  for (std::size_t i = dim + 1; i < n; ++i) patch.matrix[i][i] += i <= 2 * dim ? ridge : 0.5 * ridge;
  patch.b = first_column_of_inverse(patch.matrix, n);
  return patch;
}

std::vector<Weight> Recovery::unit_weights(const Point& p) const {
  const Patch patch = fit(p, false);
  std::vector<Weight> out;
  for (std::size_t u = 0; u < patch.units.size(); ++u) {
    double value = 0;
    for (std::size_t i = 0; i < std::size_t(coefficients_); ++i) value += patch.mean[u][i] * patch.b[i];
    out.push_back({patch.units[u], patch.weight[u] * value});
  }
  return of_sum_one(std::move(out));
}

std::vector<Weight> Recovery::weights(const Point& p) const {
  const std::size_t k = units_.points_per_unit;
  if (k == 1) return unit_weights(p);
  const Patch patch = fit(p, true);
  const auto at_p = [&](const Basis& q) {
    double value = 0;
    for (std::size_t i = 0; i < std::size_t(coefficients_); ++i) value += q[i] * patch.b[i];
    return value;
  };
  std::vector<Weight> out;
  for (std::size_t u = 0; u < patch.units.size(); ++u) {
    const double mean = at_p(patch.mean[u]);
    for (std::size_t q = patch.units[u] * k; q < (patch.units[u] + 1) * k; ++q) {
      const double own = at_p(basis((1 / patch.radius) * scaled(*patch.L, units_.place[q], p)));
      out.push_back({q, patch.weight[u] * share(q) * (mean + deviation * (own - mean))});
    }
  }
  return of_sum_one(std::move(out));
}

namespace {

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
