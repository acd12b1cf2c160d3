#include "model/scene/shapes/quadrilateral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

namespace {

const std::vector<std::string> side_names = {"bottom", "right", "top", "left"};

Patch patch_of(const std::array<Point, 4>& c) { return {2, {c[0], c[1], c[3], c[2]}}; }

}  // namespace

Point Quadrilateral::lower() const {
  Point p = corners_[0];
  for (const Point& c : corners_)
    for (int a = 0; a < 3; ++a) p[a] = std::min(p[a], c[a]);
  return p;
}

Point Quadrilateral::upper() const {
  Point p = corners_[0];
  for (const Point& c : corners_)
    for (int a = 0; a < 3; ++a) p[a] = std::max(p[a], c[a]);
  return p;
}

/// A point inside lies to the left of all four edges, since the corners are convex and counterclockwise.
bool Quadrilateral::contains(const Point& p, double tolerance) const {
  for (int k = 0; k < 4; ++k) {
    const Point &a = corners_[k], &b = corners_[(k + 1) % 4];
    const double x = b[0] - a[0], y = b[1] - a[1];
    if (!(x * (p[1] - a[1]) - y * (p[0] - a[0]) >= -tolerance * std::hypot(x, y))) return false;
  }
  return true;
}

std::vector<std::string> Quadrilateral::sides() const {
  std::vector<std::string> all = Shape::sides();
  all.insert(all.end(), side_names.begin(), side_names.end());
  return all;
}

bool Quadrilateral::on_side(const std::string& side, const Point& p, double tolerance) const {
  const auto found = std::find(side_names.begin(), side_names.end(), side);
  if (found == side_names.end()) return Shape::on_side(side, p, tolerance);
  const auto k = std::size_t(found - side_names.begin());
  return distance(Patch{1, {corners_[k], corners_[(k + 1) % 4]}}, p) <= tolerance;
}

double Quadrilateral::measure() const { return femsph::measure(patch_of(corners_)); }

Point Quadrilateral::centroid() const {
  Point c = first_moment(patch_of(corners_));
  for (double& x : c) x /= measure();
  return c;
}

/// The body lies to the left of each edge.
std::vector<SidePiece> Quadrilateral::side_pieces(const std::string& side, double size) const {
  std::vector<SidePiece> pieces;
  for (std::size_t k = 0; k < 4; ++k)
    if (side_names[k] == side) add_pieces({1, {corners_[k], corners_[(k + 1) % 4]}}, size, 1, pieces);
  return pieces;
}

std::string Quadrilateral::describe() const {
  std::string text = "quadrilateral with corners";
  for (const Point& c : corners_) text += fmt::format(" ({:g}, {:g})", 1e3 * c[0], 1e3 * c[1]);
  return text + " mm";
}

CellMesh Quadrilateral::mesh(const std::array<int, 3>& divisions) const {
  const int n = divisions[0], m = divisions[1];
  if (n < 1 || m < 1) throw std::runtime_error("a quadrilateral needs at least one cell along each side");
  CellMesh mesh;
  const Patch patch = patch_of(corners_);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) mesh.vertices.push_back(patch.at({double(i) / n, double(j) / m, 0}));
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      mesh.cells.push_back({v, v + 1, v + n + 1, v + n + 2});
    }
  return mesh;
}

namespace {

ShapePointer read_quadrilateral(Fields& body, int dim, const std::filesystem::path&) {
  std::array<Point, 4> corners;
  bool all = true;
  const char* keys[] = {"corner1", "corner2", "corner3", "corner4"};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto corner = body.vector(keys[k], Need::required, dimension::length, dim);
    corners[k] = corner.value_or(Point{});
    all = all && corner;
  }
  if (dim == 3)
    return body.fault(
               "shape", "a quadrilateral in a three-dimensional scene; expected a plane one, or a \"mesh\""),
           nullptr;
  if (!all || !dim) return nullptr;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point &a = corners[k], &b = corners[(k + 1) % 4], &c = corners[(k + 2) % 4];
    if (!((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0))
      return body.fault(keys[(k + 1) % 4],
                        fmt::format("the corners turn the wrong way at \"{}\"; expected a convex "
                                    "quadrilateral, counterclockwise from the lower left",
                                    keys[(k + 1) % 4])),
             nullptr;
  }
  return std::make_shared<Quadrilateral>(corners);
}

}  // namespace

ShapeEntry quadrilateral_entry() {
  return {{"quadrilateral",
           "a plane convex quadrilateral, given by its corners, counterclockwise",
           {{"corner1", key_holds::vector(dimension::length), "The first corner, lower left.", true},
            {"corner2", key_holds::vector(dimension::length), "The second corner, lower right.", true},
            {"corner3", key_holds::vector(dimension::length), "The third corner, upper right.", true},
            {"corner4", key_holds::vector(dimension::length), "The fourth corner, upper left.", true}}},
          read_quadrilateral};
}

}  // namespace femsph
