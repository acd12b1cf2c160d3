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

std::optional<CellMesh> Shape::cut(const std::array<int, 3>&) const { return {}; }

}  // namespace femsph
