#include "model/results/recovery.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/numerics/principal.hpp"
#include "model/numerics/semidefinite.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

constexpr double first_radius = 2, radius_factor = 1.25;
constexpr int most_enlargements = 40,
              most_idle = 3;  ///< largest number of enlargements; of those in a row without a new direction
constexpr double least_spread = 0.02;  ///< least eigenvalue of the covariance that counts as a direction
constexpr std::size_t spare_units = 2;
constexpr double deviation_weight = 1e-3, ridge = 1e-4;  ///< of step 4
constexpr double least_pivot = 1e-8;

constexpr std::size_t coefficients_in(int dim) { return std::size_t((dim + 1) * (dim + 2) / 2); }

std::array<double, 6> cholesky_factor(const std::array<double, 6>& s, int dim) {
  const auto [xx, yy, zz, xy, yz, zx] = s;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  if (dim == 2)
    matrix.topLeftCorner<2, 2>() << xx, xy, xy, yy;
  else
    matrix << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  const Eigen::Matrix3d L = Eigen::LLT<Eigen::Matrix3d>(matrix).matrixL();
  return {L(0, 0), L(1, 0), L(1, 1), L(2, 0), L(2, 1), L(2, 2)};
}

/// Scales the weights to a sum of exactly 1, so that constants are reproduced to the last digits. Without it
/// the round-off is large where surface particles have small weights.
std::vector<Weight> scaled_to_sum_one(std::vector<Weight> weights) {
  double sum = 0;
  for (const Weight& w : weights) sum += w.weight;
  for (Weight& w : weights) w.weight /= sum;
  return weights;
}

}  // namespace

/// The units near a point, and the fit to them.
struct Recovery::Patch {
  const Factor* L = nullptr;
  Point reach{};  ///< half the box around the ellipsoid |z| < 1
  double radius = 0;
  std::vector<std::size_t> units;
  std::vector<double> weight;  ///< of each unit
  std::vector<Basis> mean;     ///< of each unit: the basis functions' means over its points
  std::array<std::array<double, most>, most> matrix{};
  Basis b{};  ///< the value at p is sum_c w_c (mean . b) mean s + ..
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
  Point mean{};
  for (const auto& shape : units_.shape) {
    factor_.push_back(cholesky_factor(shape, units_.dim));
    for (std::size_t a = 0; a < 3; ++a) {
      extent_[a] = std::max(extent_[a], std::sqrt(shape[a]));
      mean[a] += std::sqrt(shape[a]) / double(units_.shape.size());
    }
  }
  centres_ = PointGrid(centre_, units_.dim, mean);
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

/// The nearest unit, by its own measure |z|. A unit with |z| < reach lies in the box p +- reach extent_.
std::size_t Recovery::nearest(const Point& p) const {
  for (double reach = 1;; reach *= 2) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    const auto units = centres_.within(p - reach * extent_, p + reach * extent_);
    for (const std::size_t c : units) {
      const Point z = scaled(factor(c), centre_[c], p);
      if (dot(z, z) < least) least = dot(z, z), best = c;
    }
    if (least <= reach * reach || units.size() == centre_.size()) return best;
  }
}

/// Step 1.
Recovery::Patch Recovery::patch_of_nearest(const Point& p) const {
  Patch patch;
  const std::size_t unit = nearest(p);
  patch.L = &factor(unit);
  if (const Point z = scaled(*patch.L, centre_[unit], p); dot(z, z) > first_radius * first_radius)
    throw Refusal(fmt::format(
        "stress is read at ({:g}, {:g}, {:g}) m, where the body has no cell or particle within "
        "two spacings; take a finer spacing",
        p[0], p[1], p[2]));
  const auto& shape = units_.shape[units_.shape.size() > 1 ? unit : 0];
  for (std::size_t a = 0; a < 3; ++a) patch.reach[a] = std::sqrt(shape[a]);
  return patch;
}

/// Steps 2 and 3 for one R.
void Recovery::collect(Patch& patch, const Point& p, double radius) const {
  patch.radius = radius;
  patch.units.clear(), patch.weight.clear();
  double sum = 0;
  for (const std::size_t c : centres_.within(p - radius * patch.reach, p + radius * patch.reach)) {
    const Point z = scaled(*patch.L, centre_[c], p);
    const double r = dot(z, z) / (radius * radius);
    if (r >= 1) continue;
    const double quality = units_.quality.empty() ? 1.0 : units_.quality[c];
    patch.units.push_back(c);
    patch.weight.push_back(quality * volume_[c] * (1 - r) * (1 - r));
    sum += patch.weight.back();
  }
  for (double& weight : patch.weight) weight /= sum;
}

