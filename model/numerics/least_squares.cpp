#include "model/numerics/least_squares.hpp"

#include <cmath>

namespace femsph {

namespace {

double distance(const Point& a, const Point& b) {
  return std::sqrt(
      (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/// Solves the n x n system a x = b (n <= 4) by elimination with pivoting; false if it is singular relative to
/// its own size.
bool solve(double (&a)[4][4], double (&b)[4], int n) {
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    if (std::abs(a[pivot][k]) < 1e-8) return false;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (int i = k + 1; i < n; ++i) {
      const double m = a[i][k] / a[k][k];
      for (int j = k; j < n; ++j) a[i][j] -= m * a[k][j];
      b[i] -= m * b[k];
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return true;
}

}  // namespace

std::vector<Weight> least_squares_weights(std::span<const Point> points, int dim, const Point& p,
                                          double radius, double coincident) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distance(points[i], p) < distance(points[nearest], p)) nearest = i;
  if (distance(points[nearest], p) <= coincident) return {{nearest, 1.0}};
  for (int attempt = 0; attempt < 6; ++attempt, radius *= 1.5) {
    std::vector<Weight> near;
    double a[4][4] = {}, b[4] = {1, 0, 0, 0};
    const auto basis = [&](const Point& x, double(&q)[4]) {
      q[0] = 1;
      for (int c = 0; c < dim; ++c) q[c + 1] = (x[c] - p[c]) / radius;
    };
    double total = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r = distance(points[i], p) / radius;
      if (r >= 1) continue;
      near.push_back({i, (1 - r * r) * (1 - r * r)});
      total += near.back().weight;
    }
    for (Weight& w : near) {
      w.weight /= total;
      double q[4];
      basis(points[w.point], q);
      for (int i = 0; i <= dim; ++i)
        for (int j = 0; j <= dim; ++j) a[i][j] += w.weight * q[i] * q[j];
    }
    if (near.size() <= std::size_t(dim) || !solve(a, b, dim + 1)) continue;
    for (Weight& w : near) {
      double q[4], sum = 0;
      basis(points[w.point], q);
      for (int i = 0; i <= dim; ++i) sum += b[i] * q[i];
      w.weight *= sum;
    }
    return near;
  }
  return {{nearest, 1.0}};
}

}  // namespace femsph
