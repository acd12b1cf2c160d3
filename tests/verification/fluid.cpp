// A column of water that hits a rigid wall, against the jump conditions of the shock; and how far finite
// elements follow a fluid.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/motion/march.hpp"
#include "support.hpp"

namespace femsph::test {
namespace {

constexpr double c0 = 1480, slope = 1.92, density = 1000;

const std::string water =
    "[materials.water]\nlaw = \"fluid\"\ndensity = \"1000 kg/m^3\"\n"
    "[materials.water.eos]\nequation = \"mie-grueneisen\"\nc0 = \"1480 m/s\"\ns = 1.92\ngamma0 = 0.1\n";

/// 100 x 4 mm in plane strain, held in y, flies at `speed` onto a smooth wall at x-. Until the shock is at
/// three quarters of the length.
Scene column(double speed, const std::string& material = water, const std::string& sides = "y") {
  using namespace scene_text;
  return parse_scene(
      model("strain", large_motion) + material + box("column", "100 4 mm", thick("100 mm"), "water") +
          support("x-", "x") + support("all", sides) + initial(fmt::format("{} 0 m/s", -speed)) +
          probe("middle", "pressure", "30 2 mm") + time("44 us", "samples = 400\n"),
      "column.toml");
}

// rho0 U v with U = c0 + s v = 1702.72 m/s at 116 m/s: 197.5 MPa. The shock passes 30 mm at 19 us and is at
// 75 mm at 44 us. Without viscosity the pressure oscillates behind the shock: its mean.
TEST(Fluid, PlateauOfTheHugoniot) {
  const double v = 116, U = c0 + slope * v, p = density * U * v;
  EXPECT_NEAR(p, 197.5e6, 0.1e6);
  const auto imbalance = [&](const std::string& method, double safety) {
    compare::Method by = compare::method_named(method);
    if (method == "sph-classic-full") std::get<sph::Options>(by.options).viscosity = {1, 2, 0.01};
    compare::RunOptions options;
    options.march.safety = safety;
    const auto r = compare::run_scene(column(v), by, {1e-3}, options);
    EXPECT_NEAR(mean(r, "middle_pressure", 25e-6, 44e-6), p, 0.05 * p) << method;
    return std::abs(r.ledger.imbalance()) / r.ledger.initial;
  };
  for (const char* method : {"fem-full", "fem-sri", "fem-one-point", "fem-assumed-strain"})
    EXPECT_LT(imbalance(method, 0.9), 1e-6) << method;
  // With the mean change of volume over neighbours the error is of second order in the step.
  const double coarse = imbalance("sph-corrected", 0.9), fine = imbalance("sph-corrected", 0.45);
  EXPECT_LT(coarse, 5e-4);
  EXPECT_LT(fine, std::min(1e-4, coarse / 3));
  imbalance("sph-classic-full", 0.4);
}

// The same in space.
TEST(Fluid, PlateauInSpace) {
  using namespace scene_text;
  const Scene scene = parse_scene(
      model("none", large_motion) + water + box("column", "60 3 3 mm", "", "water") + support("x-", "x") +
          support("all", "y z") + initial("-116 0 0 m/s") + probe("middle", "pressure", "20 1.5 1.5 mm") +
          time("28 us", "samples = 400\n"),
      "solid.toml");
  const double p = density * (c0 + slope * 116) * 116;
  for (const char* method : {"fem-one-point", "sph-corrected"}) {
    const auto r = run(scene, method, 1);
    EXPECT_NEAR(mean(r, "middle_pressure", 18e-6, 28e-6), p, 0.05 * p) << method;
    EXPECT_LT(std::abs(r.ledger.imbalance()), 5e-4 * r.ledger.initial) << method;
  }
}

// Viscosity that smears the shock over some cells: 8/3 eta/dt is about as large as K, so that the step must
// follow it. Nothing oscillates behind the shock; and as e contains the viscous work, the plateau is that of
// the jump.
TEST(Fluid, ViscousShock) {
  const double v = 116, p = density * (c0 + slope * v) * v;
  const std::string thick_water = scene_text::replaced(
      water, "\"1000 kg/m^3\"\n", "\"1000 kg/m^3\"\nviscosity = \"500 Pa s\"\n");
  for (const char* method : {"fem-one-point", "sph-corrected"}) {
    const auto imbalance = [&](double safety) {
      compare::RunOptions options;
      options.march.safety = safety;
      const auto r = compare::run_scene(
          column(v, thick_water), compare::method_named(method), {1e-3}, options);
      EXPECT_NEAR(mean(r, "middle_pressure", 30e-6, 44e-6), p, 0.01 * p) << method;
      EXPECT_GT(r.ledger.plastic, 0.05 * r.ledger.initial) << method;
      return std::abs(r.ledger.imbalance()) / r.ledger.initial;
    };
    const double coarse = imbalance(0.9), fine = imbalance(0.45);  // of second order in the step
    EXPECT_LT(coarse, 1e-3) << method;
    EXPECT_LT(fine, coarse / 3) << method;
  }
}

// Copper at 200 m/s: U = 3940 + 1.489 v = 4237.8 m/s, rho0 U v = 7.569 GPa in the direction of the shock,
// which is the pressure and two thirds of the yield stress (60 MPa).
TEST(Fluid, PlateauOfAMetal) {
  const std::string copper =
      "[materials.water]\nlaw = \"plastic\"\nyoung = \"124 GPa\"\npoisson = 0.34\ndensity = \"8930 "
      "kg/m^3\"\nyield = \"90 MPa\"\nhardening = \"0 Pa\"\n"
      "eos = {equation = \"mie-grueneisen\", c0 = \"3940 m/s\", s = 1.489, gamma0 = 2.02}\n";
  const double v = 200, p = 8930 * (3940 + 1.489 * v) * v - 60e6;
  for (const char* method : {"fem-full", "fem-one-point", "sph-corrected"}) {
    using namespace scene_text;
    const Scene scene = parse_scene(
        model("strain", large_motion) + copper + box("column", "100 4 mm", thick("100 mm"), "water") +
            support("x-", "x") + support("all", "y") + initial("-200 0 m/s") +
            probe("middle", "pressure", "30 2 mm") + time("18 us", "samples = 400\n"),
        "copper.toml");
    const auto r = run(scene, method, 1);
    EXPECT_NEAR(mean(r, "middle_pressure", 10e-6, 18e-6), p, 0.05 * p) << method;
    EXPECT_LT(std::abs(r.ledger.imbalance()), 1e-4 * r.ledger.initial) << method;
  }
}

// A block of water that spreads on a smooth wall at 300 m/s. Cells cannot be sheared without end: one-point
// cells turn inside out, and cells with an assumed strain are drawn out until no step is left.
TEST(Fluid, FiniteElementsStopWhereCellsAreSpent) {
  using namespace scene_text;
  const Scene scene = parse_scene(
      model("strain", large_motion) + water + box("column", "40 20 mm", thick("100 mm"), "water") +
          support("x-", "x") + initial("-300 0 m/s") + probe("end", "displacement", "40 10 mm") +
          time("300 us", "samples = 20\n"),
      "block.toml");
  for (const auto& [method, words] : {std::pair{"fem-one-point", "has turned inside out"},
                                      std::pair{"fem-assumed-strain", "it is crushed so far that"}}) {
    try {
      run(scene, method, 2);
      ADD_FAILURE() << method << " did not stop";
    } catch (const Stopped& stop) {
      EXPECT_THAT(std::string(stop.what()), testing::HasSubstr(words)) << method;
    }
  }
}

}  // namespace
}  // namespace femsph::test
