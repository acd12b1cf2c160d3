// A bar under a force along it.

#include "compare/reference/values/box_value.hpp"

namespace femsph::compare {
namespace {

Theory bar(const char* name, const char* unit, const char* formula, Theory::Depends depends, BoxValue value) {
  return box_theory(bar_of, name, unit, formula, depends, std::move(value));
}

}  // namespace

std::vector<Theory> bar_values() {
  using Depends = Theory::Depends;
  using B = LoadedBox;
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
  };
}

}  // namespace femsph::compare
