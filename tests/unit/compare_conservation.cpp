// Drifts of momentum and energy, on runs for which they are known.

#include <gtest/gtest.h>

#include <cmath>

#include "compare/run/run.hpp"
#include "compare_support.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph::compare {
namespace {

using namespace scene_text;

/// A plate of rubber, and the tables after it.
RunResult run(const std::string& rest, const char* method, const char* motion) {
  const Scene scene = parse_scene(
      model("strain", fmt::format("motion = \"{}\"\n", motion)) +
          material("m", "elastic", "17 MPa", "0.3", "1100 kg/m^3") +
          box("plate", "1 0.5 m", thick("1 m"), "m") + rest,
      "drift.toml");
  RunOptions options;
  options.scalars = {"energy_drift"};
  return run_scene(scene, method_named(method), {0.125, {}}, options);
}

const std::string spin =
    "[[initial]]\nspin = \"20 rad/s\"\nvelocity = [\"5 m/s\", \"0 m/s\"]\n[time]\nduration = \"0.1 "
    "s\"\nsamples = 50\n";
const std::string bend =
    "[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[[initial]]\ngradient = [[\"0 1/s\", \"0 1/s\"], [\"1 "
    "1/s\", \"0 1/s\"]]\n[time]\nduration = \"0.05 s\"\nsamples = 50\n";

// A free plate that flies and turns keeps linear and angular momentum to round-off if its internal forces are
// central pairs.
TEST(Conservation, AFreeBodyKeepsItsMomenta) {
  for (const char* method : {"fem-full", "fem-one-point", "fem-assumed-strain", "sph-corrected"}) {
    const auto s = run(spin, method, "large").scalars;
    EXPECT_LT(s.at("momentum_drift"), 1e-12) << method;
    EXPECT_LT(s.at("angular_momentum_drift"), 1e-12) << method;
    EXPECT_LT(s.at("energy_drift"), 0.01) << method;
    EXPECT_GT(s.at("energy_drift"), 0) << method;
  }
}

// The uncorrected gradient gives opposite pairs too, but not along the line that joins their points.
TEST(Conservation, SeesTheAngularMomentumThatClassicSphLoses) {
  const auto s = run(spin, "sph-classic-share", "large").scalars;
  EXPECT_LT(s.at("momentum_drift"), 1e-12);
  EXPECT_GT(s.at("angular_momentum_drift"), 1e-6);
}

// The momentum of a held body changes. Its drift is that of the sum of the internal forces, which must be
// zero.
TEST(Conservation, OfAHeldBodyTheInternalForcesAddUpToZero) {
  for (const char* method : {"fem-full", "sph-corrected"}) {
    const auto s = run(bend, method, "small").scalars;
    EXPECT_LT(s.at("momentum_drift"), 1e-11) << method;
    EXPECT_LT(s.at("angular_momentum_drift"), 1e-11) << method;
  }
}

TEST(Conservation, HourglassShareIsOfTheInternalEnergy) {
  EXPECT_EQ(run(bend, "fem-full", "small").scalars.at("hourglass_share"), 0);
  const RunResult r = run(bend, "fem-one-point", "small");
  double hourglass = 0, internal = 0;
  for (std::size_t i = 0; i < r.history.rows(); ++i) {
    hourglass = std::max(hourglass, r.history["hourglass_energy"].values[i]);
    internal = std::max(
        internal, r.history["hourglass_energy"].values[i] + r.history["strain_energy"].values[i]);
  }
  EXPECT_GT(hourglass, 0);
  EXPECT_NEAR(r.scalars.at("hourglass_share"), hourglass / internal, 1e-12);
}

}  // namespace
}  // namespace femsph::compare
