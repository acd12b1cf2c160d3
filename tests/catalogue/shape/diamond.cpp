// A dummy for tests/catalogue: the plane points with |x - a| + |y - b| <= r.

#include <fmt/format.h>

#include <cmath>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {
namespace {

class Diamond final : public Shape {
 public:
  Diamond(const Point& centre, double reach) : centre_(centre), reach_(reach) {}
  int dim() const override { return 2; }
  Point lower() const override { return {centre_[0] - reach_, centre_[1] - reach_, 0}; }
  Point upper() const override { return {centre_[0] + reach_, centre_[1] + reach_, 0}; }
  bool contains(const Point& p, double tolerance) const override {
    return std::abs(p[0] - centre_[0]) + std::abs(p[1] - centre_[1]) <= reach_ + std::sqrt(2.0) * tolerance;
  }
  double measure() const override { return 2 * reach_ * reach_; }
  Point centroid() const override { return centre_; }
  bool touches_sides_in_points() const override { return true; }
  std::string describe() const override { return fmt::format("diamond of reach {:g} mm", 1e3 * reach_); }

 private:
  Point centre_;
  double reach_;
};

ShapePointer read_diamond(Fields& body, int dim, const std::filesystem::path&) {
  const auto centre = body.vector("centre", Need::required, dimension::length, dim);
  const auto reach = body.quantity("reach", Need::required, dimension::length, Sign::positive);
  if (dim == 3)
    return body.fault("shape", "a diamond in a three-dimensional scene; expected a plane one"), nullptr;
  return centre && reach && dim ? std::make_shared<Diamond>(*centre, *reach) : nullptr;
}

}  // namespace

ShapeEntry diamond_entry() {
  return {{"diamond",
           "a square on its corner, in a plane",
           {{"centre", "a list of lengths", "", true},
            {"reach", "a length", "from the centre to a corner", true}}},
          read_diamond};
}

}  // namespace femsph
