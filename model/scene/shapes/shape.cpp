#include "model/scene/shapes/shape.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace femsph {

std::vector<std::string> Shape::sides() const {
  const std::vector<std::string> all = {"x-", "x+", "y-", "y+", "z-", "z+"};
  return {all.begin(), all.begin() + 2 * dim()};
}

bool Shape::on_side(const std::string& side, const Point& p, double tolerance) const {
  const int axis = side.size() == 2 && (side[1] == '-' || side[1] == '+') ? side[0] - 'x' : -1;
  if (axis < 0 || axis >= dim())
    throw std::invalid_argument(fmt::format("no side {} on a {}", side, describe()));
  return std::abs(p[axis] - (side[1] == '-' ? lower() : upper())[axis]) <= tolerance;
}

std::vector<SidePiece> Shape::side_pieces(const std::string&, double) const { return {}; }

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

}  // namespace femsph
