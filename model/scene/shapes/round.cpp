#include "model/scene/shapes/round.hpp"

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

/// Plane cells, block by block; blocks that meet share their vertices.
class QuadBlocks {
 public:
  explicit QuadBlocks(double size) : vertices_(size) {}

  /// n x m cells; at(s, t) is the place of a vertex for s, t from 0 to 1. Blocks may be mirrored.
  void block(int n, int m, const std::function<std::array<double, 2>(double, double)>& at) {
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<int, 4> cell;
        for (int c = 0; c < 4; ++c) {
          const auto [x, y] = at(double(i + c % 2) / n, double(j + c / 2) / m);
          cell[c] = vertices_.number({x, y, 0});
        }
        const Point &a = vertices()[cell[0]], &b = vertices()[cell[1]], &c = vertices()[cell[2]],
                    &d = vertices()[cell[3]];
        if ((d[0] - a[0]) * (c[1] - b[1]) - (d[1] - a[1]) * (c[0] - b[0]) < 0)
          std::swap(cell[0], cell[1]), std::swap(cell[2], cell[3]);  // of a mirrored block
        cells.push_back(cell);
      }
  }
  const std::vector<Point>& vertices() const { return vertices_.points(); }
  std::vector<std::array<int, 4>> cells;

 private:
  MergedPoints vertices_;
};

int count_of(double length, double size) { return std::max(1, int(std::lround(length / size))); }

/// A quarter of a ring, from the angle `start` (rad): layers across the wall, sectors around.
void ring_quarter(QuadBlocks& blocks, double inner, double outer, int layers, int sectors, double start) {
  blocks.block(layers, sectors, [&](double s, double t) {
    const double r = inner + s * (outer - inner), a = start + 0.5 * pi * t;
    return std::array<double, 2>{r * std::cos(a), r * std::sin(a)};
  });
}

/// A quarter of a disc, from the angle `start` (rad): a block at the centre, square but for its outer corner,
/// and two blocks from it to the circle.
void disc_quarter(QuadBlocks& blocks, double outer, double size, double start) {
  const double side = 0.55 * outer,
               corner = 0.43 * outer;  // of the block at the centre: along the axes, and at its outer corner
  const int n = count_of(0.65 * outer, size), m = count_of(0.42 * outer, size);
  const double c = std::cos(start), s = std::sin(start);
  const auto turned = [&](double x, double y) { return std::array<double, 2>{c * x - s * y, s * x + c * y}; };
  blocks.block(n, n, [&](double x, double y) {
    return turned(x * ((1 - y) * side + y * corner), y * ((1 - x) * side + x * corner));
  });
  for (const bool second : {false, true})
    blocks.block(m, n, [&](double out, double t) {
      const double angle = 0.25 * pi * t,
                   x = (1 - out) * ((1 - t) * side + t * corner) + out * outer * std::cos(angle);
      const double y = (1 - out) * t * corner + out * outer * std::sin(angle);
      return second ? turned(y, x) : turned(x, y);
    });
}

}  // namespace

Point Round::lower() const { return frame().lower(size_.outer, 0); }
Point Round::upper() const { return frame().global(size_.outer, size_.outer, size_.length); }

bool Round::contains(const Point& p, double tolerance) const {
  const auto [a, b, along] = frame().local(p);
  const double r = std::hypot(a, b);
  if (!(r <= size_.outer + tolerance && r >= size_.inner - tolerance)) return false;
  if (dim_ == 3 && !(along >= -tolerance && along <= size_.length + tolerance)) return false;
  return frame().in_part(a, b, tolerance);
}

std::vector<std::string> Round::sides() const {
  std::vector<std::string> all = Shape::sides();
  all.push_back("outer");
  if (size_.inner > 0) all.push_back("inner");
  return all;
}

bool Round::on_side(const std::string& side, const Point& p, double tolerance) const {
  const auto [a, b, along] = frame().local(p);
  if (side == "outer") return std::abs(std::hypot(a, b) - size_.outer) <= tolerance;
  if (side == "inner" && size_.inner > 0) return std::abs(std::hypot(a, b) - size_.inner) <= tolerance;
  return Shape::on_side(side, p, tolerance);
}

double Round::measure() const {
  return 0.25 * frame().quarters() * pi * (size_.outer * size_.outer - size_.inner * size_.inner) *
         (dim_ == 3 ? size_.length : 1.0);
}

/// Half a ring: 4 (R^3 - r^3) / (3 pi (R^2 - r^2)) from the centre; a quarter: the same along both axes.
Point Round::centroid() const {
  const double R = size_.outer, r = size_.inner, beyond = 4 * (R * R + R * r + r * r) / (3 * pi * (R + r));
  return frame().beyond(beyond, dim_ == 3 ? 0.5 * size_.length : 0.0);
}

/// Pieces of the circles; of a cylinder or tube pieces of its lateral surfaces.
std::vector<SidePiece> Round::side_pieces(const std::string& side, double size) const {
  if (side != "outer" && !(side == "inner" && size_.inner > 0)) return {};
  const double radius = side == "outer" ? size_.outer : size_.inner, out = side == "outer" ? 1 : -1,
               turn = 0.5 * pi * frame().quarters();
  const int n = std::max(4, int(std::ceil(radius * turn / size))),
            m = dim_ == 3 ? std::max(1, int(std::ceil(size_.length / size))) : 1;
  std::vector<SidePiece> pieces;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const double angle = turn * (i + 0.5) / n,
                   area = radius * turn / n * (dim_ == 3 ? size_.length / m : 1.0);
      SidePiece piece{frame().global(radius * std::cos(angle), radius * std::sin(angle),
                                     dim_ == 3 ? size_.length * (j + 0.5) / m : 0.0),
                      area,
                      {}};
      const double across = area * std::sin(0.5 * turn / n) /
                            (0.5 * turn / n);  // integral of the normal over the piece of an arc: its chord
      piece.area[frame().first()] = out * across * std::cos(angle);
      piece.area[frame().second()] = out * across * std::sin(angle);
      pieces.push_back(piece);
    }
  return pieces;
}

