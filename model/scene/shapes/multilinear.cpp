#include "model/scene/shapes/multilinear.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace femsph {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// Solves the k x k normal equations A x = b, scaled to a unit diagonal, by Gaussian elimination. A is
// positive definite unless the patch is degenerate; zero pivots are skipped.
std::array<double, 3> solve(std::array<std::array<double, 3>, 3> A, std::array<double, 3> b, int k) {
  for (int i = 0; i < k; ++i)
    for (int j = i + 1; j < k; ++j) {
      const double factor = A[i][i] > 1e-12 ? A[j][i] / A[i][i] : 0.0;
      for (int c = i; c < k; ++c) A[j][c] -= factor * A[i][c];
      b[j] -= factor * b[i];
    }
  std::array<double, 3> x{};
  for (int i = k - 1; i >= 0; --i) {
    double rest = b[i];
    for (int c = i + 1; c < k; ++c) rest -= A[i][c] * x[c];
    x[i] = A[i][i] > 1e-12 ? rest / A[i][i] : 0.0;
  }
  return x;
}

// One step of Gauss-Newton for min |x(xi) - p|^2.
std::array<double, 3> step(const Patch& patch, const std::array<double, 3>& xi, const Point& p) {
  const Point residual = minus(p, patch.at(xi));
  std::array<Point, 3> unit{};
  std::array<double, 3> length{};
  for (int i = 0; i < patch.k; ++i) {
    unit[i] = patch.tangent(xi, i);
    length[i] = std::sqrt(dot(unit[i], unit[i]));
    for (double& c : unit[i]) c = length[i] > 0 ? c / length[i] : 0.0;
  }
  std::array<std::array<double, 3>, 3> A{};
  std::array<double, 3> b{};
  for (int i = 0; i < patch.k; ++i) {
    b[i] = dot(unit[i], residual);
    for (int j = 0; j < patch.k; ++j) A[i][j] = dot(unit[i], unit[j]);
  }
  auto dxi = solve(A, b, patch.k);
  for (int i = 0; i < patch.k; ++i) dxi[i] = length[i] > 0 ? dxi[i] / length[i] : 0.0;
  return dxi;
}

}  // namespace

Point Patch::at(const std::array<double, 3>& xi) const {
  Point x{};
  for (int v = 0; v < corner_count(); ++v) {
    double shape = 1;
    for (int i = 0; i < k; ++i) shape *= (v >> i & 1) ? xi[i] : 1 - xi[i];
    for (int c = 0; c < 3; ++c) x[c] += shape * corners[v][c];
  }
  return x;
}

Point Patch::tangent(const std::array<double, 3>& xi, int direction) const {
  Point x{};
  for (int v = 0; v < corner_count(); ++v) {
    double shape = (v >> direction & 1) ? 1 : -1;
    for (int i = 0; i < k; ++i)
      if (i != direction) shape *= (v >> i & 1) ? xi[i] : 1 - xi[i];
    for (int c = 0; c < 3; ++c) x[c] += shape * corners[v][c];
  }
  return x;
}

double distance(const Patch& patch, const Point& p) {
  constexpr int most_steps = 30;
  constexpr double settled = 1e-13;  // in coordinates of the reference cell
  std::array<double, 3> xi{0.5, 0.5, 0.5};
  for (int i = 0; i < most_steps; ++i) {
    const auto dxi = step(patch, xi, p);
    double change = 0;
    for (int c = 0; c < patch.k; ++c) {
      const double next = std::clamp(xi[c] + dxi[c], -0.25, 1.25);  // farther outside the map may be folded
      change = std::max(change, std::abs(next - xi[c]));
      xi[c] = next;
    }
    if (change < settled) break;
  }
  for (double& c : xi) c = std::clamp(c, 0.0, 1.0);
  const Point r = minus(p, patch.at(xi));
  return std::sqrt(dot(r, r));
}

