#include "compare/reference/values/cantilever.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/reference/values/loaded_box.hpp"

namespace femsph::compare {
namespace {

/// kappa of a rectangle (E. Reissner 1945; Cowper 1966 for nu = 0).
constexpr double shear_coefficient = 5.0 / 6.0;

/// Euler-Bernoulli: w = P x^2 (3 L - x)/(6 E I).
double cantilever_deflection(const LoadedBox& beam, double x) {
  return beam.force[1] * x * x * (3 * beam.length - x) / (6 * beam.young * beam.inertia());
}

/// Timoshenko: the shear deflection P x/(kappa G A) is added.
double cantilever_deflection_timoshenko(const LoadedBox& beam, double x) {
  return cantilever_deflection(beam, x) + beam.force[1] * x / (shear_coefficient * beam.shear * beam.area());
}

/// sigma_xx = -M y/I with M = P (L - x), eq. 6 of the paper; P along +y.
double cantilever_stress(const LoadedBox& beam, double x, double y) {
  return -beam.force[1] * (beam.length - x) * y / beam.inertia();
}

/// The stress at the upper edge of the held face, Pa.
double root_stress(const LoadedBox& beam) { return cantilever_stress(beam, 0, beam.height / 2); }

LoadedBox cantilever_of(const Scene& scene) {
  const LoadedBox box = loaded_box(scene, "cantilever");
  if (!only_along(box.force, 1)) refuse_theory("cantilever", "the total force is not along y");
  need_elastic(box, root_stress(box), "cantilever");
  return box;
}

/// f_n = (beta_n L)^2/(2 pi L^2) sqrt(E I/(rho A)), Hz.
double cantilever_frequency(const LoadedBox& beam, int n = 1) {
  need_undamped(beam, "cantilever");
  const double beta = cantilever_eigenvalue(n) / beam.length;
  return beta * beta / (2 * std::numbers::pi) *
         std::sqrt(beam.young * beam.inertia() / (beam.density * beam.area()));
}

// Step load without damping, by modes (Clough and Penzien, Dynamics of Structures, ch. 19). With shapes
// normalised to integral phi^2 = L, phi_n(L) = 2 (-1)^(n+1) and phi_n''(0) = 2 beta_n^2, and with b_n =
// beta_n L,
//   tip(t)  = P L^3/(3 E I)  sum_n 12/b_n^4 (1 - cos omega_n t)
//   root(t) = P L            sum_n 4 (-1)^(n+1)/b_n^2 (1 - cos omega_n t)

constexpr int modes = 10;  // the tenth mode adds 2e-5 of the tip's motion and 0.5 % of the moment at the root

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

/// The value of the largest magnitude within the scene's duration, with its sign, from at least 2000 samples
/// per period.
double extreme(double duration, double longest_period, const std::function<double(double)>& history) {
  if (duration <= 0) throw std::runtime_error("the peak of a response needs a duration above 0");
  const int count = std::max(2000, int(2000 * duration / longest_period));
  double peak = 0;
  for (int i = 0; i <= count; ++i) {
    const double value = history(duration * i / count);
    if (std::abs(value) > std::abs(peak)) peak = value;
  }
  return peak;
}

double cantilever_tip_peak(const LoadedBox& beam) {
  return extreme(beam.duration, 1 / cantilever_frequency(beam),
                 [&](double t) { return cantilever_tip_history(beam, t); });
}

double cantilever_root_moment_peak(const LoadedBox& beam) {
  return extreme(beam.duration, 1 / cantilever_frequency(beam),
                 [&](double t) { return cantilever_root_moment_history(beam, t); });
}

}  // namespace

double cantilever_eigenvalue(int n) {
  double b = (2 * n - 1) * std::numbers::pi / 2;  // exact for large n; then Newton's method
  for (int turn = 0; turn < 8; ++turn) {
    const double sech = 1 / std::cosh(b);
    b += (std::cos(b) + sech) / (std::sin(b) + sech * std::tanh(b));
  }
  return b;
}

std::vector<Theory> cantilever_values() {
  using Depends = Theory::Depends;
  using B = LoadedBox;
  const BoxTheory cantilever{cantilever_of};
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
      cantilever("cantilever_tip_history", "m", "response to a step load, as a sum of ten modes",
                 Depends::on_time,
                 [](const B& b, double, double, double t) { return cantilever_tip_history(b, t); }),
      cantilever(
          "cantilever_tip_peak", "m",
          "largest magnitude of cantilever_tip_history within the scene's duration", Depends::on_nothing,
          [](const B& b, double, double, double) { return cantilever_tip_peak(b); }),
      cantilever("cantilever_root_moment_history", "N m", "response to a step load, as a sum of ten modes",
                 Depends::on_time,
                 [](const B& b, double, double, double t) { return cantilever_root_moment_history(b, t); }),
      cantilever("cantilever_root_moment_peak", "N m", "largest magnitude of it within the scene's duration",
                 Depends::on_nothing,
                 [](const B& b, double, double, double) { return cantilever_root_moment_peak(b); }),
  };
}

}  // namespace femsph::compare
