// Settled means in equilibrium, by either method of settling: the tolerance bounds the errors of the reaction
// and of the displacement.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compare/run/run.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph::compare {
namespace {

using testing::HasSubstr;

using namespace scene_text;

/// The paper's cantilever, 1000 x 100 mm of steel, 1 kN down at its end; `of_load`, `of_settling`: further
/// lines of these tables.
Scene settling_beam(const std::string& method, const std::string& of_settling = "",
                    const std::string& duration = "200 ms", const std::string& of_load = "") {
  return parse_scene(clamped_beam("1000 100 mm", "100 mm", "0.3", named("root")) +
                         load("x+", "0 -1 kN", of_load) + probe("tip", "displacement", "1000 50 mm") +
                         settling(method, of_settling) + scene_text::time(duration, "samples = 10\n"),
                     "settling.toml");
}

double last(const RunResult& r, const char* column) { return r.history[column].values.back(); }

TEST(Settling, BothMethodsComeToTheSameRestInComparableTimes) {
  for (const char* method : {"fem-full", "fem-assumed-strain", "sph-corrected"}) {
    const auto run = [&](const std::string& by, const std::string& more = "") {
      return run_scene(settling_beam(by, more), method_named(method), {0.025, {}}, {});
    };
    const RunResult exact = run("damping", "tolerance = 1e-8\n");
    ASSERT_TRUE(exact.settled) << method << testing::PrintToString(exact.warnings);
    double steps[2];
    int k = 0;
    for (const char* by : {"damping", "kinetic"}) {
      const RunResult r = run(by);
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

// With strong damping the body creeps: hardly any kinetic energy, but far from equilibrium.
TEST(Settling, ABodyThatCreepsIsNotAtRest) {
  const RunResult r = run_scene(settling_beam("damping", "rate = \"400000 1/s\"\n", "20 ms"),
                                method_named("fem-full"), {0.025, {}}, {});
  EXPECT_FALSE(r.settled);
  EXPECT_THAT(r.warnings, testing::Contains(testing::AllOf(
                              HasSubstr("not settled within"), HasSubstr("for a tolerance of 0.0001"),
                              HasSubstr("no static state"))));
}

// A body whose load still grows has not settled, however slow its motion.
TEST(Settling, ABodyIsNotAtRestBeforeItsLoadIs) {
  const RunResult r = run_scene(
      settling_beam("damping", "tolerance = 0.05\n", "60 ms", "history = {ramp = \"40 ms\"}\n"),
      method_named("fem-full"), {0.05, {}}, {});
  EXPECT_TRUE(r.settled);
  EXPECT_GE(r.history["time"].values.back(), 0.04 - 1e-9);
  EXPECT_NEAR(last(r, "support_root_force_y"), 1000, 1000 * 0.05);
}

}  // namespace
}  // namespace femsph::compare
