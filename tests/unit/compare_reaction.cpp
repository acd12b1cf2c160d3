// The reaction of a named support: of a settled body it balances the loads, force and moment, by every
// method.

#include <gtest/gtest.h>

#include "compare/run/run.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph::compare {
namespace {

using namespace scene_text;

/// A short cantilever under a force (300, -100) N at its end; `of_support`: further lines of its support.
Scene reacting_beam(const std::string& of_support) {
  return parse_scene(
      clamped_beam("40 10 mm", "10 mm", "0.3", of_support) + load("x+", "300 -100 N") +
          settling("damping", "tolerance = 1e-7\n") + scene_text::time("100 ms", "samples = 10\n"),
      "cantilever.toml");
}

TEST(Reaction, OfASettledBodyItBalancesTheLoads) {
  for (const char* method : {"fem-full", "fem-one-point", "fem-assumed-strain", "sph-corrected"}) {
    const RunResult r = run_scene(reacting_beam(named("root")), method_named(method), {0.0025, {}}, {});
    ASSERT_TRUE(r.settled) << method;
    const auto last = [&](const char* column) { return r.history[column].values.back(); };
    EXPECT_NEAR(last("support_root_force_x"), -300, 1e-3) << method;
    EXPECT_NEAR(last("support_root_force_y"), 100, 1e-3) << method;
    // Equilibrium about the middle of the root: M = P L, as the loads are where they were put.
    EXPECT_NEAR(last("support_root_moment_z"), 100 * 0.04, 2e-3 * 4) << method;
  }
}

TEST(Reaction, IsThereOnlyIfAskedFor) {
  const RunResult r = run_scene(reacting_beam(""), method_named("fem-full"), {0.005, {}}, {});
  for (const Column& column : r.history.columns)
    EXPECT_EQ(column.name.find("support_"), std::string::npos) << column.name;
}

}  // namespace
}  // namespace femsph::compare
