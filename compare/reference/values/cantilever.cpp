// A cantilever under a force across its end.

#include "compare/reference/values/box_value.hpp"

namespace femsph::compare {
namespace {

Theory cantilever(const char* name, const char* unit, const char* formula, Theory::Depends depends,
                  BoxValue value) {
  return box_theory(cantilever_of, name, unit, formula, depends, std::move(value));
}

}  // namespace

std::vector<Theory> cantilever_values() {
  using Depends = Theory::Depends;
  using B = LoadedBox;
  return {
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

}  // namespace femsph::compare
