#include "model/motion/bodies/critical_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/numerics/parallel.hpp"

namespace femsph {

namespace {

using Vector = AlignedVector<double>;

double inner_product(const Vector& a, const Vector& b) {
  return parallel_sum(a.size(), [&](std::size_t begin, std::size_t end) {
    double s = 0;
    for (std::size_t i = begin; i < end; ++i) s += a[i] * b[i];
    return s;
  });
}

/// The number of eigenvalues above x of the symmetric tridiagonal matrix with diagonal a and off-diagonal b,
/// by its Sturm sequence.
int eigenvalues_above(const std::vector<double>& a, const std::vector<double>& b, double x) {
  int above = 0;
  double q = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double off = k == 0 ? 0.0 : b[k - 1] * b[k - 1];
    q = a[k] - x - (k == 0 ? 0.0 : off / (q == 0 ? 1e-300 : q));
    if (q > 0) ++above;
  }
  return above;
}

double largest_eigenvalue(const std::vector<double>& a, const std::vector<double>& b) {
  double high = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double left = k > 0 ? std::abs(b[k - 1]) : 0, right = k + 1 < a.size() ? std::abs(b[k]) : 0;
    high = std::max(high, a[k] + left + right);
  }
  double low = 0;
  for (int turn = 0; turn < 100 && high - low > 1e-14 * high; ++turn) {
    const double mid = 0.5 * (low + high);
    (eigenvalues_above(a, b, mid) > 0 ? low : high) = mid;
  }
  return high;
}

/// Last component of the unit eigenvector of the tridiagonal matrix for its largest eigenvalue.
double last_component(const std::vector<double>& a, const std::vector<double>& b, double eigenvalue) {
  // Forward recurrence (T - theta) y = 0, scaled as it goes.
  double before = 0, y = 1, sum = 1;
  for (std::size_t k = 0; k + 1 < a.size(); ++k) {
    const double next = ((eigenvalue - a[k]) * y - (k > 0 ? b[k - 1] * before : 0.0)) / b[k];
    before = y;
    y = next;
    sum += y * y;
    if (sum > 1e200) {
      before *= 1e-100;
      y *= 1e-100;
      sum *= 1e-200;
    }
  }
  return std::abs(y) / std::sqrt(sum);
}

/// An upper bound of the largest eigenvalue of M^-1 A that is less than 0.2 % too large. `apply(x, y)`: y = A
/// x.
template <class Apply>
double largest_of(const Vector& inverse_mass, Apply&& apply) {
  const std::size_t n = inverse_mass.size();
  // Lanczos iteration with S = M^-1/2 A M^-1/2; the random start vector contains all modes.
  Vector root(n), q(n), before(n, 0.0), x(n), y(n);
  std::uint64_t seed = 88172645463325252ull;
  for (std::size_t i = 0; i < n; ++i) {
    root[i] = std::sqrt(inverse_mass[i]);
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    q[i] = root[i] > 0 ? double(seed >> 11) / 9007199254740992.0 - 0.5 : 0.0;
  }
  const double norm = std::sqrt(inner_product(q, q));
  if (norm == 0) return 0;
  for (double& v : q) v /= norm;
  std::vector<double> alpha, beta;
  double estimate = 0;
  constexpr int most = 120;
  for (int k = 0; k < most; ++k) {
    for (std::size_t i = 0; i < n; ++i) x[i] = root[i] * q[i];
    apply(x.data(), y.data());
    for (std::size_t i = 0; i < n; ++i) y[i] *= root[i];
    alpha.push_back(inner_product(q, y));
    const double a = alpha.back(), b = k > 0 ? beta.back() : 0.0;
    for (std::size_t i = 0; i < n; ++i) y[i] -= a * q[i] + b * before[i];
    const double next = std::sqrt(inner_product(y, y));
    const double theta = largest_eigenvalue(alpha, beta);
    if (next <= 1e-12 * theta) return theta;
    const double bound = theta + next * last_component(alpha, beta, theta);
    if (k > 10 && bound < 1.002 * theta) return bound;
    estimate = bound;
    beta.push_back(next);
    for (std::size_t i = 0; i < n; ++i) {
      before[i] = q[i];
      q[i] = y[i] / next;
    }
  }
  return estimate;
}

}  // namespace

double critical_step(const Discretization& discretization, const AlignedVector<double>& inverse_mass,
                     std::span<const double> springs) {
  const auto stiffness = [&](const double* x, double* y) {
    discretization.stiffness(x, y);
    for (std::size_t i = 0; i < springs.size(); ++i) y[i] += springs[i] * x[i];
  };
  const double elastic = largest_of(inverse_mass, stiffness);
  if (elastic <= 0) return std::numeric_limits<double>::infinity();
  double dt = 2 / std::sqrt(elastic);
  if (!discretization.has_viscosity()) return dt;
  // 4 M - 2 dt C - dt^2 K > 0 <=> dt^2 lambda_max(M^-1 (K + 2 C / dt)) < 4: bisect on dt.
  Vector viscous(inverse_mass.size());
  const auto stable = [&](double step) {
    const double lambda = largest_of(inverse_mass, [&](const double* x, double* y) {
      stiffness(x, y);
      discretization.damping_matrix(x, viscous.data());
      for (std::size_t i = 0; i < viscous.size(); ++i) y[i] += 2 / step * viscous[i];
    });
    return step * step * lambda < 4;
  };
  double low = 0, high = dt;
  for (int turn = 0; turn < 12; ++turn) {
    const double mid = 0.5 * (low + high);
    (stable(mid) ? low : high) = mid;
  }
  return low > 0 ? low : high / 4096;
}

}  // namespace femsph
