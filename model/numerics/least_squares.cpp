#include "model/numerics/least_squares.hpp"

#include <array>

#include "model/numerics/semidefinite.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

/// 1 and (x - p) / radius.
std::array<double, 4> linear_basis(const Point& x, const Point& p, double radius) {
  const Point z = (1 / radius) * (x - p);
  return {1, z[0], z[1], z[2]};
}

/// The weights of the fit to the points within `radius`; empty if these do not determine a linear field.
std::vector<Weight> fit(std::span<const Point> points, std::size_t n, const Point& p, double radius) {
  constexpr double least_pivot = 1e-8;  // the weights sum to 1 and the basis is of order 1
  std::vector<Weight> near;
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = norm(points[i] - p) / radius;
    if (r >= 1) continue;
    near.push_back({i, (1 - r * r) * (1 - r * r)});
    total += near.back().weight;
  }
  if (near.size() < n) return {};
  std::vector<double> matrix(n * n, 0.0), right(n, 0.0);
  right[0] = 1;
  for (Weight& w : near) {
    w.weight /= total;
    const auto q = linear_basis(points[w.point], p, radius);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) matrix[i * n + j] += w.weight * q[i] * q[j];
  }
  const SemidefiniteSolution b = solve_semidefinite(matrix, right, least_pivot);
  if (b.rank < n) return {};
  for (Weight& w : near) {
    const auto q = linear_basis(points[w.point], p, radius);
    double value = 0;
    for (std::size_t i = 0; i < n; ++i) value += b.x[i] * q[i];
    w.weight *= value;
  }
  return near;
}

}  // namespace

std::vector<Weight> least_squares_weights(std::span<const Point> points, int dim, const Point& p,
                                          double radius, double coincident) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (norm(points[i] - p) < norm(points[nearest] - p)) nearest = i;
  if (norm(points[nearest] - p) <= coincident) return {{nearest, 1.0}};
  for (int attempt = 0; attempt < 6; ++attempt, radius *= 1.5)
    if (std::vector<Weight> weights = fit(points, std::size_t(dim) + 1, p, radius); !weights.empty())
      return weights;
  return {{nearest, 1.0}};
}

}  // namespace femsph
