#include "model/scene/shapes/round.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

namespace {

using std::numbers::pi;

/// Plane cells as they are laid, their common vertices found again by place.
class Sheet {
 public:
  explicit Sheet(double size) : grid_(1e-6 * size) {}

  /// n x m cells: at(s, t) for s, t from 0 to 1.
  void block(int n, int m, const std::function<std::array<double, 2>(double, double)>& at) {
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<int, 4> cell;
        for (int c = 0; c < 4; ++c) cell[c] = vertex(at(double(i + c % 2) / n, double(j + c / 2) / m));
        const auto &a = vertices[cell[0]], &b = vertices[cell[1]], &c = vertices[cell[2]],
                   &d = vertices[cell[3]];
        if ((d[0] - a[0]) * (c[1] - b[1]) - (d[1] - a[1]) * (c[0] - b[0]) < 0)
          std::swap(cell[0], cell[1]), std::swap(cell[2], cell[3]);  // of a mirrored block
        cells.push_back(cell);
      }
  }
  std::vector<std::array<double, 2>> vertices;
  std::vector<std::array<int, 4>> cells;

 private:
  int vertex(const std::array<double, 2>& p) {
    const auto near = [&](double x) { return std::lround(x / grid_); };
    for (const long i : {0, -1, 1})
      for (const long j : {0, -1, 1})
        if (const auto known = at_.find({near(p[0]) + i, near(p[1]) + j}); known != at_.end())
          return known->second;
    vertices.push_back(p);
    return at_[{near(p[0]), near(p[1])}] = int(vertices.size()) - 1;
  }
  double grid_;
  std::map<std::pair<long, long>, int> at_;
};

int count_of(double length, double size) { return std::max(1, int(std::lround(length / size))); }

/// n sectors around a quarter turn, from the angle `start`.
void ring_quarter(Sheet& sheet, double inner, double outer, int layers, int sectors, double start) {
  sheet.block(layers, sectors, [&](double s, double t) {
    const double r = inner + s * (outer - inner), a = start + 0.5 * pi * t;
    return std::array<double, 2>{r * std::cos(a), r * std::sin(a)};
  });
}

/// A square with a drawn-out corner, and two blocks from it to the rim; turned by `start`.
void disc_quarter(Sheet& sheet, double outer, double size, double start) {
  const double side = 0.55 * outer,
               corner = 0.43 * outer;  // of the square: along the axes, and of its free corner
  const int n = count_of(0.65 * outer, size), m = count_of(0.42 * outer, size);
  const double c = std::cos(start), s = std::sin(start);
  const auto turned = [&](double x, double y) { return std::array<double, 2>{c * x - s * y, s * x + c * y}; };
  sheet.block(n, n, [&](double x, double y) {
    return turned(x * ((1 - y) * side + y * corner), y * ((1 - x) * side + x * corner));
  });
  for (const bool second : {false, true})
    sheet.block(m, n, [&](double out, double t) {
      const double angle = 0.25 * pi * t,
                   x = (1 - out) * ((1 - t) * side + t * corner) + out * outer * std::cos(angle);
      const double y = (1 - out) * t * corner + out * outer * std::sin(angle);
      return second ? turned(y, x) : turned(x, y);
    });
}

}  // namespace

std::array<double, 3> Round::section(const Point& p) const {
  return {p[first()] - size_.centre[first()], p[second()] - size_.centre[second()],
          dim_ == 3 ? p[size_.axis] - size_.centre[size_.axis] : 0.0};
}

Point Round::place(double a, double b, double along) const {
  Point p = size_.centre;
  p[first()] += a;
  p[second()] += b;
  if (dim_ == 3) p[size_.axis] += along;
  return p;
}

Point Round::lower() const {
  return place(
      size_.part == Part::quarter ? 0 : -size_.outer, size_.part == Part::whole ? -size_.outer : 0, 0);
}
Point Round::upper() const { return place(size_.outer, size_.outer, size_.length); }

bool Round::contains(const Point& p, double tolerance) const {
  const auto [a, b, along] = section(p);
  const double r = std::hypot(a, b);
  if (!(r <= size_.outer + tolerance && r >= size_.inner - tolerance)) return false;
  if (dim_ == 3 && !(along >= -tolerance && along <= size_.length + tolerance)) return false;
  return (size_.part == Part::whole || b >= -tolerance) && (size_.part != Part::quarter || a >= -tolerance);
}

std::vector<std::string> Round::sides() const {
  std::vector<std::string> all = Shape::sides();
  all.push_back("outer");
  if (size_.inner > 0) all.push_back("inner");
  return all;
}

bool Round::on_side(const std::string& side, const Point& p, double tolerance) const {
  const auto [a, b, along] = section(p);
  if (side == "outer") return std::abs(std::hypot(a, b) - size_.outer) <= tolerance;
  if (side == "inner" && size_.inner > 0) return std::abs(std::hypot(a, b) - size_.inner) <= tolerance;
  return Shape::on_side(side, p, tolerance);
}

double Round::measure() const {
  return 0.25 * quarters() * pi * (size_.outer * size_.outer - size_.inner * size_.inner) *
         (dim_ == 3 ? size_.length : 1.0);
}

/// Of a half ring 4 (R^3 - r^3) / (3 pi (R^2 - r^2)) beyond the centre; of a quarter along both axes.
Point Round::centroid() const {
  const double R = size_.outer, r = size_.inner, beyond = 4 * (R * R + R * r + r * r) / (3 * pi * (R + r));
  return place(size_.part == Part::quarter ? beyond : 0, size_.part == Part::whole ? 0 : beyond,
               dim_ == 3 ? 0.5 * size_.length : 0.0);
}