/// The normal equations of step 4, without the ridge.
void Recovery::fill_matrix(Patch& patch, const Point& p, bool deviations) const {
  const std::size_t k = units_.points_per_unit, n = coefficients_;
  patch.mean.clear(), patch.matrix = {};
  const auto add = [&](const Basis& q, double weight) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) patch.matrix[i][j] += weight * q[i] * q[j];
  };
  std::array<Basis, 8> own;
  for (std::size_t u = 0; u < patch.units.size(); ++u) {
    Basis mean{};
    for (std::size_t q = 0; q < k; ++q) {
      const std::size_t point = patch.units[u] * k + q;
      own[q] = basis((1 / patch.radius) * scaled(*patch.L, units_.place[point], p));
      for (std::size_t i = 0; i < n; ++i) mean[i] += share(point) * own[q][i];
    }
    add(mean, patch.weight[u]);
    for (std::size_t q = 0; deviations && k > 1 && q < k; ++q) {
      for (std::size_t i = 0; i < n; ++i) own[q][i] -= mean[i];
      add(own[q], deviation_weight * patch.weight[u] * share(patch.units[u] * k + q));
    }
    patch.mean.push_back(mean);
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) patch.matrix[i][j] = patch.matrix[j][i];
}

/// The number of directions in which the units are spread: eigenvalues of the covariance of z/R above
/// `least_spread`.
int Recovery::spread_directions(const Patch& patch) const {
  const auto& A = patch.matrix;
  const auto covariance = [&](std::size_t i, std::size_t j) {
    return A[i + 1][j + 1] - A[0][i + 1] * A[0][j + 1];
  };
  std::array<double, 6> moments{covariance(0, 0), covariance(1, 1), 0, covariance(0, 1), 0, 0};
  if (units_.dim == 3)
    moments[2] = covariance(2, 2), moments[4] = covariance(1, 2), moments[5] = covariance(2, 0);
  const std::array<double, 3> values = principal_values(moments);  // the largest first
  int count = 0;
  while (count < units_.dim && values[std::size_t(count)] > least_spread) ++count;
  return count;
}

/// Step 2. A body that is one or two cells thick has no spread in that direction at any R, and a larger R
/// would only smooth along the body. So the enlargement also ends after `most_idle` enlargements without a
/// new direction; the number of units needed depends on the directions found.
Recovery::Patch Recovery::around(const Point& p, bool deviations) const {
  Patch patch = patch_of_nearest(p), best;
  int directions = 0, idle = 0;
  double radius = first_radius;
  for (int turn = 0; turn < most_enlargements; ++turn, radius *= radius_factor) {
    collect(patch, p, radius);
    fill_matrix(patch, p, deviations);
    if (patch.units.empty()) continue;
    const int now = spread_directions(patch);
    const bool enough = patch.units.size() >= coefficients_in(std::max(now, 1)) + spare_units;
    if (enough && now > directions)
      best = patch, directions = now, idle = 0;
    else if (directions > 0)
      ++idle;
    if (directions == units_.dim || idle == most_idle || patch.units.size() == centre_.size()) break;
  }
  return directions > 0 ? best : patch;
}

/// Step 4: the value at p, where z = 0, is the constant term of P; b is the first column of the inverse of
/// the matrix of the normal equations.
Recovery::Patch Recovery::fit(const Point& p, bool deviations) const {
  Patch patch = around(p, deviations);
  const std::size_t n = coefficients_, dim = std::size_t(units_.dim);
  // |second degree|^2 = sum_ab c_ab^2 of P = .. + z . c z, which does not depend on the axes.
  for (std::size_t i = dim + 1; i < n; ++i) patch.matrix[i][i] += i <= 2 * dim ? ridge : 0.5 * ridge;
  std::array<double, most * most> matrix;
  for (std::size_t i = 0; i < n; ++i)
    std::copy_n(patch.matrix[i].begin(), n, matrix.begin() + std::ptrdiff_t(i * n));
  const Basis right{1};
  const auto solution = solve_semidefinite({matrix.data(), n * n}, {right.data(), n}, least_pivot, 1);
  std::copy(solution.x.begin(), solution.x.end(), patch.b.begin());
  return patch;
}

double Recovery::value(const Patch& patch, const Basis& q) const {
  double sum = 0;
  for (std::size_t i = 0; i < coefficients_; ++i) sum += q[i] * patch.b[i];
  return sum;
}

std::vector<Weight> Recovery::unit_weights(const Point& p) const {
  const Patch patch = fit(p, false);
  std::vector<Weight> out;
  for (std::size_t u = 0; u < patch.units.size(); ++u)
    out.push_back({patch.units[u], patch.weight[u] * value(patch, patch.mean[u])});
  return scaled_to_sum_one(std::move(out));
}

std::vector<Weight> Recovery::weights(const Point& p) const {
  const std::size_t k = units_.points_per_unit;
  if (k == 1) return unit_weights(p);
  const Patch patch = fit(p, true);
  std::vector<Weight> out;
  for (std::size_t u = 0; u < patch.units.size(); ++u) {
    const double mean = value(patch, patch.mean[u]);
    for (std::size_t q = patch.units[u] * k; q < (patch.units[u] + 1) * k; ++q) {
      const double own = value(patch, basis((1 / patch.radius) * scaled(*patch.L, units_.place[q], p)));
      out.push_back({q, patch.weight[u] * share(q) * (mean + deviation_weight * (own - mean))});
    }
  }
  return scaled_to_sum_one(std::move(out));
}

}  // namespace femsph
