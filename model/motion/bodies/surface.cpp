#include "model/motion/bodies/surface.hpp"

#include <algorithm>
#include <cmath>

#include "model/motion/bodies/motion.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

Projection project_onto_segment(const std::array<Point, 4>& x, const Point& p) {
  const Point t = x[1] - x[0];
  const double length2 = dot(t, t), length = std::sqrt(length2), s = dot(p - x[0], t) / length2;
  Projection r;
  r.share = {1 - s, s, 0, 0};
  r.foot = x[0] + s * t;
  r.normal = {t[1] / length, -t[0] / length, 0};
  r.gap = dot(p - x[0], r.normal);
  r.beyond = length * std::max({0.0, -s, s - 1});
  return r;
}

Projection project_onto_patch(const std::array<Point, 4>& x, const Point& p) {
  Projection r;
  double a = 0.5, b = 0.5;
  Point along{}, across{};
  for (int turn = 0;; ++turn) {
    r.share = {(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b};
    r.foot = r.share[0] * x[0] + r.share[1] * x[1] + r.share[2] * x[2] + r.share[3] * x[3];
    along = (1 - b) * (x[1] - x[0]) + b * (x[2] - x[3]);
    across = (1 - a) * (x[3] - x[0]) + a * (x[2] - x[1]);
    const Point off = p - r.foot;
    const double aa = dot(along, along), bb = dot(across, across), ab = dot(along, across),
                 ra = dot(off, along), rb = dot(off, across);
    const double det = aa * bb - ab * ab, da = (bb * ra - ab * rb) / det, db = (aa * rb - ab * ra) / det;
    if (turn == 8 || std::abs(da) + std::abs(db) < 1e-14) break;
    a = std::clamp(a + da, -0.5, 1.5);
    b = std::clamp(b + db, -0.5, 1.5);
  }
  r.normal = cross(along, across);
  r.normal = (1 / norm(r.normal)) * r.normal;
  r.gap = dot(p - r.foot, r.normal);
  r.beyond = std::max(
      {0.0, -a * norm(along), (a - 1) * norm(along), -b * norm(across), (b - 1) * norm(across)});
  return r;
}

}  // namespace

Projection project_onto_facet(int dim, const std::array<Point, 4>& corners, const Point& p) {
  return dim == 2 ? project_onto_segment(corners, p) : project_onto_patch(corners, p);
}

Surface::Surface(const MovingBody& body, double density, double out_of_plane)
    : dim(body.discretization->layout().dim),
      spacing(body.discretization->spacing()),
      thickness(out_of_plane) {
  const Discretization& d = *body.discretization;
  facets = d.boundary();
  std::vector<std::size_t> number(d.layout().points, d.layout().points);
  for (Facet& facet : facets)
    for (int k = 0; k < 2 * (dim - 1); ++k) {
      std::size_t& mine = number[facet.points[k]];
      if (mine == d.layout().points) {
        mine = point.size();
        point.push_back(facet.points[k]);
        reference.push_back(d.position(facet.points[k]));
        area_limit.push_back(d.mass()[facet.points[k]] / (0.5 * density * spacing));
      }
      facet.points[k] = mine;
    }
  now = reference;
  force.assign(point.size(), {});
  measure();
}

Point Surface::vector_area(const Facet& f) const {
  const std::array<Point, 4> x = corners(f);
  if (dim == 2) return thickness * Point{x[1][1] - x[0][1], x[0][0] - x[1][0], 0};
  return 0.5 * cross(x[2] - x[0], x[3] - x[1]);
}

void Surface::measure() {
  area.assign(point.size(), {});
  const int corners = 2 * (dim - 1);
  for (const Facet& f : facets) {
    const Point share = (1.0 / corners) * vector_area(f);
    for (int k = 0; k < corners; ++k) area[f.points[k]] = area[f.points[k]] + share;
  }
}

double Surface::facet_area() const {
  double sum = 0;
  for (const Facet& f : facets) sum += norm(vector_area(f));
  return facets.empty() ? 0.0 : sum / double(facets.size());
}

void Surface::move(const MovingBody& body, std::size_t p) {
  const Layout& at = body.discretization->layout();
  for (int c = 0; c < dim; ++c) now[p][c] = reference[p][c] + body.u[at.at(point[p], c)];
}

void Surface::move_all(const MovingBody& body) {
  for (std::size_t p = 0; p < point.size(); ++p) move(body, p);
}

void Surface::move_active(const MovingBody& body) {
  for (const std::size_t p : active) {
    move(body, p);
    force[p] = {};
  }
}

double Surface::fastest(const MovingBody& body) const {
  double most = 0;
  for (std::size_t p = 0; p < point.size(); ++p) {
    const Point v = velocity(body, p);
    most = std::max(most, dot(v, v));
  }
  return std::sqrt(most);
}

Point Surface::velocity(const MovingBody& body, std::size_t p) const {
  const Layout& at = body.discretization->layout();
  Point v{};
  for (int c = 0; c < dim; ++c) v[c] = body.v[at.at(point[p], c)];
  return v;
}

Point Surface::displacement(const MovingBody& body, std::size_t p) const {
  const Layout& at = body.discretization->layout();
  Point u{};
  for (int c = 0; c < dim; ++c) u[c] = body.u[at.at(point[p], c)];
  return u;
}

void Surface::add_forces_to(MovingBody& body) const {
  const Layout& at = body.discretization->layout();
  for (const std::size_t p : active)
    for (int c = 0; c < dim; ++c) body.f[at.at(point[p], c)] += force[p][c];
}

}  // namespace femsph
