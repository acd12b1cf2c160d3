// How fast numbers at singular places diverge (singular.hpp).

#include <cmath>
#include <numbers>

#include "model/scene/place_extent.hpp"
#include "model/scene/singular.hpp"

namespace femsph {

double clamped_corner_exponent(double poisson, Plane plane) {
  const double nu = plane == Plane::stress ? poisson / (1 + poisson) : poisson;
  const auto left_over = [&](double l) {
    return std::pow(std::sin(l * std::numbers::pi / 2), 2) - (4 * (1 - nu) * (1 - nu) - l * l) / (3 - 4 * nu);
  };
  double low = 0.3, high = 1;
  if (left_over(high) <= 0 || left_over(low) >= 0) return 1;
  for (int turn = 0; turn < 60; ++turn) {
    const double middle = (low + high) / 2;
    (left_over(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

double sinks_per_halving(const Scene& scene, const Place& place) {
  const Body& body = scene.bodies[place.body];
  const Shape& box = *body.shape;
  if (!box.is_box() || scene.dim() != 2 || body.rigid) return 0;
  const Material& m = scene.material_of(body);
  if (!m.is_linear_elastic()) return 0;
  const double stiffness = (scene.plane == Plane::strain ? m.young / (1 - m.poisson * m.poisson) : m.young) *
                           body.thickness;
  const Region part = place.point ? Region{*place.point, *place.point} : part_of(box, place);
  int borders = 0;
  for (int c = 0; c < 2; ++c)
    borders += part.upper[c] - box.lower()[c] <= point_tolerance(box) ||
               box.upper()[c] - part.lower[c] <= point_tolerance(box);
  constexpr double pi = std::numbers::pi;
  return borders == 0
             ? 0
             : (borders == 1 ? 2 / pi : 1 / (pi / 2 + 1) + 1 / (pi / 2 - 1)) * std::numbers::ln2 / stiffness;
}

}  // namespace femsph
