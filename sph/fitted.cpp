// Particles that follow the sides of a round or slanted body: the corners of its own cells.

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "model/scene/multilinear.hpp"
#include "model/scene/structured_shapes.hpp"
#include "sph/particles.hpp"

namespace femsph::sph {

namespace {

/// det dx/dxi
double determinant(const Patch& cell, const std::array<double, 3>& xi) {
  const Point a = cell.tangent(xi, 0), b = cell.tangent(xi, 1);
  if (cell.k == 2) return a[0] * b[1] - a[1] * b[0];
  const Point c = cell.tangent(xi, 2);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Adds each corner's integral of its shape function to `volume`; two Gauss points a direction are exact.
void add_shares(const CellMesh& mesh, const std::array<int, 8>& cell, std::vector<double>& volume) {
  Patch patch{mesh.dim, {}};
  for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[cell[v]];
  const double g[2] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
  for (int q = 0; q < patch.corner_count(); ++q) {
    const std::array<double, 3> xi{g[q & 1], g[q >> 1 & 1], g[q >> 2 & 1]};
    const double weight = std::abs(determinant(patch, xi)) / patch.corner_count();
    for (int v = 0; v < patch.corner_count(); ++v) {
      double N = 1;
      for (int a = 0; a < mesh.dim; ++a) N *= v >> a & 1 ? xi[a] : 1 - xi[a];
      volume[std::size_t(cell[v])] += N * weight;
    }
  }
}

}  // namespace

bool is_fitted(const Shape& shape, const Options& options) {
  return options.fitted && options.boundary == Boundary::none && options.jitter == 0 && dynamic_cast<const StructuredShape*>(&shape);
}

Particles fill_fitted(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes) {
  const Point lower = shape.lower(), upper = shape.upper();
  std::array<int, 3> divisions{1, 1, 1};
  const double places = shape.measure() / std::pow(options.spacing, shape.dim());
  if (places > 5e8)
    throw std::runtime_error(fmt::format("a spacing of {:g} mm asks for more than {:.1e} particles (about {:.0f} GB); take a coarser one", options.spacing * 1e3,
                                         places, places * 300e-9));
  for (int a = 0; a < shape.dim(); ++a) {
    const double cells = std::round((upper[a] - lower[a]) / options.spacing);
    if (!(cells >= 1) || cells > 1e9)
      throw Refusal(fmt::format("a spacing of {:g} mm does not fit a body {:g} mm long along {}", options.spacing * 1e3, (upper[a] - lower[a]) * 1e3, "xyz"[a]));
    divisions[a] = int(cells);
  }
  if (const auto* ball = dynamic_cast<const OwnBall*>(&shape); ball && ball->size().finer > 1)
    throw Refusal(fmt::format("SPH has one smoothing length, but the {} has cells of many sizes; leave \"finer\" out", ball->describe()));
  const CellMesh mesh = dynamic_cast<const StructuredShape&>(shape).mesh(divisions);
  Particles p;
  p.dim = shape.dim();
  p.regular = false;
  p.spacing = options.spacing;
  p.cell = std::pow(options.spacing, p.dim);
  p.lattice.spacing.fill(options.spacing);
  p.position = mesh.vertices;
  p.cells = mesh.cells;
  p.part.assign(p.size(), 1.0);
  p.volume.assign(p.size(), 0.0);
  for (const auto& cell : mesh.cells) add_shares(mesh, cell, p.volume);
  double count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const MirrorPlane& m : planes)
      if (std::abs(p.position[i][m.axis] - m.at) < 1e-6 * p.spacing) p.part[i] *= 0.5;
    p.volume[i] /= p.part[i];  // that of the body with its images
    count += p.part[i];
  }
  if (options.mass != MassRule::trapezoid) p.volume.assign(p.size(), options.mass == MassRule::share ? shape.measure() / count : p.cell);
  return p;
}

}  // namespace femsph::sph
