// The reaction of a named support: of a settled body it balances the loads, force and moment, by every
// method.

#include <gtest/gtest.h>

#include "compare/run/run.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {
namespace {

Scene cantilever(const char* more) {
  return parse_scene(std::string(R"(
[model]
plane = "stress"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
[bodies.beam]
shape = "box"
size = ["40 mm", "10 mm"]
thickness = "10 mm"
material = "steel"
[[supports]]
at = "x-"
fix = ["x", "y"]
)") + more + R"(
[[loads]]
at = "x+"
force = ["300 N", "-100 N"]
[settling]
method = "damping"
tolerance = 1e-7
[time]
duration = "100 ms"
samples = 10
)",
                     "cantilever.toml");
}

TEST(Reaction, OfASettledBodyItBalancesTheLoads) {
  for (const char* method : {"fem-full", "fem-one-point", "fem-assumed-strain", "sph-corrected"}) {
    const RunResult r = run_scene(cantilever("name = \"root\"\n"), method_named(method), {0.0025, {}}, {});
    ASSERT_TRUE(r.settled) << method;
    const auto last = [&](const char* column) { return r.history[column].values.back(); };
    EXPECT_NEAR(last("support_root_force_x"), -300, 1e-3) << method;
    EXPECT_NEAR(last("support_root_force_y"), 100, 1e-3) << method;
    // Equilibrium about the middle of the root: M = P L, as the loads are where they were put.
    EXPECT_NEAR(last("support_root_moment_z"), 100 * 0.04, 2e-3 * 4) << method;
  }
}

TEST(Reaction, IsThereOnlyIfAskedFor) {
  const RunResult r = run_scene(cantilever(""), method_named("fem-full"), {0.005, {}}, {});
  for (const Column& column : r.history.columns)
    EXPECT_EQ(column.name.find("support_"), std::string::npos) << column.name;
}

}  // namespace
}  // namespace femsph::compare
