#include "model/scene/shapes/disc.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/input/toml_fields.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/round.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

Point Ball::lower() const {
  return {centre_[0] - radius_, centre_[1] - radius_, dim_ == 3 ? centre_[2] - radius_ : 0.0};
}
Point Ball::upper() const {
  return {centre_[0] + radius_, centre_[1] + radius_, dim_ == 3 ? centre_[2] + radius_ : 0.0};
}

bool Ball::contains(const Point& p, double tolerance) const {
  return std::hypot(p[0] - centre_[0], p[1] - centre_[1], dim_ == 3 ? p[2] - centre_[2] : 0.0) <=
         radius_ + tolerance;
}

double Ball::measure() const {
  const double disc = std::acos(-1.0) * radius_ * radius_;
  return dim_ == 3 ? 4.0 / 3.0 * disc * radius_ : disc;
}

Point Ball::centroid() const { return centre_; }

std::string Ball::describe() const {
  return fmt::format("{} of radius {:g} mm", dim_ == 3 ? "sphere" : "disc", 1e3 * radius_);
}

std::optional<CellMesh> Ball::cut(const std::array<int, 3>& divisions) const {
  if (dim_ == 3) return {};
  return Round(2, {centre_, 0, radius_}).mesh(divisions);
}

Point Ball::inertia(double mass) const {
  Point inertia;
  inertia.fill((dim_ == 2 ? 0.5 : 0.4) * mass * radius_ * radius_);
  return inertia;
}

double Ball::surface() const {
  const double pi = std::acos(-1.0);
  return dim_ == 2 ? 2 * pi * radius_ : 4 * pi * radius_ * radius_;
}

SideProjection Ball::project(int, const Point& from, const std::array<Point, 3>&) const {
  SideProjection s;
  const double r = norm(from);
  s.normal = r > 0 ? (1 / r) * from : Point{0, 1, 0};
  s.gap = r - radius_;
  return s;
}

double Ball::depth(const Point& p) const { return radius_ - norm(p - centre_); }

namespace {

template <int ball_dim>
ShapePointer read_ball(Fields& body, int dim, const std::filesystem::path&) {
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto radius = body.quantity("radius", Need::required, dimension::length, Sign::positive);
  if (dim && dim != ball_dim)
    return body.fault("shape", ball_dim == 2 ? "a disc in a three-dimensional scene; expected \"sphere\""
                                             : "a sphere in a plane scene; expected \"disc\""),
           nullptr;
  return centre && radius && dim ? std::make_shared<Ball>(dim, *centre, *radius) : nullptr;
}

std::vector<Key> disc_keys() { return {centre_key("The centre."), radius_key()}; }

}  // namespace

ShapeEntry disc_entry() {
  return {{"disc", "a plane disc; SPH fills it with a lattice of particles", disc_keys()}, read_ball<2>};
}

ShapeEntry sphere_entry() {
  return {{"sphere", "a ball without cells: for SPH, and for rigid bodies", disc_keys()}, read_ball<3>};
}

}  // namespace femsph
