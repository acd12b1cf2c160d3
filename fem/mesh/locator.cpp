#include "fem/mesh/locator.hpp"

#include <algorithm>
#include <cmath>

#include "fem/mesh/geometry.hpp"
#include "model/input/faults.hpp"

namespace femsph::fem {

namespace {

struct Bounds {
  Point lower, upper;
};

Bounds bounds_of(const Mesh& mesh, std::size_t cell) {
  Bounds b{mesh.node(mesh.cell(cell)[0]), mesh.node(mesh.cell(cell)[0])};
  for (int a = 1; a < mesh.corners(); ++a)
    for (int d = 0; d < 3; ++d) {
      const double x = mesh.node(mesh.cell(cell)[a])[d];
      b.lower[d] = std::min(b.lower[d], x);
      b.upper[d] = std::max(b.upper[d], x);
    }
  return b;
}

/// Solves J d = r for d by Cramer's rule; J is given by its columns.
Point solve(const std::array<Point, 3>& column, const Point& r) {
  const auto det = [](const Point& a, const Point& b, const Point& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const double d = det(column[0], column[1], column[2]);
  return {
      det(r, column[1], column[2]) / d, det(column[0], r, column[2]) / d, det(column[0], column[1], r) / d};
}

/// Reference coordinates of p in a cell, each from -1 to 1, by Newton's method. Far outside of the cell the
/// result is not accurate, and only tells that p is not in it.
Point inverse_map(const Mesh& mesh, std::size_t cell, const Point& p) {
  Point xi{};
  for (int iteration = 0; iteration < 20; ++iteration) {
    std::array<Point, 3> J{Point{}, Point{}, Point{0, 0, 1}};
    // The map is linear in each coordinate, so a central difference is its derivative.
    for (int d = 0; d < mesh.dim; ++d) {
      Point up = xi, down = xi;
      up[d] += 1;
      down[d] -= 1;
      const Point a = map_point(mesh, cell, up), b = map_point(mesh, cell, down);
      for (int c = 0; c < mesh.dim; ++c) J[d][c] = 0.5 * (a[c] - b[c]);
    }
    Point r = map_point(mesh, cell, xi);
    for (int c = 0; c < 3; ++c) r[c] = c < mesh.dim ? p[c] - r[c] : 0.0;
    const Point step = solve(J, r);
    double largest = 0;
    for (int d = 0; d < mesh.dim; ++d) {
      xi[d] += step[d];
      largest = std::max(largest, std::abs(step[d]));
    }
    if (!(largest > 1e-14) || largest > 1e3) break;
  }
  return xi;
}

}  // namespace

Locator::Locator(const Mesh& mesh, double slack) : mesh_(mesh), slack_(slack) {
  const std::size_t n = mesh.cell_count();
  Bounds all = bounds_of(mesh, 0);
  Point cell{};
  for (std::size_t c = 0; c < n; ++c) {
    const Bounds b = bounds_of(mesh, c);
    for (int d = 0; d < 3; ++d) {
      all.lower[d] = std::min(all.lower[d], b.lower[d]);
      all.upper[d] = std::max(all.upper[d], b.upper[d]);
      cell[d] += (b.upper[d] - b.lower[d]) / static_cast<double>(n);
    }
  }
  lower_ = all.lower;
  size_ = {1, 1, 1};
  for (int d = 0; d < mesh.dim; ++d) {
    count_[d] = std::max(1, static_cast<int>((all.upper[d] - all.lower[d]) / cell[d]));
    size_[d] = (all.upper[d] - all.lower[d]) / count_[d];
  }
  const auto each = [&](auto&& body) {
    for (std::size_t c = 0; c < n; ++c) {
      const Bounds b = bounds_of(mesh, c);
      const auto low = bin(b.lower), high = bin(b.upper);
      for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
          for (int i = low[0]; i <= high[0]; ++i) body(index(i, j, k), static_cast<int>(c));
    }
  };
  begin_.assign(index(count_[0] - 1, count_[1] - 1, count_[2] - 1) + 2, 0);
  each([&](std::size_t b, int) { ++begin_[b + 1]; });
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  cells_.resize(static_cast<std::size_t>(begin_.back()));
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  each([&](std::size_t b, int c) { cells_[static_cast<std::size_t>(next[b]++)] = c; });
}

std::array<int, 3> Locator::bin(const Point& p) const {
  std::array<int, 3> r{};
  for (int d = 0; d < mesh_.dim; ++d)
    r[d] = std::clamp(static_cast<int>(std::floor((p[d] - lower_[d]) / size_[d])), 0, count_[d] - 1);
  return r;
}

Locator::Found Locator::find(const Point& p) const { return find_all(p).front(); }

std::vector<Locator::Found> Locator::find_all(const Point& p) const {
  constexpr double tolerance = 1e-6;
  Point below = p, above = p;
  for (int d = 0; d < mesh_.dim; ++d) below[d] -= tolerance * size_[d], above[d] += tolerance * size_[d];
  const auto low = bin(below), high = bin(above);
  std::vector<int> candidates;
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        candidates.insert(candidates.end(), cells_.begin() + begin_[index(i, j, k)],
                          cells_.begin() + begin_[index(i, j, k) + 1]);
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<Found> found;
  for (const int c : candidates) {
    Found f{static_cast<std::size_t>(c), inverse_map(mesh_, static_cast<std::size_t>(c), p)};
    bool inside = true;
    for (int d = 0; d < mesh_.dim; ++d) {
      inside = inside && std::abs(f.xi[d]) < 1 + tolerance;
      f.xi[d] = std::clamp(f.xi[d], -1.0, 1.0);
    }
    if (inside) found.push_back(f);
  }
  if (found.empty() && slack_ > 0) found = nearest(p);
  if (found.empty())
    throw Refusal("the point (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
                  std::to_string(p[2]) + ") m lies in no cell of the mesh");
  return found;
}

/// The cell nearest to p, if it is near enough: straight edges replace a curved side, and a point between an
/// edge and the curve lies in no cell.
std::vector<Locator::Found> Locator::nearest(const Point& p) const {
  double reach = 0;
  for (int d = 0; d < mesh_.dim; ++d) reach += size_[d] * size_[d];
  double best = slack_ * std::sqrt(reach);  // a bin is about a cell
  std::vector<Found> found;
  for (std::size_t c = 0; c < mesh_.cell_count(); ++c) {
    Found f{c, inverse_map(mesh_, c, p)};
    for (int d = 0; d < mesh_.dim; ++d) f.xi[d] = std::clamp(f.xi[d], -1.0, 1.0);
    const Point x = map_point(mesh_, c, f.xi);
    const double away = std::hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]);
    if (away < best) best = away, found.assign(1, f);
  }
  return found;
}

}  // namespace femsph::fem