double determinant(const Patch& patch, const std::array<double, 3>& xi) {
  const Point a = patch.tangent(xi, 0), b = patch.tangent(xi, 1);
  if (patch.k == 2) return a[0] * b[1] - a[1] * b[0];
  const Point c = patch.tangent(xi, 2);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

BoxGrid::Box bounding_box(const Patch& patch) {
  BoxGrid::Box box{patch.corners[0], patch.corners[0]};
  for (int v = 1; v < patch.corner_count(); ++v)
    for (int c = 0; c < 3; ++c) {
      box.lower[c] = std::min(box.lower[c], patch.corners[v][c]);
      box.upper[c] = std::max(box.upper[c], patch.corners[v][c]);
    }
  return box;
}

bool is_near(const Patch& patch, const Point& p, double tolerance) {
  const auto [lower, upper] = bounding_box(patch);
  for (int c = 0; c < 3; ++c)
    if (p[c] < lower[c] - tolerance || p[c] > upper[c] + tolerance) return false;
  return distance(patch, p) <= tolerance;
}

double smallest_corner_jacobian(const Patch& patch) {
  double smallest = determinant(patch, {0, 0, 0});
  for (int v = 1; v < patch.corner_count(); ++v)
    smallest = std::min(
        smallest, determinant(patch, {double(v & 1), double(v >> 1 & 1), double(v >> 2 & 1)}));
  return smallest;
}

namespace {

double gauss_jacobian(const Patch& patch, int q) {
  const double g[2] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
  return determinant(patch, {g[q & 1], g[q >> 1 & 1], g[q >> 2 & 1]});
}

}  // namespace

double smallest_gauss_jacobian(const Patch& patch) {
  double smallest = gauss_jacobian(patch, 0);
  for (int q = 1; q < patch.corner_count(); ++q) smallest = std::min(smallest, gauss_jacobian(patch, q));
  return smallest;
}

double measure(const Patch& patch) {
  // Gauss points of order 2 a direction integrate the determinant of a trilinear map exactly (degree 2 in
  // each variable).
  double sum = 0;
  for (int q = 0; q < patch.corner_count(); ++q) sum += gauss_jacobian(patch, q);
  return sum / patch.corner_count();
}

Point first_moment(const Patch& patch) {
  // x times the determinant is of degree 3 in each variable: two Gauss points are exact again.
  const double g[2] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
  Point sum{};
  for (int v = 0; v < patch.corner_count(); ++v) {
    const std::array<double, 3> xi{g[v & 1], g[v >> 1 & 1], g[v >> 2 & 1]};
    const double weight = determinant(patch, xi) / patch.corner_count();
    const Point x = patch.at(xi);
    for (int c = 0; c < 3; ++c) sum[c] += weight * x[c];
  }
  return sum;
}

void add_pieces(const Patch& patch, double size, double sign, std::vector<SidePiece>& out) {
  const auto count = [&](int direction) {
    double longest = 0;
    for (int v = 0; v < patch.corner_count(); ++v)
      if (!(v >> direction & 1)) {
        const Point edge = minus(patch.corners[v | 1 << direction], patch.corners[v]);
        longest = std::max(longest, std::sqrt(dot(edge, edge)));
      }
    return std::max(1, int(std::ceil(longest / size)));
  };
  const int n = count(0), m = patch.k == 2 ? count(1) : 1;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const std::array<double, 3> xi{(i + 0.5) / n, patch.k == 2 ? (j + 0.5) / m : 0.0, 0};
      const Point t = patch.tangent(xi, 0), s = patch.k == 2 ? patch.tangent(xi, 1) : Point{0, 0, 1};
      Point area{t[1] * s[2] - t[2] * s[1], t[2] * s[0] - t[0] * s[2], t[0] * s[1] - t[1] * s[0]};
      for (double& a : area) a *= sign / (n * m);
      out.push_back({patch.at(xi), std::sqrt(dot(area, area)), area});
    }
}

}  // namespace femsph
