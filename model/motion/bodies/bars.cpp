#include "model/motion/bodies/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace femsph {

namespace {

[[noreturn]] void refuse(const Bar& bar) {
  throw Refusal(fmt::format(
      "bar {} finds no rows of points along it: bars need a regular grid of particles or "
      "elements along their axis",
      bar.name));
}

/// A coordinate of a row across the bar, and the share of the bar's area that it carries.
struct Share {
  double at, share;
};

/// The rows next to the bar along axis a, on both sides of it.
std::vector<Share> shares_across(const Bar& bar, int a, std::span<const Point> points, double tolerance) {
  const double x = bar.from[a];
  double below = -std::numeric_limits<double>::infinity(), above = std::numeric_limits<double>::infinity();
  for (const Point& p : points) {
    if (p[a] <= x + tolerance) below = std::max(below, p[a]);
    if (p[a] >= x - tolerance) above = std::min(above, p[a]);
  }
  if (!std::isfinite(below) || !std::isfinite(above)) refuse(bar);
  if (above - below <= 2 * tolerance || x - below <= tolerance) return {{below, 1.0}};
  if (above - x <= tolerance) return {{above, 1.0}};
  return {{below, (above - x) / (above - below)}, {above, (x - below) / (above - below)}};
}

double overlap(double a, double b, double c, double d) {
  return std::max(0.0, std::min(b, d) - std::max(a, c));
}

/// Fills in the points of the row in order, and the lengths of bar at each of them and between them.
void fill_row(BarRow& row, const Bar& bar, std::span<const Point> points, int dim, double tolerance) {
  const int a = row.axis;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool on = true;
    for (int c = 0; c < dim; ++c) on = on && (c == a || std::abs(points[i][c] - row.at[c]) <= tolerance);
    if (on) row.points.push_back(i);
  }
  std::sort(row.points.begin(), row.points.end(),
            [&](std::size_t i, std::size_t j) { return points[i][a] < points[j][a]; });
  if (row.points.size() < 2) refuse(bar);
  const double begin = std::min(bar.from[a], bar.to[a]), end = std::max(bar.from[a], bar.to[a]);
  const auto x = [&](std::size_t k) { return points[row.points[k]][a]; };
  const std::size_t last = row.points.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const double low = k == 0 ? x(0) : 0.5 * (x(k - 1) + x(k)),
                 high = k == last ? x(last) : 0.5 * (x(k) + x(k + 1));
    row.length.push_back(overlap(low, high, begin, end));
    if (k == last) break;
    row.gap.push_back(x(k + 1) - x(k));
    row.segment.push_back(overlap(x(k), x(k + 1), begin, end));
  }
  const auto [least, most] = std::minmax_element(row.gap.begin(), row.gap.end());
  double held = 0;
  for (double l : row.length) held += l;
  if (*most > 3 * *least || held < (end - begin) - 2 * tolerance) refuse(bar);
}

}  // namespace

std::vector<BarRow> bar_rows(const Scene& scene, std::size_t body, std::span<const Point> points,
                             double tolerance) {
  std::vector<BarRow> rows;
  for (std::size_t b = 0; b < scene.bars.size(); ++b) {
    const Bar& bar = scene.bars[b];
    if (bar.body != body) continue;
    const Material& material = scene.materials.at(bar.material);
    const BarLaw law = BarLaw::make(material.young, material.density, material.bar());
    const int dim = scene.dim(), a = bar.axis(), across = dim == 3 ? (a + 1) % 3 : 1 - a;
    for (const Share& one : shares_across(bar, across, points, tolerance)) {
      const std::vector<Share> others = dim == 3 ? shares_across(bar, (a + 2) % 3, points, tolerance)
                                                 : std::vector<Share>{{0, 1}};
      for (const Share& other : others) {
        BarRow row{b, a, bar.area * one.share * other.share, law, {}, {}, {}, {}, {}};
        row.at[std::size_t(across)] = one.at;
        if (dim == 3) row.at[std::size_t((a + 2) % 3)] = other.at;
        fill_row(row, bar, points, dim, tolerance);
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

std::string describe(const std::vector<BarRow>& rows, const Scene& scene) {
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const BarRow& row = rows[k];
    const Bar& bar = scene.bars[row.bar];
    text += k > 0 && rows[k - 1].bar == row.bar ? " and" : fmt::format(", bar {} at", bar.name);
    for (int c = 0; c < scene.dim(); ++c)
      if (c != row.axis) text += fmt::format(" {} = {:g} mm", "xyz"[c], row.at[c] * 1e3);
    if (row.area < bar.area * (1 - 1e-9)) text += fmt::format(" ({:.0f} %)", 100 * row.area / bar.area);
  }
  return text;
}

}  // namespace femsph
