#include "model/scene/shapes/ball.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

namespace {

using std::numbers::pi;

/// Cells of the unit ball as they are laid, their common vertices found again by place.
class Lump {
 public:
  explicit Lump(double size) : grid_(1e-6 * size) {}

  /// n[0] x n[1] x n[2] cells: at(r, s, t) for r, s, t from 0 to 1. `mirrored`: at() turns the corners
  /// left-handed.
  void block(const std::array<int, 3>& n, bool mirrored,
             const std::function<Point(double, double, double)>& at) {
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          std::array<int, 8> cell;
          for (int c = 0; c < 8; ++c)
            cell[c ^ int(mirrored)] = vertex(
                at(double(i + (c & 1)) / n[0], double(j + (c >> 1 & 1)) / n[1], double(k + (c >> 2)) / n[2]));
          mesh.cells.push_back(cell);
        }
  }
  CellMesh mesh{3, {}, {}, {}, {}, {}, {}, {}, {}};

 private:
  int vertex(const Point& p) {
    const auto near = [&](double x) { return std::lround(x / grid_); };
    for (const long i : {0, -1, 1})
      for (const long j : {0, -1, 1})
        for (const long k : {0, -1, 1})
          if (const auto known = at_.find({near(p[0]) + i, near(p[1]) + j, near(p[2]) + k});
              known != at_.end())
            return known->second;
    mesh.vertices.push_back(p);
    return at_[{near(p[0]), near(p[1]), near(p[2])}] = int(mesh.vertices.size()) - 1;
  }
  double grid_;
  std::map<std::tuple<long, long, long>, int> at_;
};

/// The cube in the middle of an octant, its free edges and corner drawn in: along an axis 0.55, over an edge
/// 0.43, at the corner 0.37 each.
Point core(double r, double s, double t) {
  const double x[3] = {r, s, t};
  Point p{};
  for (int c = 0; c < 3; ++c) {
    const double a = x[(c + 1) % 3], b = x[(c + 2) % 3];
    p[c] = x[c] * ((1 - a) * (1 - b) * 0.55 + (a * (1 - b) + b * (1 - a)) * 0.43 + a * b * 0.37);
  }
  return p;
}

/// From the cube's face x = 1 out to the rim, sectors of even angle along the edges.
Point crust(double out, double s, double t) {
  const Point inner = core(1, s, t);
  const double u = std::tan(0.25 * pi * s), v = std::tan(0.25 * pi * t),
               length = std::sqrt(1 + u * u + v * v);
  return {(1 - out) * inner[0] + out / length, (1 - out) * inner[1] + out * u / length,
          (1 - out) * inner[2] + out * v / length};
}

/// The Moebius map of the unit ball onto itself that shrinks lengths by `finer` at the pole (0, 0, -1) and
/// stretches them as much at the other: a translation of hyperbolic space along z. It keeps angles, so cells
/// keep their shapes (Ratcliffe, Foundations of Hyperbolic Manifolds, 4.5.5).
Point drawn_to_pole(const Point& x, double finer) {
  const double b = -(finer - 1) / (finer + 1), xb = x[2] * b, xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const double below = 1 + 2 * xb + b * b * xx, keep = (1 - b * b) / below;
  return {keep * x[0], keep * x[1], keep * x[2] + (1 + 2 * xb + xx) * b / below};
}

}  // namespace

std::array<double, 3> OwnBall::own(const Point& p) const {
  return {p[first()] - size_.centre[first()], p[second()] - size_.centre[second()],
          p[size_.axis] - size_.centre[size_.axis]};
}

Point OwnBall::place(double a, double b, double along) const {
  Point p = size_.centre;
  p[first()] += a;
  p[second()] += b;
  p[size_.axis] += along;
  return p;
}

Point OwnBall::lower() const {
  const double r = size_.radius;
  return place(size_.part == Part::quarter ? 0 : -r, size_.part == Part::whole ? -r : 0, -r);
}
Point OwnBall::upper() const { return place(size_.radius, size_.radius, size_.radius); }

bool OwnBall::contains(const Point& p, double tolerance) const {
  const auto [a, b, along] = own(p);
  if (!(std::hypot(a, b, along) <= size_.radius + tolerance)) return false;
  return (size_.part == Part::whole || b >= -tolerance) && (size_.part != Part::quarter || a >= -tolerance);
}

std::vector<std::string> OwnBall::sides() const {
  std::vector<std::string> all = Shape::sides();
  all.push_back("outer");
  return all;
}

