// Impact of a bar with linear hardening on a rigid wall: the bar moves along -x, and its end x- is held.
// Stress and strain behind the plastic front, by the theory of one-dimensional elastic-plastic waves of
// von Karman and Duwez (J. Appl. Phys. 21, 1950).

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "compare/reference/values/loaded_box.hpp"

namespace femsph::compare {
namespace {

struct Impact {
  double speed;                  ///< V, m/s; > 0 towards the held end
  double young, density, yield;  ///< Pa, kg/m^3, Pa
  double tangent;                ///< Et = E H/(E + H), Pa
  double stress() const;         ///< rho c V below V_y = yield/(rho c), else yield + rho c_p (V - V_y), with
                                 ///< c_p = sqrt(Et/rho); Pa, > 0
  double strain() const;         ///< V/c below V_y, else yield/E + (V - V_y)/c_p; > 0
};

double Impact::stress() const {
  const double c = std::sqrt(young / density), limit = yield / (density * c);
  return speed < limit ? density * c * speed : yield + std::sqrt(tangent * density) * (speed - limit);
}

double Impact::strain() const {
  const double c = std::sqrt(young / density), limit = yield / (density * c);
  return speed < limit ? speed / c : yield / young + (speed - limit) / std::sqrt(tangent / density);
}

/// Throws std::runtime_error with one sentence if the scene is not of that kind.
Impact impact_of(const Scene& scene) {
  const auto refuse_impact = [](const std::string& why) {
    throw std::runtime_error(
        "impact theory needs one box with linear hardening that moves along -x and is held on x-, in plane "
        "stress or in three dimensions, but " +
        why);
  };
  if (const std::string why = not_one_box(scene, true); !why.empty()) refuse_impact(why);
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.plasticity()) refuse_impact("its material is " + m.entry().name);
  if (m.plasticity()->johnson_cook) refuse_impact("its material hardens by Johnson-Cook, not linearly");
  if (scene.plane == Plane::strain)
    refuse_impact("this scene is in plane strain, in which a bar cannot widen");
  if (!scene.loads.empty()) refuse_impact("this scene has loads");
  if (scene.damping || scene.settling) refuse_impact("this scene has damping");
  if (scene.initial_velocities.size() != 1)
    refuse_impact(fmt::format("this scene has {} initial velocities", scene.initial_velocities.size()));
  const InitialVelocity& start = scene.initial_velocities[0];
  if (start.spin != Point{} || start.gradient != Matrix{} || start.profile || start.velocity[1] != 0 ||
      start.velocity[2] != 0 || !(start.velocity[0] < 0))
    refuse_impact("its initial velocity is not along -x and the same everywhere");
  bool held = false;
  for (const Support& support : scene.supports) {
    if (!names_side(support.place, "x-")) refuse_impact("a support is not on x-");
    if (support.velocity != Point{}) refuse_impact("a support moves");
    held |= support.fixed[0] && !support.mean && !support.place.within && support.place.sides.size() == 1;
  }
  if (!held) refuse_impact("the face x- is not held along x");
  const double H = m.plasticity()->hardening;
  return {-start.velocity[0], m.young, m.density, m.plasticity()->yield, m.young * H / (m.young + H)};
}

}  // namespace

std::vector<Theory> impact_values() {
  using Depends = Theory::Depends;
  return {
      {"impact_stress", "Pa", "yield + rho c_p (V - V_y), behind the plastic front (compression: below 0)",
       Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return -impact_of(scene).stress(); }},
      {"impact_strain", "1", "yield/E + (V - V_y)/c_p, behind the plastic front (compression: below 0)",
       Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return -impact_of(scene).strain(); }},
  };
}

}  // namespace femsph::compare
