#include "sph/operators/side_areas.hpp"

#include <cmath>

#include "model/numerics/semidefinite.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "sph/operators/gradient_operator.hpp"
#include "sph/particles/cell_list.hpp"
#include "sph/particles/mesh_cells.hpp"

namespace femsph::sph {

std::vector<Point> operator_areas(const Particles& particles, const Kernel& kernel, const Options& options) {
  const auto rows = rows_of(particles, kernel, options);
  std::vector<Point> out(particles.size(), Point{});
  Row row;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    rows->row(i, row);
    const Tensor<double, 3> B = correction_of(particles, i, *rows, row, options.boundary);
    for (const Neighbour& n : row) {
      const std::size_t j = std::size_t(n.index);
      const std::size_t own = particles.own(j);
      for (int a = 0; a < particles.dim; ++a) {
        double G = 0;
        for (int c = 0; c < particles.dim; ++c) G += n.w[c] * B[c][a];
        out[own][std::size_t(a)] += particles.own_volume(i) * G * particles.sign(j, a);
        out[i][std::size_t(a)] -= particles.own_volume(i) * G;
      }
    }
  }
  return out;
}

namespace {

/// Squares of the distances from each particle to the nearest piece; `radius` squared where no piece is
/// nearer.
std::vector<double> distances(const Particles& particles, const std::vector<SidePiece>& pieces,
                              double radius) {
  std::vector<Point> at;
  for (const SidePiece& piece : pieces) at.push_back(piece.at);
  std::vector<double> out(particles.size(), radius * radius);
  if (at.empty()) return out;
  const CellList cells(at, particles.dim, radius);
  for (std::size_t i = 0; i < out.size(); ++i)
    cells.around(particles.position[i], [&](int k) {
      const Point off = at[std::size_t(k)] - particles.position[i];
      out[i] = std::min(out[i], dot(off, off));
    });
  return out;
}

}  // namespace

std::vector<PointArea> balanced_side(
    const Particles& particles, const std::vector<std::vector<SidePiece>>& pieces,
    const std::vector<std::vector<PointArea>>& hats, std::vector<Point> areas, double radius) {
  const std::size_t n = particles.size(), sides = pieces.size(), dim = std::size_t(particles.dim),
                    motions = dim == 2 ? 3 : 6;
  for (const auto& side : hats)
    for (const PointArea& part : side) areas[part.point] = areas[part.point] - part.area;
  std::vector<std::vector<double>> far, theta(sides, std::vector<double>(n, 0.0));
  for (const auto& side : pieces) far.push_back(distances(particles, side, radius));
  const double tie = 1e-6 * particles.spacing * particles.spacing;
  Point middle{};
  for (std::size_t i = 0; i < n; ++i) {
    middle = middle + (1.0 / double(n)) * particles.position[i];
    double nearest = radius * radius, count = 0;
    for (std::size_t s = 0; s < sides; ++s) nearest = std::min(nearest, far[s][i]);
    if (nearest >= radius * radius) continue;
    for (std::size_t s = 0; s < sides; ++s) count += far[s][i] < nearest + tie;
    for (std::size_t s = 0; s < sides; ++s) theta[s][i] = far[s][i] < nearest + tie ? 1 / count : 0;
  }
  double extent = 0;
  for (std::size_t i = 0; i < n; ++i) extent = std::max(extent, norm(particles.position[i] - middle));
  /// Rigid motion k at particle i: a translation along an axis, or a rotation about one through the middle.
  const auto motion = [&](std::size_t k, std::size_t i) {
    Point out{};
    if (k < dim)
      out[k] = 1;
    else {
      Point axis{};
      axis[dim == 2 ? 2 : k - dim] = 1 / extent;
      out = cross(axis, particles.position[i] - middle);
    }
    return out;
  };
  const std::size_t unknowns = sides * motions;
  std::vector<double> matrix(unknowns * unknowns, 0.0), lacking(unknowns, 0.0);
  const auto entry = [&](std::size_t s, std::size_t k, std::size_t t, std::size_t l) -> double& {
    return matrix[(s * motions + k) * unknowns + t * motions + l];
  };
  const auto meet = [&](std::size_t s, std::size_t t, std::size_t i) {
    return s != t && far[s][i] < radius * radius && far[t][i] < radius * radius;
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t s = 0; s < sides; ++s) {
      if (far[s][i] >= radius * radius) continue;
      for (std::size_t k = 0; k < motions; ++k)
        lacking[s * motions + k] -= theta[s][i] * dot(motion(k, i), areas[i]);
      for (std::size_t t = 0; t < sides; ++t)
        for (std::size_t k = 0; k < motions && meet(s, t, i); ++k)
          for (std::size_t l = 0; l < motions; ++l) {
            const double both = dot(motion(k, i), motion(l, i));
            entry(s, k, s, l) += both;
            entry(s, k, t, l) -= both;
          }
    }
  double most = 0;
  for (std::size_t k = 0; k < unknowns; ++k) most = std::max(most, matrix[k * unknowns + k]);
  const std::vector<double> m = solve_semidefinite(matrix, lacking, 1e-10 * most).x;
  std::vector<PointArea> out = hats[0];
  for (std::size_t i = 0; i < n; ++i) {
    Point more = theta[0][i] * areas[i];
    for (std::size_t t = 1; t < sides; ++t)
      for (std::size_t k = 0; k < motions && meet(0, t, i); ++k)
        more = more + (m[k] - m[t * motions + k]) * motion(k, i);
    if (dot(more, more) > 0) out.push_back({i, more});
  }
  return out;
}

std::vector<SidePiece> free_sides(const CellMesh& mesh, double size) {
  std::vector<SidePiece> out;
  for (const Facet& f : boundary_of(topology_of(mesh.dim, mesh.cells))) {
    const auto x = [&](std::size_t k) { return mesh.vertices[f.points[k]]; };
    if (mesh.dim == 2)
      add_pieces({1, {x(0), x(1)}}, size, 1, out);
    else
      add_pieces({2, {x(0), x(1), x(3), x(2)}}, size, 1, out);
  }
  return out;
}

}  // namespace femsph::sph
