// At rest means equilibrium, by either method of settling: the tolerance bounds what is missing of the
// reaction and of the displacement.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compare/run/run.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {
namespace {

using testing::HasSubstr;

/// The paper's cantilever, 1000 x 100 mm of steel, 1 kN down at its end.
Scene cantilever(const std::string& settling, const char* duration = "200 ms", const char* history = "") {
  return parse_scene(R"([model]
plane = "stress"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
[bodies.beam]
shape = "box"
size = ["1000 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[[supports]]
at = "x-"
fix = ["x", "y"]
name = "root"
[[loads]]
at = "x+"
force = ["0 N", "-1 kN"]
)" + std::string(history) +
                         R"([[probes]]
name = "tip"
quantity = "displacement"
point = ["1000 mm", "50 mm"]
[settling]
)" + settling + "[time]\nduration = \"" +
                         duration + "\"\nsamples = 10\n",
                     "settling.toml");
}

double last(const RunResult& r, const char* column) { return r.history[column].values.back(); }

TEST(Settling, BothMethodsComeToTheSameRestInComparableTimes) {
  for (const char* method : {"fem-full", "fem-assumed-strain", "sph-corrected"}) {
    const auto run = [&](const char* settling) {
      return run_scene(cantilever(settling), method_named(method), {0.025, {}}, {});
    };
    const RunResult exact = run("method = \"damping\"\ntolerance = 1e-8\n");
    ASSERT_TRUE(exact.settled) << method << testing::PrintToString(exact.warnings);
    double steps[2];
    int k = 0;
    for (const char* by : {"damping", "kinetic"}) {
      const RunResult r = run(("method = \"" + std::string(by) + "\"\n").c_str());
      ASSERT_TRUE(r.settled) << method << by;
      EXPECT_NEAR(last(r, "support_root_force_y"), 1000, 1000 * 1e-4) << method << by;
      EXPECT_NEAR(last(r, "tip_y") / last(exact, "tip_y"), 1, 1e-4) << method << by;
      EXPECT_LT(std::abs(r.ledger.imbalance()), 1e-10 * r.ledger.external) << method << by;
      steps[k++] = double(r.price.steps);
    }
    EXPECT_LT(steps[1], 3 * steps[0]) << method;
    EXPECT_LT(steps[0], 3 * steps[1]) << method;
  }
}

// Strong damping creeps: hardly any kinetic energy, and far from the end.
TEST(Settling, ABodyThatCreepsIsNotAtRest) {
  const RunResult r = run_scene(cantilever("method = \"damping\"\nrate = \"400000 1/s\"\n", "20 ms"),
                                method_named("fem-full"), {0.025, {}}, {});
  EXPECT_FALSE(r.settled);
  EXPECT_THAT(r.warnings, testing::Contains(testing::AllOf(
                              HasSubstr("not settled within"), HasSubstr("for a tolerance of 0.0001"),
                              HasSubstr("no static state"))));
}

// Nor is one whose load is still growing, however slowly it is followed.
TEST(Settling, ABodyIsNotAtRestBeforeItsLoadIs) {
  const RunResult r = run_scene(
      cantilever("method = \"damping\"\ntolerance = 0.05\n", "60 ms", "history = {ramp = \"40 ms\"}\n"),
      method_named("fem-full"), {0.05, {}}, {});
  EXPECT_TRUE(r.settled);
  EXPECT_GE(r.history["time"].values.back(), 0.04 - 1e-9);
  EXPECT_NEAR(last(r, "support_root_force_y"), 1000, 1000 * 0.05);
}

}  // namespace
}  // namespace femsph::compare
