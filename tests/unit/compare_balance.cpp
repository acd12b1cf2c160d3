// Balance with reactions: the impulse of supports, loads and gravity is the change of momentum, and their
// work is the change of energy.
//
// The histories have a row for every step, so that the trapezoidal rule over a reaction is the sum of the
// leap-frog scheme: with m (v+ - v-) = dt f at every whole step and v(n) = (v- + v+)/2, sum' dt f = m (v(N) -
// v(0)), sum' with half of the first and last term. To round-off.

#include "compare_balance_support.hpp"

namespace femsph::compare {
namespace {

using namespace test;  // of compare_balance_support.hpp
using namespace scene_text;

/// A bar 100 x 10 x 10 mm of steel, along x, and what happens to it in `ms`; a row for every step.
Scene slender_bar(const std::string& what, const std::string& ms) {
  return balance_scene(model("none") + steel("0.25") + box("bar", "100 10 10 mm") + what +
                       scene_text::time(ms + " ms", "samples = 1000000\n"));
}

constexpr double bar_mass = 7850 * 0.1 * 1e-4;

// The left face is driven to 1 m/s within 1 ms, about thirteen periods of the lowest mode: then the momentum
// is M v, at every spacing. Until then the impulse is the momentum, to round-off.
TEST(Balance, ImpulseOfADrivenFaceIsTheMomentumOfTheBar) {
  const Scene scene = slender_bar(
      support("x-", "x",
              velocity("1 0 0 m/s") + "history = {time = [\"0 ms\", \"1 ms\"], factor = [0, 1]}\n" +
                  named("grip")),
      "1.2");
  for (const char* method : {"fem-full", "sph-corrected"})
    for (const double mm : {10.0, 5.0}) {
      const RunResult r = run_scene(scene, method_named(method), {mm * 1e-3, {}}, {});
      EXPECT_NEAR(impulse(r, "support_grip_force_x"), change(r, "momentum_x"), 1e-12 * bar_mass)
          << method << mm;
      const auto &t = column(r, "time"), &p = column(r, "momentum_x");
      double sum = 0;
      int n = 0;
      for (std::size_t k = 0; k < t.size(); ++k)
        if (t[k] > 1e-3) sum += p[k], ++n;
      EXPECT_NEAR(sum / n, bar_mass, 2e-3 * bar_mass) << method << mm;
      EXPECT_LT(largest(column(r, "energy_imbalance")), 1e-12 * r.ledger.external) << method << mm;
      EXPECT_LT(r.balance.force, 1e-12) << method << mm;
      EXPECT_LT(r.balance.moment, 1e-12) << method << mm;
    }
}

// A support that moves at full speed from the start accelerates its points within the first step; one that
// holds points of a flying body stops them. The reaction contains these impulses.
TEST(Balance, SupportsThatStartOrStopAtOnceGiveAnImpulse) {
  const std::string push = support("x-", "x", velocity("1 0 0 m/s") + named("grip"));
  const std::string wall = support("x-", "x", named("grip")) + initial("-2 1 0 m/s");
  const std::string together = push + initial("1 0 0 m/s");
  for (const char* method : {"fem-full", "sph-corrected"}) {
    const auto run = [&](const std::string& what) {
      return run_scene(slender_bar(what, "0.03"), method_named(method), {0.005, {}}, {});
    };
    const RunResult pushed = run(push), stopped = run(wall), flying = run(together);
    for (const RunResult* r : {&pushed, &stopped}) {
      EXPECT_NEAR(impulse(*r, "support_grip_force_x"), change(*r, "momentum_x"), 1e-12 * bar_mass) << method;
      EXPECT_GT(std::abs(change(*r, "momentum_x")), 0.5 * bar_mass) << method;
      EXPECT_LT(largest(column(*r, "energy_imbalance")), 1e-12 * largest(column(*r, "kinetic_energy")))
          << method;
    }
    EXPECT_NEAR(column(stopped, "momentum_x").front(), -2 * bar_mass, 1e-12)
        << method;  // before the support acts
    EXPECT_NEAR(column(stopped, "kinetic_energy").front(), 0.5 * bar_mass * 5, 1e-12) << method;
    EXPECT_EQ(column(pushed, "kinetic_energy").front(), 0) << method;
    EXPECT_LT(largest(column(flying, "support_grip_force_x")), 1e-6) << method << ": no reaction";
  }
}

// The reaction includes mass-proportional damping of the driven points and, in classic SPH, the artificial
// viscosity.
TEST(Balance, DampingAndViscosityOfDrivenPointsAreInTheReaction) {
  const Scene scene = slender_bar(
      support("x-", "x y z",
              velocity("1 0 0 m/s") + "history = {time = [\"0 ms\", \"0.05 ms\"], factor = [0, 1]}\n" +
                  named("grip")) +
          "[damping]\nrate = \"20000 1/s\"\n",
      "0.2");
  Method viscous = method_named("sph-classic-share");
  std::get<sph::Options>(viscous.options).viscosity = {0.5, 0.5, 0.1};
  for (const Method& method : {method_named("fem-full"), viscous}) {
    const RunResult r = run_scene(scene, method, {0.005, {}}, {});
    // P' = R - c P
    EXPECT_NEAR(impulse(r, "support_grip_force_x") - 20000 * impulse(r, "momentum_x"),
                change(r, "momentum_x"), 1e-11 * impulse(r, "support_grip_force_x"))
        << method.name;
    EXPECT_LT(largest(column(r, "energy_imbalance")), 1e-12 * r.ledger.external) << method.name;
    EXPECT_GT(r.ledger.damping, 0.1 * r.ledger.external) << method.name;
  }
  EXPECT_GT(run_scene(scene, viscous, {0.005, {}}, {}).ledger.viscosity, 0);
}

// Free fall from rest: v = g t at whole steps, so that the kinetic energy is 1/2 M (g t)^2, from 0 on.
TEST(Balance, KineticEnergyIsThatOfTheWholeStep) {
  const RunResult r = run_scene(
      balance_scene(block(gravity("0 -10 m/s^2") + scene_text::time("5 ms", "samples = 20\n"))),
      method_named("fem-full"), {0.25, {}}, {});
  for (std::size_t k = 0; k < r.history.rows(); ++k) {
    const double t = column(r, "time")[k];
    EXPECT_NEAR(column(r, "kinetic_energy")[k], 0.5 * 2000 * 100 * t * t, 1e-12);
    EXPECT_NEAR(column(r, "momentum_y")[k], -20000 * t, 1e-9);
    EXPECT_NEAR(column(r, "angular_momentum_z")[k], -20000 * t, 1e-9);  // the centre is 1 m from the origin
    EXPECT_LT(std::abs(column(r, "energy_imbalance")[k]), 1e-11);
  }
}

}  // namespace
}  // namespace femsph::compare
