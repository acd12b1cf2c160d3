#include "compare/reference/values/loaded_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/scene/shapes/box.hpp"

namespace femsph::compare {
namespace {

bool on_plane(const Place& place, double x, double length) {
  return place.point && std::abs((*place.point)[0] - x) <= 1e-9 * length;
}

/// The middle of a place, m: the point where the resultant of a force that is spread over it acts.
Point middle_of(const Place& place, const Shape& shape) {
  if (place.point) return *place.point;
  Point lower = shape.lower(), upper = shape.upper(), middle;
  for (const std::string& side : place.sides) {
    const int axis = side[0] - 'x';
    (side[1] == '-' ? upper : lower)[axis] = (side[1] == '-' ? lower : upper)[axis];
  }
  for (int c = 0; c < 3; ++c) {
    if (place.within)
      lower[c] = std::max(lower[c], place.within->lower[c]),
      upper[c] = std::min(upper[c], place.within->upper[c]);
    middle[c] = 0.5 * (lower[c] + upper[c]);
  }
  return middle;
}

// The whole face x- must be held along x, and a part of it along y.
void check_supports(const Scene& scene, const LoadedBox& box, const std::string& theory) {
  bool along_x = false, along_y = false;
  for (const Support& support : scene.supports) {
    if (!names_side(support.place, "x-") && !on_plane(support.place, box.origin[0], box.length))
      refuse_theory(theory, "a support is not on x-");
    if (support.velocity != Point{}) refuse_theory(theory, "a support moves");
    along_x |= support.fixed[0] && !support.mean && !support.place.within &&
               support.place.sides == std::vector<std::string>{"x-"};
    along_y |= support.fixed[1];
  }
  if (!along_x) refuse_theory(theory, "the face x- is not held along x");
  if (!along_y) refuse_theory(theory, "nothing holds it along y");
}

/// Adds the moment of a force that acts at `arm` from the middle of x+. A total moment would bend or twist
/// the box, which the theories leave out.
void add_moment(const Point& arm, const Point& force, Point& moment) {
  for (int c = 0; c < 3; ++c) {
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    moment[c] += arm[a] * force[b] - arm[b] * force[a];
  }
}

}  // namespace

void refuse_theory(const std::string& theory, const std::string& why) {
  throw std::runtime_error(fmt::format(
      "{} theory needs one box, held on x- and loaded by forces on x+ alone, but {}", theory, why));
}

bool names_side(const Place& place, const std::string& side) {
  return std::find(place.sides.begin(), place.sides.end(), side) != place.sides.end();
}

std::string not_one_box(const Scene& scene, bool moving) {
  if (scene.bodies.size() != 1) return fmt::format("this scene has {} bodies", scene.bodies.size());
  if (!scene.bodies[0].shape->is_box()) return "this body is not a box";
  if (scene.bodies[0].rigid) return "this body is rigid";
  if (scene.gravity) return "this scene has gravity";
  if (!moving && !scene.initial_velocities.empty()) return "this scene has an initial velocity";
  if (!scene.initial_displacements.empty()) return "this scene has an initial displacement";
  if (!scene.symmetries.empty()) return "this scene has a plane of symmetry";
  if (!scene.bars.empty()) return "this body has reinforcing bars";
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.is_linear_elastic() && !m.plasticity()) return "its material is " + m.entry().name;
  return "";
}

LoadedBox loaded_box(const Scene& scene, const std::string& theory) {
  if (const std::string why = not_one_box(scene, false); !why.empty()) refuse_theory(theory, why);
  const Body& body = scene.bodies[0];
  const Box* shape = body.shape->box();
  const Material& material = scene.material_of(body);
  const double nu = material.poisson;
  LoadedBox box{};
  box.origin = shape->lower();
  box.length = shape->size()[0];
  box.height = shape->size()[1];
  box.width = scene.dim() == 3 ? shape->size()[2] : body.thickness;
  box.young = scene.plane == Plane::strain ? material.young / (1 - nu * nu) : material.young;
  box.shear = material.young / (2 * (1 + nu));
  box.density = material.density;
  box.step = true;
  box.damped = scene.damping.has_value() || scene.settling.has_value();
  if (material.plasticity()) box.yield = material.plasticity()->yield;
  box.duration = scene.duration;
  check_supports(scene, box, theory);
  if (scene.loads.empty()) refuse_theory(theory, "nothing loads it");
  Point moment{};
  double largest = 0;
  for (const Load& load : scene.loads) {
    if (load.pressure != 0) refuse_theory(theory, "a load is a pressure");
    if (!names_side(load.place, "x+") && !on_plane(load.place, box.origin[0] + box.length, box.length))
      refuse_theory(theory, "a load is not on x+");
    for (const double factor : load.history.factor) box.step &= factor == load.history.factor.back();
    Point arm = middle_of(load.place, *shape), force{};
    arm[0] = 0, arm[1] -= box.origin[1] + box.height / 2,
    arm[2] = scene.dim() == 3 ? arm[2] - box.origin[2] - box.width / 2 : 0;
    for (int c = 0; c < 3; ++c)
      force[c] = load.force[c] * load.history.factor.back(), box.force[c] += force[c];
    for (const double f : force) largest = std::max(largest, std::abs(f));
    add_moment(arm, force, moment);
  }
  for (const double m : moment)
    if (std::abs(m) > 1e-9 * largest * (box.height + box.width))
      refuse_theory(theory, "the loads have a moment about the middle of x+");
  return box;
}

bool only_along(const Point& force, int axis) {
  const double most = std::max({std::abs(force[0]), std::abs(force[1]), std::abs(force[2])});
  for (int c = 0; c < 3; ++c)
    if (c != axis && std::abs(force[c]) > 1e-12 * most) return false;
  return most > 0;
}

void need_elastic(const LoadedBox& box, double stress, const std::string& theory) {
  if (std::abs(stress) > box.yield)
    refuse_theory(theory, fmt::format("its stress reaches {:.4g} MPa, above its yield stress of {:.4g} MPa",
                                      std::abs(stress) / 1e6, box.yield / 1e6));
}

void need_undamped(const LoadedBox& box, const std::string& theory) {
  if (box.damped) refuse_theory(theory, "this scene has damping, and the theory has none");
}

void need_step(const LoadedBox& box, double static_stress, const std::string& theory) {
  if (!box.step)
    refuse_theory(
        theory, "its load is not a step: the theory is for a load that acts in full from the start");
  need_undamped(box, theory);
  need_elastic(box, 2 * static_stress, theory);
}

Theory BoxTheory::operator()(const char* name, const char* unit, const char* formula, Theory::Depends depends,
                             BoxValue value) const {
  return {name, unit, formula, depends,
          [of = box_of, value = std::move(value)](const Scene& scene, const Point& at, double time) {
            const LoadedBox box = of(scene);
            return value(box, at[0] - box.origin[0], at[1] - box.origin[1] - box.height / 2, time);
          }};
}

}  // namespace femsph::compare
