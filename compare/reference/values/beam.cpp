#include "compare/reference/values/beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "model/scene/shapes/box.hpp"

namespace femsph::compare {
namespace {

constexpr int modes = 10;  // the tenth carries 2e-5 of the tip's motion and 0.5 % of the root moment

[[noreturn]] void refuse(const std::string& theory, const std::string& why) {
  throw std::runtime_error(fmt::format(
      "{} theory needs one box, held on x- and loaded by forces on x+ alone, but {}", theory, why));
}

bool names(const Place& place, const std::string& side) {
  return std::find(place.sides.begin(), place.sides.end(), side) != place.sides.end();
}

bool on_plane(const Place& place, double x, double length) {
  return place.point && std::abs((*place.point)[0] - x) <= 1e-9 * length;
}

/// Where the resultant of a force on a place acts: the place's middle.
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

// Held on x-: its whole face along x, and along y somewhere on it.
void check_supports(const Scene& scene, const LoadedBox& box, const std::string& theory) {
  bool along_x = false, along_y = false;
  for (const Support& support : scene.supports) {
    if (!names(support.place, "x-") && !on_plane(support.place, box.origin[0], box.length))
      refuse(theory, "a support is not on x-");
    if (support.velocity != Point{}) refuse(theory, "a support moves");
    along_x |= support.fixed[0] && !support.mean && !support.place.within &&
               support.place.sides == std::vector<std::string>{"x-"};
    along_y |= support.fixed[1];
  }
  if (!along_x) refuse(theory, "the face x- is not held along x");
  if (!along_y) refuse(theory, "nothing holds it along y");
}

/// What no theory of one box knows; empty if there is nothing of it. `moving`: the theory is of a body that
/// starts with a velocity.
std::string unknown_to_theory(const Scene& scene, bool moving) {
  if (scene.bodies.size() != 1) return fmt::format("this scene has {} bodies", scene.bodies.size());
  if (!scene.bodies[0].shape->is_box()) return "this body is no box";
  if (scene.bodies[0].rigid) return "this body is rigid";
  if (scene.gravity) return "this scene has gravity";
  if (!moving && !scene.initial_velocities.empty()) return "this scene has an initial velocity";
  if (!scene.initial_displacements.empty()) return "this scene has an initial displacement";
  if (!scene.symmetries.empty()) return "this scene has a plane of symmetry";
  if (!scene.bars.empty()) return "this body has bars in it";
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.is_linear_elastic() && !m.plasticity()) return "its material is " + m.entry().name;
  return "";
}

/// Off the middle of x+ a force along x bends, and one across it twists: `force` acts at `arm` from the
/// middle.
void add_moment(const Point& arm, const Point& force, Point& moment) {
  for (int c = 0; c < 3; ++c) {
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    moment[c] += arm[a] * force[b] - arm[b] * force[a];
  }
}

LoadedBox box_of(const Scene& scene, const std::string& theory) {
  if (const std::string why = unknown_to_theory(scene, false); !why.empty()) refuse(theory, why);
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
  if (scene.loads.empty()) refuse(theory, "nothing loads it");
  Point moment{};
  double largest = 0;
  for (const Load& load : scene.loads) {
    if (load.pressure != 0) refuse(theory, "a load is a pressure");
    if (!names(load.place, "x+") && !on_plane(load.place, box.origin[0] + box.length, box.length))
      refuse(theory, "a load is not on x+");
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
      refuse(theory, "the loads turn x+ about its middle");
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
    refuse(theory, fmt::format("the load takes it to {:.4g} MPa, beyond its yield stress of {:.4g} MPa",
                               std::abs(stress) / 1e6, box.yield / 1e6));
}

void need_undamped(const LoadedBox& box, const std::string& theory) {
  if (box.damped) refuse(theory, "this scene has damping, and the motion is known without it");
}

/// The response to a step goes to twice the static one.
void need_step(const LoadedBox& box, double stress, const std::string& theory) {
  if (!box.step)
    refuse(theory, "its load is no step: the response to a step in time is known, to another history not");
  need_undamped(box, theory);
  need_elastic(box, 2 * stress, theory);
}

double bar_stress(const LoadedBox& bar) { return bar.force[0] / bar.area(); }
double root_stress(const LoadedBox& beam) { return cantilever_stress(beam, 0, beam.height / 2); }

double extreme(double duration, double longest_period, const std::function<double(double)>& history) {
  if (duration <= 0) throw std::runtime_error("the peak of a response needs a scene with a duration");
  const int count = std::max(2000, int(2000 * duration / longest_period));
  double peak = 0;
  for (int i = 0; i <= count; ++i) {
    const double value = history(duration * i / count);
    if (std::abs(value) > std::abs(peak)) peak = value;
  }
  return peak;
}

}  // namespace

LoadedBox bar_of(const Scene& scene) {
  const LoadedBox box = box_of(scene, "bar");
  if (!only_along(box.force, 0)) refuse("bar", "the total force is not along x");
  need_elastic(box, bar_stress(box), "bar");
  return box;
}

LoadedBox cantilever_of(const Scene& scene) {
  const LoadedBox box = box_of(scene, "cantilever");
  if (!only_along(box.force, 1)) refuse("cantilever", "the total force is not along y");
  need_elastic(box, root_stress(box), "cantilever");
  return box;
}

double Impact::stress() const {
  const double c = std::sqrt(young / density), limit = yield / (density * c);
  return speed < limit ? density * c * speed : yield + std::sqrt(tangent * density) * (speed - limit);
}

double Impact::strain() const {
  const double c = std::sqrt(young / density), limit = yield / (density * c);
  return speed < limit ? speed / c : yield / young + (speed - limit) / std::sqrt(tangent / density);
}

Impact impact_of(const Scene& scene) {
  const auto refuse_impact = [](const std::string& why) {
    throw std::runtime_error(
        "impact theory needs one box of linear hardening that flies along x onto its held end x-, in plane "
        "stress or in space, but " +
        why);
  };
  if (const std::string why = unknown_to_theory(scene, true); !why.empty()) refuse_impact(why);
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.plasticity()) refuse_impact("its material is elastic");
  if (m.plasticity()->johnson_cook) refuse_impact("its material hardens by Johnson-Cook, not linearly");
  if (scene.plane == Plane::strain)
    refuse_impact("this scene is in plane strain, where no bar is free to widen");
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
    if (!names(support.place, "x-")) refuse_impact("a support is not on x-");
    if (support.velocity != Point{}) refuse_impact("a support moves");
    held |= support.fixed[0] && !support.mean && !support.place.within && support.place.sides.size() == 1;
  }
  if (!held) refuse_impact("the face x- is not held along x");
  const double H = m.plasticity()->hardening;
  return {-start.velocity[0], m.young, m.density, m.plasticity()->yield, m.young * H / (m.young + H)};
}

