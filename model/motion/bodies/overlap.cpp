#include "model/motion/bodies/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

using Bounds = BoxGrid::Box;

void widen(Bounds& box, const Point& p) {
  for (int c = 0; c < 3; ++c)
    box.lower[c] = std::min(box.lower[c], p[c]), box.upper[c] = std::max(box.upper[c], p[c]);
}

int corner_count(const Surface& s) { return 2 * (s.dim - 1); }

Bounds bounds_of(const Surface& s, const Facet& f) {
  Bounds box{s.now[f.points[0]], s.now[f.points[0]]};
  for (int k = 1; k < corner_count(s); ++k) widen(box, s.now[f.points[k]]);
  return box;
}

/// Calls take(a, b, c) with the two triangles of a quadrilateral, or take(a, b, b) with a segment.
template <class Take>
void each_triangle(const Surface& s, const Facet& f, Take&& take) {
  const auto& p = f.points;
  if (s.dim == 2) return take(p[0], p[1], p[1]);
  take(p[0], p[1], p[2]);
  take(p[0], p[2], p[3]);
}

/// Twice the signed area of a, b, p projected along x. Exactly the opposite value for b, a, and never zero,
/// so that a ray through an edge crosses exactly one of its two facets.
double area_along_x(const Surface& s, std::size_t a, std::size_t b, const Point& p) {
  const bool turned = a > b;
  if (turned) std::swap(a, b);
  const Point &A = s.now[a], &B = s.now[b];
  double area = (B[1] - A[1]) * (p[2] - A[2]) - (B[2] - A[2]) * (p[1] - A[1]);
  if (area == 0) area = std::numeric_limits<double>::min();
  return turned ? -area : area;
}

/// +1 where the ray from p along x leaves the body by the triangle a, b, c (in a plane: by the segment a, b),
/// -1 where it enters, 0 where it misses.
int crossing(const Surface& s, std::size_t a, std::size_t b, std::size_t c, const Point& p) {
  const Point &A = s.now[a], &B = s.now[b], &C = s.now[c];
  if (s.dim == 2) {
    if ((A[1] <= p[1]) == (B[1] <= p[1])) return 0;
    const double x = A[0] + (p[1] - A[1]) / (B[1] - A[1]) * (B[0] - A[0]);
    return x <= p[0] ? 0 : B[1] > A[1] ? 1 : -1;
  }
  const double ab = area_along_x(s, a, b, p), bc = area_along_x(s, b, c, p), ca = area_along_x(s, c, a, p);
  if ((ab > 0) != (bc > 0) || (ab > 0) != (ca > 0)) return 0;
  const double x = (bc * A[0] + ca * B[0] + ab * C[0]) / (ab + bc + ca);
  return x <= p[0] ? 0 : ab > 0 ? 1 : -1;
}

/// Where the edge from p to q goes through the triangle a, b, c (in a plane: the segment a, b), at more than
/// `tolerance` (m) from p, q and the edges of the triangle.
std::optional<Point> piercing(int dim, const Point& p, const Point& q, const Point& a, const Point& b,
                              const Point& c, double tolerance) {
  Point n = dim == 2 ? Point{b[1] - a[1], a[0] - b[0], 0} : cross(b - a, c - a);
  const double size = norm(n);
  if (!(size > 0)) return {};
  n = (1 / size) * n;
  const double before = dot(p - a, n), behind = dot(q - a, n);
  if (!(std::min(before, behind) < -tolerance && std::max(before, behind) > tolerance)) return {};
  const Point x = p + (before / (before - behind)) * (q - p);
  if (dim == 2) {
    const Point along = (1 / norm(b - a)) * (b - a);
    const bool between = dot(x - a, along) > tolerance && dot(b - x, along) > tolerance;
    return between ? std::optional(x) : std::nullopt;
  }
  const std::array<Point, 3> corner{a, b, c};
  for (int k = 0; k < 3; ++k) {
    const Point side = corner[std::size_t(k + 1) % 3] - corner[std::size_t(k)], inward = cross(n, side);
    if (!(dot(x - corner[std::size_t(k)], inward) > tolerance * norm(side))) return {};
  }
  return x;
}

/// The part of a polygon or segment with x_axis <= limit, or >= limit (the algorithm of Sutherland and
/// Hodgman).
std::vector<Point> cut(const std::vector<Point>& polygon, int axis, double limit, bool below) {
  std::vector<Point> kept;
  const auto inside = [&](const Point& p) { return below ? p[axis] <= limit : p[axis] >= limit; };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    if (inside(p)) kept.push_back(p);
    if (inside(p) != inside(q)) kept.push_back(p + ((limit - p[axis]) / (q[axis] - p[axis])) * (q - p));
  }
  return kept;
}