std::string Round::describe() const {
  const char* kind = dim_ == 2 ? (size_.inner > 0 ? "ring" : "disc")
                               : (size_.inner > 0 ? "tube" : "cylinder");
  std::string text = fmt::format("{}{} of ", frame().adjective(), kind);
  text += size_.inner > 0 ? fmt::format("radii {:g} and {:g} mm", 1e3 * size_.inner, 1e3 * size_.outer)
                          : fmt::format("radius {:g} mm", 1e3 * size_.outer);
  return dim_ == 3 ? text + fmt::format(", {:g} mm long", 1e3 * size_.length) : text;
}

CellMesh Round::mesh(const std::array<int, 3>& divisions) const {
  const Point low = lower(), high = upper();
  for (int d = 0; d < dim_; ++d)
    if (divisions[d] < 1)
      throw std::runtime_error(fmt::format("the {} needs at least one cell along each axis", describe()));
  const double size = (high[frame().first()] - low[frame().first()]) / divisions[frame().first()];
  QuadBlocks blocks(size);
  const int layers = count_of(size_.outer - size_.inner, size),
            sectors = std::max(2, count_of(0.25 * pi * (size_.outer + size_.inner), size));
  for (int q = 0; q < frame().quarters(); ++q) {
    if (size_.inner > 0)
      ring_quarter(blocks, size_.inner, size_.outer, layers, sectors, 0.5 * pi * q);
    else
      disc_quarter(blocks, size_.outer, size, 0.5 * pi * q);
  }
  CellMesh mesh;
  mesh.dim = dim_;
  const int levels = dim_ == 3 ? divisions[size_.axis] : 0, n = int(blocks.vertices().size());
  for (int k = 0; k <= levels; ++k)
    for (const auto& v : blocks.vertices())
      mesh.vertices.push_back(frame().global(v[0], v[1], levels ? size_.length * k / levels : 0.0));
  for (int k = 0; k < std::max(1, levels); ++k)
    for (const auto& flat : blocks.cells) {
      std::array<int, 8> cell{};
      for (int c = 0; c < (levels ? 8 : 4); ++c) cell[c] = flat[c % 4] + n * (k + c / 4);
      mesh.cells.push_back(cell);
    }
  return mesh;
}

namespace {

/// Hollow shapes have two radii, solid ones one; shapes in space have an axis and a length.
template <int round_dim, bool hollow>
ShapePointer read_round(Fields& body, int dim, const std::filesystem::path&) {
  Round::Size size;
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto outer = body.quantity(
      hollow ? "outer" : "radius", Need::required, dimension::length, Sign::positive);
  const auto inner = hollow ? body.quantity("inner", Need::required, dimension::length, Sign::positive)
                            : std::optional<double>(0.0);
  const auto part = read_part(body);
  std::optional<double> length(0.0);
  if (round_dim == 3) {
    const auto axis = read_axis(body, Need::required);
    length = body.quantity("length", Need::required, dimension::length, Sign::positive);
    if (!axis) return nullptr;
    size.axis = *axis;
  }
  if (dim && dim != round_dim)
    return body.fault("shape", round_dim == 2
                                   ? "a ring in a three-dimensional scene; expected \"tube\""
                                   : "a cylinder or tube in a plane scene; expected \"disc\" or \"ring\""),
           nullptr;
  if (hollow && inner && outer && *inner >= *outer)
    return body.fault(
               "inner",
               fmt::format("\"inner\" is {:g} mm, not below \"outer\", {:g} mm; expected the smaller radius",
                           *inner * 1e3, *outer * 1e3)),
           nullptr;
  if (!centre || !outer || !inner || !length || !dim) return nullptr;
  size.centre = *centre, size.outer = *outer, size.inner = *inner, size.length = *length,
  size.part = part.value_or(RoundPart::whole);
  return std::make_shared<Round>(dim, size);
}

std::vector<Key> round_keys(int dim, bool hollow) {
  const std::string length = key_holds::quantity(dimension::length);
  std::vector<Key> keys = {
      centre_key(dim == 2 ? "The centre of the circle."
                          : "The centre of the end circle with the lowest coordinate along the axis.")};
  if (hollow) {
    keys.push_back({"outer", length, "The outer radius.", true});
    keys.push_back({"inner", length, "The inner radius.", true});
  } else {
    keys.push_back(radius_key());
  }
  keys.push_back(part_key());
  if (dim == 3) {
    keys.push_back(axis_key("The direction of the axis.", true));
    keys.push_back({"length", length, "The length along the axis.", true});
  }
  return keys;
}

}  // namespace

ShapeEntry ring_entry() {
  return {{"ring", "a plane ring, or half or a quarter of one", round_keys(2, true)}, read_round<2, true>};
}

ShapeEntry cylinder_entry() {
  return {{"cylinder", "a solid circular cylinder, or half or a quarter of one", round_keys(3, false)},
          read_round<3, false>};
}

ShapeEntry tube_entry() {
  return {{"tube", "a hollow circular cylinder, or half or a quarter of one", round_keys(3, true)},
          read_round<3, true>};
}

}  // namespace femsph
