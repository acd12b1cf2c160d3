#include "sph/side_areas.hpp"

#include <cmath>

#include "model/motion/vectors.hpp"
#include "model/scene/multilinear.hpp"
#include "sph/cell_list.hpp"
#include "sph/gradient_operator.hpp"

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
      const bool image = j >= particles.size();
      const std::size_t own = image ? particles.mirrored[j - particles.size()].of : j;
      for (int a = 0; a < particles.dim; ++a) {
        double G = 0;
        for (int c = 0; c < particles.dim; ++c) G += n.w[c] * B[c][a];
        out[own][std::size_t(a)] += particles.own_volume(i) * G * (image ? particles.mirrored[j - particles.size()].sign[std::size_t(a)] : 1.0);
        out[i][std::size_t(a)] -= particles.own_volume(i) * G;
      }
    }
  }
  return out;
}

std::vector<double> nearest_to(const Particles& particles, const std::vector<SidePiece>& mine, const std::vector<SidePiece>& others, double radius) {
  const auto distances = [&](const std::vector<SidePiece>& pieces) {
    std::vector<Point> at;
    for (const SidePiece& piece : pieces) at.push_back(piece.at);
    const CellList cells(at, particles.dim, radius);
    std::vector<double> out(particles.size(), radius * radius);
    for (std::size_t i = 0; i < out.size(); ++i)
      cells.around(particles.position[i], [&](int k) {
        const Point off = at[std::size_t(k)] - particles.position[i];
        out[i] = std::min(out[i], dot(off, off));
      });
    return out;
  };
  std::vector<double> share(particles.size(), 0.0);
  if (mine.empty()) return share;
  const std::vector<double> own = distances(mine), other = others.empty() ? std::vector<double>(share.size(), radius * radius) : distances(others);
  const double tie = 1e-6 * particles.spacing * particles.spacing;
  for (std::size_t i = 0; i < share.size(); ++i)
    if (own[i] < radius * radius) share[i] = std::abs(own[i] - other[i]) < tie ? 0.5 : own[i] < other[i] ? 1.0 : 0.0;
  return share;
}

std::vector<SidePiece> free_sides(const CellMesh& mesh, double size) {
  Topology cells{mesh.dim == 2 ? Topology::Kind::quadrilaterals : Topology::Kind::hexahedra, {}};
  constexpr std::array<std::size_t, 8> vtk{0, 1, 3, 2, 4, 5, 7, 6};
  for (const auto& own : mesh.cells) {
    std::array<std::size_t, 8> c{};
    for (std::size_t v = 0; v < std::size_t(1) << mesh.dim; ++v) c[v] = std::size_t(own[vtk[v]]);
    cells.cells.push_back(c);
  }
  std::vector<SidePiece> out;
  for (const Facet& f : boundary_of(cells)) {
    const auto x = [&](std::size_t k) { return mesh.vertices[f.points[k]]; };
    if (mesh.dim == 2) add_pieces({1, {x(0), x(1)}}, size, 1, out);
    else add_pieces({2, {x(0), x(1), x(3), x(2)}}, size, 1, out);
  }
  return out;
}

}  // namespace femsph::sph