double plastic_moment(const Scene& scene) {
  const auto refuse_moment = [](const std::string& why) {
    throw std::runtime_error(
        "plastic moment theory needs one box of perfect plasticity, in plane stress or in space, but " + why);
  };
  if (const std::string why = unknown_to_theory(scene, false); !why.empty()) refuse_moment(why);
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

double bar_wave_speed(const LoadedBox& bar) { return std::sqrt(bar.young / bar.density); }

double bar_displacement(const LoadedBox& bar, double x) {
  return bar.force[0] * x / (bar.young * bar.area());
}

double bar_period(const LoadedBox& bar) {
  need_undamped(bar, "bar");
  return 4 * bar.length / bar_wave_speed(bar);
}

double bar_end_history(const LoadedBox& bar, double time) {
  need_step(bar, bar_stress(bar), "bar");
  const double phase = std::fmod(time / bar_period(bar), 1.0);
  return 2 * bar_displacement(bar, bar.length) * (phase < 0.5 ? 2 * phase : 2 - 2 * phase);
}

double bar_stress_history(const LoadedBox& bar, double x, double time) {
  need_step(bar, bar_stress(bar), "bar");
  // Fronts pass x at (L - x), (L + x), (3 L - x), (3 L + x) over c: up, up, down, down.
  const double way = std::fmod(time, bar_period(bar)) * bar_wave_speed(bar), L = bar.length;
  const int level = (way >= L - x) + (way >= L + x) - (way >= 3 * L - x) - (way >= 3 * L + x);
  return level * bar.force[0] / bar.area();
}

double cantilever_deflection(const LoadedBox& beam, double x) {
  return beam.force[1] * x * x * (3 * beam.length - x) / (6 * beam.young * beam.inertia());
}

double cantilever_deflection_timoshenko(const LoadedBox& beam, double x) {
  return cantilever_deflection(beam, x) + beam.force[1] * x / (shear_coefficient * beam.shear * beam.area());
}

double cantilever_stress(const LoadedBox& beam, double x, double y) {
  return -beam.force[1] * (beam.length - x) * y / beam.inertia();
}

double cantilever_eigenvalue(int n) {
  double b = (2 * n - 1) * std::numbers::pi / 2;  // the limit of large n; Newton needs four turns for n = 1
  for (int turn = 0; turn < 8; ++turn) {
    const double sech = 1 / std::cosh(b);
    b += (std::cos(b) + sech) / (std::sin(b) + sech * std::tanh(b));
  }
  return b;
}

double cantilever_frequency(const LoadedBox& beam, int n) {
  need_undamped(beam, "cantilever");
  const double beta = cantilever_eigenvalue(n) / beam.length;
  return beta * beta / (2 * std::numbers::pi) *
         std::sqrt(beam.young * beam.inertia() / (beam.density * beam.area()));
}

double cantilever_tip_history(const LoadedBox& beam, double time) {
  need_step(beam, root_stress(beam), "cantilever");
  double sum = 0;
  for (int n = 1; n <= modes; ++n) {
    const double beta = cantilever_eigenvalue(n);
    sum += 12 / std::pow(beta, 4) *
           (1 - std::cos(2 * std::numbers::pi * cantilever_frequency(beam, n) * time));
  }
  return sum * cantilever_deflection(beam, beam.length);
}

double cantilever_root_moment_history(const LoadedBox& beam, double time) {
  need_step(beam, root_stress(beam), "cantilever");
  double sum = 0;
  for (int n = 1; n <= modes; ++n) {
    const double beta = cantilever_eigenvalue(n);
    const double share = 4 / (beta * beta) *
                         (1 - std::cos(2 * std::numbers::pi * cantilever_frequency(beam, n) * time));
    sum += n % 2 ? share : -share;
  }
  return sum * beam.force[1] * beam.length;
}

double cantilever_tip_peak(const LoadedBox& beam) {
  return extreme(beam.duration, 1 / cantilever_frequency(beam),
                 [&](double t) { return cantilever_tip_history(beam, t); });
}

double cantilever_root_moment_peak(const LoadedBox& beam) {
  return extreme(beam.duration, 1 / cantilever_frequency(beam),
                 [&](double t) { return cantilever_root_moment_history(beam, t); });
}

}  // namespace femsph::compare