/// A facet that reaches into a box.
std::optional<Overlap> reach_into(const Surface& s, const Shape& box, double tolerance) {
  const Point lower = box.lower(), upper = box.upper();
  for (const Facet& f : s.facets) {
    const Bounds own = bounds_of(s, f);
    bool near = true;
    for (int c = 0; c < s.dim; ++c)
      near = near && own.lower[c] < upper[c] - tolerance && own.upper[c] > lower[c] + tolerance;
    if (!near) continue;
    std::optional<Overlap> found;
    each_triangle(s, f, [&](std::size_t a, std::size_t b, std::size_t c) {
      std::vector<Point> part{s.now[a], s.now[b]};
      if (s.dim == 3) part.push_back(s.now[c]);
      for (int d = 0; d < s.dim; ++d)
        part = cut(cut(part, d, lower[d] + tolerance, false), d, upper[d] - tolerance, true);
      if (part.empty()) return;
      Point middle{};
      for (const Point& p : part) middle = middle + (1.0 / double(part.size())) * p;
      part.push_back(middle);
      for (const Point& p : part) {
        double depth = std::numeric_limits<double>::infinity();
        for (int d = 0; d < s.dim; ++d) depth = std::min({depth, p[d] - lower[d], upper[d] - p[d]});
        if (!found || depth > found->depth) found = {p, depth};
      }
    });
    if (found) return found;
  }
  return {};
}

}  // namespace

Enclosure::Enclosure(const Surface& surface) : surface_(surface) {
  std::vector<Bounds> boxes, seen;
  for (const Facet& f : surface.facets) {
    boxes.push_back(bounds_of(surface, f));
    if (boxes.size() == 1) bounds_ = boxes[0];
    widen(bounds_, boxes.back().lower);
    widen(bounds_, boxes.back().upper);
    seen.push_back(boxes.back());
    seen.back().lower[0] = seen.back().upper[0] = 0;
  }
  grid_ = BoxGrid(boxes);
  columns_ = BoxGrid(seen);
}

bool Enclosure::reaches(const Point& p, double tolerance) const {
  for (int c = 0; c < surface_.dim; ++c)
    if (!(p[c] > bounds_.lower[c] + tolerance && p[c] < bounds_.upper[c] - tolerance)) return false;
  return true;
}

int Enclosure::winding(const Point& p) const {
  // Slightly beside p, so that on a lattice the ray does not pass exactly through points. A point so near to
  // the boundary counts as touching.
  const double hair = 1e-7 * surface_.spacing;
  const Point q{p[0], p[1] + 0.618 * hair, p[2] + (surface_.dim == 3 ? 0.414 * hair : 0.0)};
  int turns = 0;
  columns_.any_near({0, q[1], q[2]}, 0, [&](int f) {
    each_triangle(
        surface_, surface_.facets[std::size_t(f)],
        [&](std::size_t a, std::size_t b, std::size_t c) { turns += crossing(surface_, a, b, c, q); });
    return false;
  });
  return turns;
}

double Enclosure::distance(std::size_t facet, const Point& p) const {
  const Projection s = project_onto_facet(surface_.dim, surface_.corners(surface_.facets[facet]), p);
  return std::hypot(s.gap, s.beyond);
}

double Enclosure::depth(const Point& p, double tolerance) const {
  if (!reaches(p, tolerance) || winding(p) == 0) return 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (double reach = tolerance; nearest > reach; reach *= 4) {
    grid_.any_near(p, reach, [&](int f) {
      nearest = std::min(nearest, distance(std::size_t(f), p));
      return nearest <= tolerance;
    });
    if (nearest <= tolerance) return 0;
  }
  return nearest;
}

std::optional<Point> Enclosure::pierced_by(const Surface& other, double tolerance) const {
  const int corners = corner_count(other);
  for (const Facet& f : other.facets)
    for (int k = 0; k < (other.dim == 2 ? 1 : corners); ++k) {
      const Point &p = other.now[f.points[k]], &q = other.now[f.points[(k + 1) % corners]];
      Bounds box{p, p};
      widen(box, q);
      bool near = true;
      for (int c = 0; c < other.dim; ++c)
        near = near && box.lower[c] < bounds_.upper[c] && box.upper[c] > bounds_.lower[c];
      if (!near) continue;
      std::optional<Point> at;
      grid_.any_near(0.5 * (p + q), 0.5 * norm(q - p), [&](int own) {
        each_triangle(
            surface_, surface_.facets[std::size_t(own)], [&](std::size_t a, std::size_t b, std::size_t c) {
              if (!at)
                at = piercing(other.dim, p, q, surface_.now[a], surface_.now[b], surface_.now[c], tolerance);
            });
        return at.has_value();
      });
      if (at) return at;
    }
  return {};
}

std::optional<Overlap> overlap_of(const Surface& a, const Surface& b, double tolerance) {
  const Enclosure in_a(a), in_b(b);
  for (const auto& [points, body] : {std::pair(&a, &in_b), std::pair(&b, &in_a)})
    for (const Point& p : points->now)
      if (const double depth = body->depth(p, tolerance); depth > 0) return Overlap{p, depth};
  for (const auto& [edges, body] : {std::pair(&a, &in_b), std::pair(&b, &in_a)})
    if (const auto at = body->pierced_by(*edges, tolerance)) return Overlap{*at};
  return {};
}

std::optional<Overlap> overlap_of(const Surface& a, const Shape& rigid, double tolerance) {
  if (rigid.is_box()) {
    if (const auto found = reach_into(a, rigid, tolerance)) return found;
  } else {
    for (const Point& p : a.now)
      if (rigid.contains(p, -tolerance)) return Overlap{p, rigid.rigid() ? rigid.rigid()->depth(p) : 0.0};
  }
  const Point centre = 0.5 * (rigid.lower() + rigid.upper());
  if (const double depth = Enclosure(a).depth(centre, tolerance); depth > 0) return Overlap{centre, depth};
  return {};
}

}  // namespace femsph
