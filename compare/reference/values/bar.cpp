// A bar under a force along it: one-dimensional waves of speed c = sqrt(E/rho), e.g. Timoshenko and Goodier,
// Theory of Elasticity, ch. 15.

#include <cmath>

#include "compare/reference/values/loaded_box.hpp"

namespace femsph::compare {
namespace {

/// F/A, Pa.
double bar_stress(const LoadedBox& bar) { return bar.force[0] / bar.area(); }

LoadedBox bar_of(const Scene& scene) {
  const LoadedBox box = loaded_box(scene, "bar");
  if (!only_along(box.force, 0)) refuse_theory("bar", "the total force is not along x");
  need_elastic(box, bar_stress(box), "bar");
  return box;
}

/// c = sqrt(E/rho).
double bar_wave_speed(const LoadedBox& bar) { return std::sqrt(bar.young / bar.density); }

/// u(x) = F x/(E A).
double bar_displacement(const LoadedBox& bar, double x) {
  return bar.force[0] * x / (bar.young * bar.area());
}

/// 4 L/c, s: until the motion repeats, the wave runs to the held end and back twice.
double bar_period(const LoadedBox& bar) {
  need_undamped(bar, "bar");
  return 4 * bar.length / bar_wave_speed(bar);
}

/// Step load: the loaded end moves on a triangle between 0 and twice its static displacement.
double bar_end_history(const LoadedBox& bar, double time) {
  need_step(bar, bar_stress(bar), "bar");
  const double phase = std::fmod(time / bar_period(bar), 1.0);
  return 2 * bar_displacement(bar, bar.length) * (phase < 0.5 ? 2 * phase : 2 - 2 * phase);
}

/// Step load: the front raises the stress at x by F/A, its reflection at the held end raises it again, and
/// the reflections at the loaded end remove both.
double bar_stress_history(const LoadedBox& bar, double x, double time) {
  need_step(bar, bar_stress(bar), "bar");
  // Fronts pass x at the times (L - x)/c and (L + x)/c (stress up), (3 L - x)/c and (3 L + x)/c (down).
  const double way = std::fmod(time, bar_period(bar)) * bar_wave_speed(bar), L = bar.length;
  const int level = (way >= L - x) + (way >= L + x) - (way >= 3 * L - x) - (way >= 3 * L + x);
  return level * bar.force[0] / bar.area();
}

}  // namespace

std::vector<Theory> bar_values() {
  using Depends = Theory::Depends;
  using B = LoadedBox;
  const BoxTheory bar{bar_of};
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
      bar("bar_stress_history", "Pa", "steps of F/A, carried by the wave fronts that start at the loaded end",
          Depends::on_place_and_time,
          [](const B& b, double x, double, double t) { return bar_stress_history(b, x, t); }),
  };
}

}  // namespace femsph::compare
