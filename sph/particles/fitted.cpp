// Particles that follow the sides of a round or slanted body: they are the corners of the body's cells.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "model/scene/shapes/structured.hpp"
#include "sph/particles/mesh_cells.hpp"
#include "sph/particles/partial_volumes.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

namespace {

/// Adds to `volume` the integral of each corner's shape function over the cell; two Gauss points in each
/// direction integrate it exactly.
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

/// Adds to `fraction` the angle of the cell at each of its corners, as a share of the full angle. In 3D it is
/// a solid angle; of three edges a, b, c
///   tan(Omega/2) = a.(b x c) / (|a||b||c| + (a.b) |c| + (a.c) |b| + (b.c) |a|)
/// (van Oosterom and Strackee, IEEE Trans. Biomed. Engng 30, 1983).
void add_angles(const CellMesh& mesh, const std::array<int, 8>& cell, std::vector<double>& fraction) {
  const auto edge = [&](int from, int to) {
    return mesh.vertices[std::size_t(cell[to])] - mesh.vertices[std::size_t(cell[from])];
  };
  for (int v = 0; v < 1 << mesh.dim; ++v) {
    const Point a = edge(v, v ^ 1), b = edge(v, v ^ 2);
    if (mesh.dim == 2) {
      fraction[std::size_t(cell[v])] += std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b))) /
                                        (2 * std::numbers::pi);
      continue;
    }
    const Point c = edge(v, v ^ 4);
    const double la = norm(a), lb = norm(b), lc = norm(c);
    const double angle = 2 * std::atan2(std::abs(dot(a, cross(b, c))),
                                        la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la);
    fraction[std::size_t(cell[v])] += angle / (4 * std::numbers::pi);
  }
}

/// Renumbers the vertices so that neighbours are near in memory: slab by slab, a slab being eight spacings
/// thick along x, and row by row within a slab.
void sort_vertices(CellMesh& mesh, double spacing) {
  std::vector<std::array<double, 4>> key;
  for (const Point& x : mesh.vertices)
    key.push_back(
        {std::floor(x[0] / (8 * spacing)), std::floor(x[2] / spacing), std::floor(x[1] / spacing), x[0]});
  std::vector<std::size_t> order(key.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  const std::vector<Point> old = mesh.vertices;
  std::vector<int> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) mesh.vertices[i] = old[order[i]], number[order[i]] = int(i);
  for (auto& cell : mesh.cells)
    for (int v = 0; v < 1 << mesh.dim; ++v) cell[v] = number[std::size_t(cell[v])];
}

/// Marks the vertices on the surface of the body. A symmetry plane is not part of it.
std::vector<char> surface_vertices(const CellMesh& mesh, const std::vector<MirrorPlane>& planes) {
  std::vector<char> on_surface(mesh.vertices.size(), 0);
  for (const Facet& facet : boundary_of(topology_of(mesh.dim, mesh.cells))) {
    const Point &p = mesh.vertices[facet.points[0]], &q = mesh.vertices[facet.points[1]],
                &r = mesh.vertices[facet.points[mesh.dim == 3 ? 2 : 1]];
    const double tolerance = 1e-6 * std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    if (std::any_of(planes.begin(), planes.end(), [&](const MirrorPlane& m) {
          return m.holds(p, tolerance) && m.holds(q, tolerance) && m.holds(r, tolerance);
        }))
      continue;
    for (int k = 0; k < 2 * (mesh.dim - 1); ++k) on_surface[facet.points[std::size_t(k)]] = 1;
  }
  return on_surface;
}

/// The cells of a shape that can be divided into cells by a formula, with edges of about the spacing.
CellMesh divided_shape(const StructuredShape& shape, const Options& options) {
  const Point lower = shape.lower(), upper = shape.upper();
  std::array<int, 3> divisions{1, 1, 1};
  for (int a = 0; a < shape.dim(); ++a) {
    const double cells = std::round((upper[a] - lower[a]) / options.spacing);
    if (!(cells >= 1) || cells > 1e9)
      throw Refusal(fmt::format("a spacing of {:g} mm does not fit a body {:g} mm long along {}",
                                options.spacing * 1e3, (upper[a] - lower[a]) * 1e3, "xyz"[a]));
    divisions[a] = int(cells);
  }
  if (const std::string key = shape.graded_by(); !key.empty())
    throw Refusal(fmt::format(
        "SPH has one smoothing length, but the {} has cells of many sizes; leave \"{}\" out",
        shape.describe(), key));
  return shape.mesh(divisions);
}

}  // namespace

bool is_fitted(const Shape& shape, const Options& options) {
  return options.fitted && options.boundary == Boundary::none && options.jitter == 0 &&
         (shape.cells() || shape.structured());
}

std::optional<Particles> fill_fitted(const Shape& shape, const Options& options,
                                     const std::vector<MirrorPlane>& planes, std::string& why) {
  const double places = shape.measure() / std::pow(options.spacing, shape.dim());
  if (places > 5e8)
    throw std::runtime_error(fmt::format(
        "a spacing of {:g} mm needs more than {:.1e} particles (about {:.0f} GB); take a coarser one",
        options.spacing * 1e3, places, places * 300e-9));
  const StructuredShape* structured = shape.structured();
  std::optional<CellMesh> cut = structured ? divided_shape(*structured, options)
                                           : cut_to_spacing(*shape.cells(), options.spacing, why);
  if (!cut) return std::nullopt;
  CellMesh& mesh = *cut;
  if (!structured) sort_vertices(mesh, options.spacing);
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
  p.fraction.assign(p.size(), 0.0);
  for (const auto& cell : mesh.cells) add_shares(mesh, cell, p.volume), add_angles(mesh, cell, p.fraction);
  if (structured)
    match_moments(shape, planes, p.position, surface_vertices(mesh, planes),
                  p.volume);  // adds the volume between the chords and a round side
  double count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.part[i] = part_of(p.position[i], p.spacing, planes);
    p.volume[i] /= p.part[i];  // the volume in the body and its mirror images
    p.fraction[i] = std::min(p.fraction[i] / p.part[i], 1.0);
    count += p.part[i];
  }
  if (options.mass != MassRule::trapezoid)
    p.fraction.assign(p.size(), 1.0),
        p.volume.assign(p.size(), options.mass == MassRule::share ? shape.measure() / count : p.cell);
  return p;
}

Particles fill_best(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes) {
  std::string why;
  // A lattice that follows all sides is more accurate and cheaper than fitted particles.
  const bool follows = shape.cells() && follows_sides(shape, lattice_over(shape, options.spacing));
  if (!follows && is_fitted(shape, options))
    if (std::optional<Particles> fitted = fill_fitted(shape, options, planes, why)) return *std::move(fitted);
  Particles p = fill(shape, options, planes);
  p.note = why;
  return p;
}

}  // namespace femsph::sph
