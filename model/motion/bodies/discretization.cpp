#include "model/motion/bodies/discretization.hpp"

#include <algorithm>
#include <cmath>

#include "model/numerics/vectors.hpp"

namespace femsph {

void Discretization::damping_matrix(const double*, double* y) const { std::fill_n(y, layout().size, 0.0); }

std::vector<Facet> Discretization::boundary() const { return boundary_of(topology()); }

std::vector<PointArea> Discretization::outward_areas(const Place& place) const {
  const std::vector<Weight> points = points_of(place);
  const auto there = [&](std::size_t p) {
    return std::binary_search(points.begin(), points.end(), Weight{p, 0},
                              [](const Weight& a, const Weight& b) { return a.point < b.point; });
  };
  const bool plane = layout().dim == 2;
  const std::ptrdiff_t corners = plane ? 2 : 4;
  std::vector<PointArea> out;
  for (const Facet& facet : boundary()) {
    if (!std::all_of(facet.points.begin(), facet.points.begin() + corners, there)) continue;
    Point x[4]{};
    for (int k = 0; k < corners; ++k) x[k] = position(facet.points[k]);
    // In the plane the body lies to the left of 0 -> 1.
    const Point area = plane ? Point{x[1][1] - x[0][1], x[0][0] - x[1][0], 0}
                             : 0.5 * cross(x[2] - x[0], x[3] - x[1]);
    for (int k = 0; k < corners; ++k) out.push_back({facet.points[k], (1.0 / double(corners)) * area});
  }
  return out;
}

std::vector<Facet> boundary_of(const Topology& topology) {
  // Sides of a cell in VTK order, each with the cell behind it.
  static const std::vector<std::array<int, 4>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  static const std::vector<std::array<int, 4>> faces{
      {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const bool plane = topology.kind != Topology::Kind::hexahedra;
  const int corners = plane ? 2 : 4;
  struct Side {
    std::array<std::size_t, 4> sorted, points;
    std::size_t number;
  };
  std::vector<Side> sides;
  for (const auto& cell : topology.cells)
    for (const auto& side : plane ? edges : faces) {
      Side s{{}, {}, sides.size()};
      for (int k = 0; k < corners; ++k) s.points[k] = cell[side[k]];
      s.sorted = s.points;
      std::sort(s.sorted.begin(), s.sorted.end());
      sides.push_back(s);
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.sorted < b.sorted; });
  std::vector<Side> lone;
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    for (j = i + 1; j < sides.size() && sides[j].sorted == sides[i].sorted; ++j) {
    }
    if (j == i + 1) lone.push_back(sides[i]);
  }
  std::sort(lone.begin(), lone.end(), [](const Side& a, const Side& b) { return a.number < b.number; });
  std::vector<Facet> out;
  for (const Side& side : lone) out.push_back({side.points});
  return out;
}

}  // namespace femsph
