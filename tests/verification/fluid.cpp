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
  for (const char* method :
       {"fem-full", "fem-sri", "fem-one-point", "fem-assumed-strain", "sph-corrected", "sph-classic-full"}) {
    const auto r = run(column(v), method, 1);
    const double plateau = mean(r, "middle_pressure", 25e-6, 44e-6);
    EXPECT_NEAR(plateau, p, 0.05 * p) << method;
    EXPECT_LT(std::abs(r.ledger.imbalance()), 1e-4 * r.ledger.initial) << method;
    fmt::print(
        "{}: {:.5g} MPa, imbalance {:.3g}\n", method, plateau / 1e6, r.ledger.imbalance() / r.ledger.initial);
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

// A block of water that spreads on a smooth wall. Cells cannot be sheared without end: the run stops with the
// message for that.
TEST(Fluid, FiniteElementsStopAtAnInvertedCell) {
  using namespace scene_text;
  const Scene scene = parse_scene(
      model("strain", large_motion) + water + box("column", "40 20 mm", thick("100 mm"), "water") +
          support("x-", "x") + initial("-116 0 m/s") + probe("end", "displacement", "40 10 mm") +
          time("1 ms", "samples = 20\n"),
      "block.toml");
  for (const char* method : {"fem-full", "fem-one-point", "fem-assumed-strain"}) {
    try {
      run(scene, method, 2);
      ADD_FAILURE() << method << " did not stop";
    } catch (const Stopped& stop) {
      EXPECT_THAT(stop.what(), testing::HasSubstr("turned inside out")) << method;
    }
  }
}

}  // namespace
}  // namespace femsph::test
