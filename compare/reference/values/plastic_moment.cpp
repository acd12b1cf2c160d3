// The fully plastic moment of a rectangular section, sigma_y b h^2/4.

#include <stdexcept>

#include "compare/reference/values/loaded_box.hpp"

namespace femsph::compare {
namespace {

double plastic_moment(const Scene& scene) {
  const auto refuse_moment = [](const std::string& why) {
    throw std::runtime_error(
        "plastic moment theory needs one box without hardening, in plane stress or in three dimensions, "
        "but " +
        why);
  };
  if (const std::string why = not_one_box(scene, false); !why.empty()) refuse_moment(why);
  const Body& body = scene.bodies[0];
  const Material& m = scene.material_of(body);
  if (!m.plasticity()) refuse_moment("its material is elastic");
  if (m.plasticity()->johnson_cook) refuse_moment("its material hardens by Johnson-Cook");
  if (m.plasticity()->hardening != 0) refuse_moment("its material hardens");
  if (scene.plane == Plane::strain) refuse_moment("this scene is in plane strain");
  const Point a = body.shape->lower(), b = body.shape->upper();
  return m.plasticity()->yield * (scene.dim() == 2 ? body.thickness : b[2] - a[2]) * (b[1] - a[1]) *
         (b[1] - a[1]) / 4;
}

}  // namespace

std::vector<Theory> plastic_moment_values() {
  using Depends = Theory::Depends;
  return {
      {"plastic_moment", "N m", "sigma_y b h^2/4: the whole section yields", Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return plastic_moment(scene); }},
  };
}

}  // namespace femsph::compare
