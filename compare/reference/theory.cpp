#include "compare/reference/theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/reference/beam.hpp"
#include "model/input/faults.hpp"

namespace femsph::compare {
namespace {

using Depends = Theory::Depends;

/// A value of the loaded box, and where it is asked for: x from the held end, y from the middle of the
/// height.
using BoxValue = std::function<double(const LoadedBox&, double x, double y, double time)>;

Theory from(LoadedBox (*box_of)(const Scene&), const char* name, const char* unit, const char* formula,
            Depends depends, BoxValue value) {
  return {name, unit, formula, depends, [box_of, value](const Scene& scene, const Point& at, double time) {
            const LoadedBox box = box_of(scene);
            return value(box, at[0] - box.origin[0], at[1] - box.origin[1] - box.height / 2, time);
          }};
}

/// A body of perfect plasticity, strained to its yield surface by one deviatoric gradient and then steadily
/// by another across it: the deviator s of constant size S = sqrt(2/3) sigma_y turns to the strain rate e by
/// d theta/dt = -(2G |e| / S) sin theta, from a right angle (Prandtl-Reuss).
double return_path_xx(const Scene& scene, double time) {
  const auto inner = [](const Matrix& a, const Matrix& b) {
    return a[0][0] * b[0][0] + a[1][1] * b[1][1] + a[2][2] * b[2][2];
  };
  const auto deviator_along_axes = [](const Matrix& a) {
    double trace = 0, across = 0, size = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        (i == j ? trace : across) += i == j ? a[i][j] : std::abs(a[i][j]), size += std::abs(a[i][j]);
    return std::abs(trace) + across <= 1e-6 * size;
  };
  if (scene.bodies.size() != 1 || scene.bodies[0].rigid || scene.plane == Plane::stress || scene.large_motion)
    throw std::runtime_error("this theory is of one body in plane strain or in space, in small motion");
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.plasticity() || !m.plasticity()->perfect() || scene.initial_displacements.size() != 1 ||
      scene.initial_velocities.size() != 1)
    throw std::runtime_error(
        "this theory is of a material without hardening, with one initial displacement and one initial "
        "velocity");
  const InitialVelocity& start = scene.initial_velocities[0];
  const Matrix &a = scene.initial_displacements[0].gradient, &b = start.gradient;
  const double size_a = std::sqrt(inner(a, a)), size_b = std::sqrt(inner(b, b)),
               shear = m.young / (2 * (1 + m.poisson));
  const double S = std::sqrt(2.0 / 3) * m.plasticity()->yield;
  if (!(size_b > 0) || std::abs(inner(a, b)) > 1e-9 * size_a * size_b || !(2 * shear * size_a >= S) ||
      !deviator_along_axes(a) || !deviator_along_axes(b) || start.profile || start.spin != Point{})
    throw std::runtime_error(
        "this theory is of an initial strain beyond yield and a rate of strain across it, both deviators "
        "along the axes");
  const double theta = 2 * std::atan(std::exp(-2 * shear * size_b * time / S));
  return S * (std::sin(theta) * a[0][0] / size_a + std::cos(theta) * b[0][0] / size_b);
}

Theory bar(const char* name, const char* unit, const char* formula, Depends depends, BoxValue value) {
  return from(bar_of, name, unit, formula, depends, std::move(value));
}

Theory cantilever(const char* name, const char* unit, const char* formula, Depends depends, BoxValue value) {
  return from(cantilever_of, name, unit, formula, depends, std::move(value));
}

using B = LoadedBox;

// E is Young's modulus in plane stress and in 3D, and E/(1 - nu^2) in plane strain, for every value below.
std::vector<Theory> all() {
  return {
      bar("bar_stress", "Pa", "F/A", Depends::on_nothing,
          [](const B& b, double, double, double) { return b.force[0] / b.area(); }),
      bar("bar_strain", "1", "F/(E A)", Depends::on_nothing,
          [](const B& b, double, double, double) { return b.force[0] / (b.young * b.area()); }),
      bar("bar_displacement", "m", "F L/(E A), of the loaded end", Depends::on_nothing,
          [](const B& b, double, double, double) { return bar_displacement(b, b.length); }),
      bar("bar_displacement_at", "m", "F x/(E A)", Depends::on_place,
          [](const B& b, double x, double, double) { return bar_displacement(b, x); }),
      bar("bar_period", "s", "4 L/c, c = sqrt(E/rho)", Depends::on_nothing,
          [](const B& b, double, double, double) { return bar_period(b); }),
      bar("bar_frequency", "Hz", "c/(4 L)", Depends::on_nothing,
          [](const B& b, double, double, double) { return 1 / bar_period(b); }),
      bar("bar_peak", "m", "2 F L/(E A): twice the static displacement, under a step load",
          Depends::on_nothing,
          [](const B& b, double, double, double) { return bar_end_history(b, bar_period(b) / 2); }),
      bar("bar_displacement_history", "m",
          "triangle of period 4 L/c between 0 and 2 F L/(E A), of the loaded end", Depends::on_time,
          [](const B& b, double, double, double t) { return bar_end_history(b, t); }),
      bar("bar_stress_history", "Pa", "fronts of F/A that start at the loaded end",
          Depends::on_place_and_time,
          [](const B& b, double x, double, double t) { return bar_stress_history(b, x, t); }),
      {"return_path_xx", "Pa",
       "theta = 2 atan(exp(-z)) between deviator and strain rate, without hardening; sigma_xx",
       Depends::on_time, [](const Scene& scene, const Point&, double t) { return return_path_xx(scene, t); }},
      {"impact_stress", "Pa", "yield + rho c_p (V - V_y), behind the plastic front (compression: below 0)",
       Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return -impact_of(scene).stress(); }},
      {"impact_strain", "1", "yield/E + (V - V_y)/c_p, behind the plastic front (compression: below 0)",
       Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return -impact_of(scene).strain(); }},
      {"plastic_moment", "N m", "sigma_y b h^2/4", Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return plastic_moment(scene); }},
      cantilever("cantilever_tip", "m", "P L^3/(3 E I), Euler-Bernoulli", Depends::on_nothing,
                 [](const B& b, double, double, double) { return cantilever_deflection(b, b.length); }),
      cantilever(
          "cantilever_tip_timoshenko", "m", "P L^3/(3 E I) + P L/(kappa G A), kappa = 5/6",
          Depends::on_nothing,
          [](const B& b, double, double, double) { return cantilever_deflection_timoshenko(b, b.length); }),
      cantilever("cantilever_deflection", "m", "P x^2 (3 L - x)/(6 E I)", Depends::on_place,
                 [](const B& b, double x, double, double) { return cantilever_deflection(b, x); }),
      cantilever("cantilever_stress", "Pa", "sigma_xx = -P (L - x) y/I", Depends::on_place,
                 [](const B& b, double x, double y, double) { return cantilever_stress(b, x, y); }),
      cantilever("cantilever_strain", "1", "eps_xx = -P (L - x) y/(E I)", Depends::on_place,
                 [](const B& b, double x, double y, double) { return cantilever_stress(b, x, y) / b.young; }),
      cantilever("cantilever_frequency", "Hz", "1.875104^2/(2 pi L^2) sqrt(E I/(rho A))", Depends::on_nothing,
                 [](const B& b, double, double, double) { return cantilever_frequency(b); }),
      cantilever("cantilever_tip_history", "m", "step response as a sum of ten modes", Depends::on_time,
                 [](const B& b, double, double, double t) { return cantilever_tip_history(b, t); }),
      cantilever(
          "cantilever_tip_peak", "m",
          "largest magnitude of cantilever_tip_history within the scene's duration", Depends::on_nothing,
          [](const B& b, double, double, double) { return cantilever_tip_peak(b); }),
      cantilever("cantilever_root_moment_history", "N m", "step response as a sum of ten modes",
                 Depends::on_time,
                 [](const B& b, double, double, double t) { return cantilever_root_moment_history(b, t); }),
      cantilever("cantilever_root_moment_peak", "N m", "largest magnitude of it within the scene's duration",
                 Depends::on_nothing,
                 [](const B& b, double, double, double) { return cantilever_root_moment_peak(b); }),
  };
}

}  // namespace

const std::vector<Theory>& theories() {
  static const std::vector<Theory> list = all();
  return list;
}

std::vector<std::string> theory_names() {
  std::vector<std::string> names;
  for (const Theory& theory : theories()) names.push_back(theory.name);
  return names;
}

const Theory& theory_named(const std::string& name) {
  for (const Theory& theory : theories())
    if (theory.name == name) return theory;
  throw std::runtime_error(fmt::format("no theory is called {}; expected {}{}", in_quotes(name),
                                       one_of(theory_names()), did_you_mean(name, theory_names())));
}

}  // namespace femsph::compare