bool OwnBall::on_side(const std::string& side, const Point& p, double tolerance) const {
  const auto [a, b, along] = own(p);
  if (side == "outer") return std::abs(std::hypot(a, b, along) - size_.radius) <= tolerance;
  return Shape::on_side(side, p, tolerance);
}

double OwnBall::measure() const { return pi * size_.radius * size_.radius * size_.radius * quarters() / 3; }

/// Of half a ball 3/8 R beyond the plane; a quarter has the same along both axes.
Point OwnBall::centroid() const {
  const double beyond = 0.375 * size_.radius;
  return place(size_.part == Part::quarter ? beyond : 0, size_.part == Part::whole ? 0 : beyond, 0);
}

std::string OwnBall::describe() const {
  const char* part = size_.part == Part::whole ? "" : size_.part == Part::half ? "half " : "quarter ";
  return fmt::format("{}ball of radius {:g} mm", part, 1e3 * size_.radius) +
         (size_.finer > 1 ? fmt::format(", {:g} times finer at {}-", size_.finer, "xyz"[size_.axis]) : "");
}

CellMesh OwnBall::mesh(const std::array<int, 3>& divisions) const {
  for (const int n : divisions)
    if (n < 1)
      throw std::runtime_error(fmt::format("the {} needs at least one cell along each axis", describe()));
  const double size = 2.0 / divisions[size_.axis];  // of a unit ball's cells
  const auto count = [&](double length) { return std::max(1, int(std::lround(length / size))); };
  const int n = count(0.65), m = count(0.42);
  Lump lump(size);
  for (int q = 0; q < quarters(); ++q)
    for (const double z : {-1.0, 1.0}) {
      const double x = q == 0 || q == 3 ? 1 : -1, y = q < 2 ? 1 : -1;
      const bool mirrored = x * y * z < 0;
      const auto laid = [&](const Point& p) { return Point{x * p[0], y * p[1], z * p[2]}; };
      lump.block({n, n, n}, mirrored, [&](double r, double s, double t) { return laid(core(r, s, t)); });
      for (int c = 0; c < 3; ++c)  // the crust before each face, by turning the axes
        lump.block({m, n, n}, mirrored, [&](double r, double s, double t) {
          const Point p = crust(r, s, t);
          return laid({p[(3 - c) % 3], p[(4 - c) % 3], p[(5 - c) % 3]});
        });
    }
  for (Point& p : lump.mesh.vertices) {
    const Point at = drawn_to_pole(p, size_.finer);
    p = place(size_.radius * at[0], size_.radius * at[1], size_.radius * at[2]);
  }
  return lump.mesh;
}

namespace {

ShapePointer read_own_ball(Fields& body, int dim, const std::filesystem::path&) {
  using Part = OwnBall::Part;
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto radius = body.quantity("radius", Need::required, dimension::length, Sign::positive);
  const auto axis = body.choice<int>("axis", Need::optional, {{"x", 0}, {"y", 1}, {"z", 2}});
  const auto part = body.choice<Part>(
      "part", Need::optional, {{"whole", Part::whole}, {"half", Part::half}, {"quarter", Part::quarter}});
  const auto finer = body.number("finer", Need::optional);
  if (dim == 2) return body.fault("shape", "a ball in a plane scene; expected \"disc\""), nullptr;
  if (finer && !(*finer >= 1 && *finer <= 20))
    return body.fault(
               "finer",
               fmt::format(
                   "\"finer\" is {:g}; expected how many times finer the cells are at the pole, from 1 to 20",
                   *finer)),
           nullptr;
  if (!centre || !radius || !dim) return nullptr;
  return std::make_shared<OwnBall>(
      OwnBall::Size{*centre, *radius, axis.value_or(2), part.value_or(Part::whole), finer.value_or(1.0)});
}

}  // namespace

ShapeEntry ball_entry() {
  return {{"ball",
           "in space, with cells for both solvers, whole or cut",
           {{"centre", key_holds::vector(dimension::length), "its centre", true},
            {"radius", "a length", "its radius", true},
            {"axis", key_holds::words(std::vector<std::string>{"x", "y", "z"}),
             "through its poles; z unless given"},
            {"part", key_holds::words(std::vector<std::string>{"whole", "half", "quarter"}),
             "half: where the second axis across is positive; quarter: where both are"},
            {"finer", "a number", "how many times finer the cells are at the lower pole, from 1 to 20"}}},
          read_own_ball};
}

}  // namespace femsph