/// The rims; of a cylinder or tube their mantles.
std::vector<SidePiece> Round::side_pieces(const std::string& side, double size) const {
  if (side != "outer" && !(side == "inner" && size_.inner > 0)) return {};
  const double radius = side == "outer" ? size_.outer : size_.inner, out = side == "outer" ? 1 : -1,
               turn = 0.5 * pi * quarters();
  const int n = std::max(4, int(std::ceil(radius * turn / size))),
            m = dim_ == 3 ? std::max(1, int(std::ceil(size_.length / size))) : 1;
  std::vector<SidePiece> pieces;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const double angle = turn * (i + 0.5) / n,
                   area = radius * turn / n * (dim_ == 3 ? size_.length / m : 1.0);
      SidePiece piece{place(radius * std::cos(angle), radius * std::sin(angle),
                            dim_ == 3 ? size_.length * (j + 0.5) / m : 0.0),
                      area,
                      {}};
      const double across = area * std::sin(0.5 * turn / n) /
                            (0.5 * turn / n);  // integral of the normal over the piece of an arc: its chord
      piece.area[first()] = out * across * std::cos(angle);
      piece.area[second()] = out * across * std::sin(angle);
      pieces.push_back(piece);
    }
  return pieces;
}

std::string Round::describe() const {
  const char* part = size_.part == Part::whole ? "" : size_.part == Part::half ? "half " : "quarter ";
  const char* kind = dim_ == 2 ? (size_.inner > 0 ? "ring" : "disc")
                               : (size_.inner > 0 ? "tube" : "cylinder");
  std::string text = fmt::format("{}{} of ", part, kind);
  text += size_.inner > 0 ? fmt::format("radii {:g} and {:g} mm", 1e3 * size_.inner, 1e3 * size_.outer)
                          : fmt::format("radius {:g} mm", 1e3 * size_.outer);
  return dim_ == 3 ? text + fmt::format(", {:g} mm long", 1e3 * size_.length) : text;
}

CellMesh Round::mesh(const std::array<int, 3>& divisions) const {
  const Point low = lower(), high = upper();
  for (int d = 0; d < dim_; ++d)
    if (divisions[d] < 1)
      throw std::runtime_error(fmt::format("the {} needs at least one cell along each axis", describe()));
  const double size = (high[first()] - low[first()]) / divisions[first()];
  Sheet sheet(size);
  const int layers = count_of(size_.outer - size_.inner, size),
            sectors = std::max(2, count_of(0.25 * pi * (size_.outer + size_.inner), size));
  for (int q = 0; q < quarters(); ++q) {
    if (size_.inner > 0)
      ring_quarter(sheet, size_.inner, size_.outer, layers, sectors, 0.5 * pi * q);
    else
      disc_quarter(sheet, size_.outer, size, 0.5 * pi * q);
  }
  CellMesh mesh;
  mesh.dim = dim_;
  const int levels = dim_ == 3 ? divisions[size_.axis] : 0, n = int(sheet.vertices.size());
  for (int k = 0; k <= levels; ++k)
    for (const auto& v : sheet.vertices)
      mesh.vertices.push_back(place(v[0], v[1], levels ? size_.length * k / levels : 0.0));
  for (int k = 0; k < std::max(1, levels); ++k)
    for (const auto& flat : sheet.cells) {
      std::array<int, 8> cell{};
      for (int c = 0; c < (levels ? 8 : 4); ++c) cell[c] = flat[c % 4] + n * (k + c / 4);
      mesh.cells.push_back(cell);
    }
  return mesh;
}

namespace {

/// Keys of a circular section; `hollow` ones have two radii, in space they have an axis and a length.
template <int round_dim, bool hollow>
ShapePointer read_round(Fields& body, int dim, const std::filesystem::path&) {
  using Part = Round::Part;
  Round::Size size;
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto outer = body.quantity(
      hollow ? "outer" : "radius", Need::required, dimension::length, Sign::positive);
  const auto inner = hollow ? body.quantity("inner", Need::required, dimension::length, Sign::positive)
                            : std::optional<double>(0.0);
  const auto part = body.choice<Part>(
      "part", Need::optional, {{"whole", Part::whole}, {"half", Part::half}, {"quarter", Part::quarter}});
  std::optional<double> length(0.0);
  if (round_dim == 3) {
    const auto axis = body.choice<int>("axis", Need::required, {{"x", 0}, {"y", 1}, {"z", 2}});
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
  size.part = part.value_or(Part::whole);
  return std::make_shared<Round>(dim, size);
}

std::vector<Key> round_keys(int dim, bool hollow) {
  std::vector<Key> keys = {{"centre", key_holds::vector(dimension::length),
                            dim == 2 ? "of the section" : "of the section where the axis begins", true}};
  keys.push_back({hollow ? "outer" : "radius", "a length", hollow ? "outer radius" : "its radius", true});
  if (hollow) keys.push_back({"inner", "a length", "inner radius", true});
  keys.push_back({"part", key_holds::words(std::vector<std::string>{"whole", "half", "quarter"}),
                  "half: where the section's second axis is positive; quarter: where both are"});
  if (dim == 3) {
    keys.push_back(
        {"axis", key_holds::words(std::vector<std::string>{"x", "y", "z"}), "along which it runs", true});
    keys.push_back({"length", "a length", "along the axis", true});
  }
  return keys;
}

}  // namespace

ShapeEntry ring_entry() {
  return {{"ring", "a hollow disc in a plane, whole or cut", round_keys(2, true)}, read_round<2, true>};
}

ShapeEntry cylinder_entry() {
  return {{"cylinder", "in space, whole or cut", round_keys(3, false)}, read_round<3, false>};
}

ShapeEntry tube_entry() {
  return {{"tube", "a hollow cylinder, whole or cut", round_keys(3, true)}, read_round<3, true>};
}

}  // namespace femsph
