#include "model/scene/shapes/ball.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/merged_points.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

namespace {

using std::numbers::pi;

/// Cells of the unit ball, block by block; blocks that meet share their vertices.
class HexBlocks {
 public:
  explicit HexBlocks(double size) : vertices_(size) {}

  /// n[0] x n[1] x n[2] cells; at(r, s, t) is the place of a vertex for r, s, t from 0 to 1. `mirrored`: at()
  /// is left-handed.
  void block(const std::array<int, 3>& n, bool mirrored,
             const std::function<Point(double, double, double)>& at) {
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          std::array<int, 8> cell;
          for (int c = 0; c < 8; ++c)
            cell[c ^ int(mirrored)] = vertices_.number(
                at(double(i + (c & 1)) / n[0], double(j + (c >> 1 & 1)) / n[1], double(k + (c >> 2)) / n[2]));
          cells_.push_back(cell);
        }
  }
  CellMesh mesh() const { return {3, vertices_.points(), cells_, {}, {}, {}, {}, {}, {}}; }

 private:
  MergedPoints vertices_;
  std::vector<std::array<int, 8>> cells_;
};

/// The block at the centre of an octant: a cube whose outer edges and corner are moved inwards. Its vertices
/// lie at 0.55 on the axes, and have the coordinates 0.43 at the middle of an outer edge and 0.37 at the
/// corner.
Point core_block(double r, double s, double t) {
  const double x[3] = {r, s, t};
  Point p{};
  for (int c = 0; c < 3; ++c) {
    const double a = x[(c + 1) % 3], b = x[(c + 2) % 3];
    p[c] = x[c] * ((1 - a) * (1 - b) * 0.55 + (a * (1 - b) + b * (1 - a)) * 0.43 + a * b * 0.37);
  }
  return p;
}

/// The block from the face r = 1 of that one to the sphere; equal angles between the vertices along its
/// edges.
Point outer_block(double out, double s, double t) {
  const Point inner = core_block(1, s, t);
  const double u = std::tan(0.25 * pi * s), v = std::tan(0.25 * pi * t),
               length = std::sqrt(1 + u * u + v * v);
  return {(1 - out) * inner[0] + out / length, (1 - out) * inner[1] + out * u / length,
          (1 - out) * inner[2] + out * v / length};
}

/// The Moebius map of the unit ball onto itself that shrinks lengths by the factor `finer` at the pole (0, 0,
/// -1) and stretches them by it at the opposite pole: a translation of hyperbolic space along z. It preserves
/// angles, and so the shapes of the cells (Ratcliffe, Foundations of Hyperbolic Manifolds, 4.5.5).
Point moebius_map(const Point& x, double finer) {
  const double b = -(finer - 1) / (finer + 1), xb = x[2] * b, xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const double below = 1 + 2 * xb + b * b * xx, keep = (1 - b * b) / below;
  return {keep * x[0], keep * x[1], keep * x[2] + (1 + 2 * xb + xx) * b / below};
}

}  // namespace

Point OwnBall::lower() const { return frame().lower(size_.radius, -size_.radius); }
Point OwnBall::upper() const { return frame().global(size_.radius, size_.radius, size_.radius); }

bool OwnBall::contains(const Point& p, double tolerance) const {
  const auto [a, b, along] = frame().local(p);
  if (!(std::hypot(a, b, along) <= size_.radius + tolerance)) return false;
  return frame().in_part(a, b, tolerance);
}

std::vector<std::string> OwnBall::sides() const {
  std::vector<std::string> all = Shape::sides();
  all.push_back("outer");
  return all;
}

bool OwnBall::on_side(const std::string& side, const Point& p, double tolerance) const {
  const auto [a, b, along] = frame().local(p);
  if (side == "outer") return std::abs(std::hypot(a, b, along) - size_.radius) <= tolerance;
  return Shape::on_side(side, p, tolerance);
}

double OwnBall::measure() const {
  return pi * size_.radius * size_.radius * size_.radius * frame().quarters() / 3;
}

/// Half a ball: 3/8 R from the plane; a quarter: the same along both axes.
Point OwnBall::centroid() const {
  const double beyond = 0.375 * size_.radius;
  return frame().beyond(beyond, 0);
}

std::string OwnBall::describe() const {
  return fmt::format("{}ball of radius {:g} mm", frame().adjective(), 1e3 * size_.radius) +
         (size_.finer > 1 ? fmt::format(", {:g} times finer at {}-", size_.finer, "xyz"[size_.axis]) : "");
}

CellMesh OwnBall::mesh(const std::array<int, 3>& divisions) const {
  for (const int n : divisions)
    if (n < 1)
      throw std::runtime_error(fmt::format("the {} needs at least one cell along each axis", describe()));
  const double size = 2.0 / divisions[size_.axis];  // of a unit ball's cells
  const auto count = [&](double length) { return std::max(1, int(std::lround(length / size))); };
  const int n = count(0.65), m = count(0.42);
  HexBlocks blocks(size);
  for (int q = 0; q < frame().quarters(); ++q)
    for (const double z : {-1.0, 1.0}) {
      const double x = q == 0 || q == 3 ? 1 : -1, y = q < 2 ? 1 : -1;
      const bool mirrored = x * y * z < 0;
      const auto placed = [&](const Point& p) { return Point{x * p[0], y * p[1], z * p[2]}; };
      blocks.block(
          {n, n, n}, mirrored, [&](double r, double s, double t) { return placed(core_block(r, s, t)); });
      for (int c = 0; c < 3; ++c)  // the block outside of each face, by rotating the axes
        blocks.block({m, n, n}, mirrored, [&](double r, double s, double t) {
          const Point p = outer_block(r, s, t);
          return placed({p[(3 - c) % 3], p[(4 - c) % 3], p[(5 - c) % 3]});
        });
    }
  CellMesh mesh = blocks.mesh();
  for (Point& p : mesh.vertices) {
    const Point at = moebius_map(p, size_.finer);
    p = frame().global(size_.radius * at[0], size_.radius * at[1], size_.radius * at[2]);
  }
  return mesh;
}

namespace {

ShapePointer read_own_ball(Fields& body, int dim, const std::filesystem::path&) {
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto radius = body.quantity("radius", Need::required, dimension::length, Sign::positive);
  const auto axis = read_axis(body, Need::optional);
  const auto part = read_part(body);
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
  return std::make_shared<OwnBall>(OwnBall::Size{
      *centre, *radius, axis.value_or(2), part.value_or(RoundPart::whole), finer.value_or(1.0)});
}

}  // namespace

ShapeEntry ball_entry() {
  return {{"ball",
           "a ball, or half or a quarter of one, that is cut into cells for both solvers",
           {centre_key("The centre."),
            radius_key(),
            axis_key("The direction of the axis through its poles. \"z\" unless given.", false),
            part_key(),
            {"finer", key_holds::number,
             "How many times smaller the cells are at the pole with the lowest coordinate along the axis, 1 "
             "to 20; at the opposite pole they are as many times larger. 1 unless given."}}},
          read_own_ball};
}

}  // namespace femsph
