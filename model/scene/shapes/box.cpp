#include "model/scene/shapes/box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/input/toml_fields.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

Point Box::upper() const { return {origin_[0] + size_[0], origin_[1] + size_[1], origin_[2] + size_[2]}; }

bool Box::contains(const Point& p, double tolerance) const {
  const Point top = upper();
  for (int i = 0; i < dim_; ++i)
    if (!(p[i] >= origin_[i] - tolerance && p[i] <= top[i] + tolerance)) return false;
  return true;
}

double Box::measure() const { return size_[0] * size_[1] * (dim_ == 3 ? size_[2] : 1.0); }

Point Box::centroid() const {
  return {origin_[0] + 0.5 * size_[0], origin_[1] + 0.5 * size_[1], origin_[2] + 0.5 * size_[2]};
}

std::string Box::describe() const {
  std::string text = "box";
  for (int i = 0; i < dim_; ++i) text += fmt::format("{}{:g}", i ? " x " : " ", 1e3 * size_[i]);
  return text + " mm";
}

Point Box::inertia(double mass) const {
  const Point s = upper() - lower();
  Point inertia{};
  for (int a = 0; a < 3; ++a) inertia[a] = mass / 12 * (dot(s, s) - s[a] * s[a]);
  return inertia;
}

double Box::surface() const {
  const Point s = upper() - lower();
  return dim_ == 2 ? 2 * (s[0] + s[1]) : 2 * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]);
}

/// The sides are numbered in the order x-, x+, y-, ..
SideProjection Box::project(int side, const Point& from, const std::array<Point, 3>& axes) const {
  SideProjection s;
  const Point half = 0.5 * (upper() - lower());
  const int a = side / 2;
  const double sign = side % 2 ? 1 : -1;
  s.normal = sign * axes[a];
  s.gap = dot(s.normal, from) - half[a];
  for (int b = 0; b < dim_; ++b)
    if (b != a) s.beyond = std::max(s.beyond, std::abs(dot(axes[b], from)) - half[b]);
  return s;
}

namespace {

ShapePointer read_box(Fields& body, int dim, const std::filesystem::path&) {
  const auto size = body.vector("size", Need::required, dimension::length, dim, Sign::positive);
  const auto origin = body.vector("origin", Need::optional, dimension::length, dim);
  return size && dim ? std::make_shared<Box>(dim, origin.value_or(Point{}), *size) : nullptr;
}

}  // namespace

ShapeEntry box_entry() {
  return {{"box",
           "a rectangle or cuboid with sides parallel to the axes",
           {{"size", key_holds::vector(dimension::length), "The lengths of its sides along the axes.", true},
            {"origin", key_holds::vector(dimension::length),
             "Its corner with the lowest coordinates. The origin unless given."}}},
          read_box};
}

}  // namespace femsph
