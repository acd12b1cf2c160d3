#include "model/motion/bodies/mass_properties.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/numerics/vectors.hpp"

namespace femsph {

namespace {

void add(MassProperties& sum, double mass, const Point& at) {
  sum.mass += mass;
  sum.centre = sum.centre + mass * at;
}

}  // namespace

MassProperties mass_of(const Scene& scene, std::size_t body) {
  const Body& b = scene.bodies[body];
  const Point centroid = b.shape->centroid();
  if (b.rigid) return {b.mass, centroid};
  MassProperties sum;
  add(sum, b.shape->measure() * (scene.dim() == 2 ? b.thickness : 1.0) * scene.material_of(b).density,
      centroid);
  for (const Bar& bar : scene.bars)
    if (bar.body == body)
      add(sum, bar.area * norm(bar.to - bar.from) * scene.materials.at(bar.material).density,
          0.5 * (bar.from + bar.to));
  sum.centre = (1 / sum.mass) * sum.centre;
  return sum;
}

MassProperties mass_of(const Discretization& discretization) {
  MassProperties sum;
  for (std::size_t i = 0; i < discretization.layout().points; ++i)
    add(sum, discretization.mass()[i], discretization.position(i));
  sum.centre = (1 / sum.mass) * sum.centre;
  return sum;
}

MassError mass_error(const Scene& scene, std::size_t body, const Discretization& discretization) {
  const MassProperties wanted = mass_of(scene, body), found = mass_of(discretization);
  const Shape& shape = *scene.bodies[body].shape;
  return {
      found.mass / wanted.mass - 1, norm(found.centre - wanted.centre) / norm(shape.upper() - shape.lower())};
}

std::string mass_warning(const Scene& scene, std::size_t body, const Discretization& discretization) {
  constexpr double worth_saying = 0.01;
  const MassError error = mass_error(scene, body, discretization);
  if (std::abs(error.mass) <= worth_saying && error.centre <= worth_saying) return {};
  return fmt::format(
      "body \"{}\": its {}s weigh {}, the body {}: the mass is {:+.2f} % off, the centre of gravity {:.2f} % "
      "of the body's diagonal",
      scene.bodies[body].name, discretization.unit_name(), to_text(mass_of(discretization), scene.dim()),
      to_text(mass_of(scene, body), scene.dim()), 100 * error.mass, 100 * error.centre);
}

std::string to_text(const MassProperties& m, int dim) {
  std::string text = fmt::format("{:.6g} kg, centre (", m.mass);
  for (int c = 0; c < dim; ++c)
    text += fmt::format("{}{:.6g}", c ? ", " : "", std::abs(m.centre[c]) < 1e-12 ? 0.0 : 1e3 * m.centre[c]);
  return text + ") mm";
}

}  // namespace femsph
