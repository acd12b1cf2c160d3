// Plasticity in motion: energy, and the elastic-plastic wave of uniaxial strain, whose speeds and plateaus
// are known.

#include <gtest/gtest.h>

#include "support.hpp"

namespace femsph::test {
namespace {

using scene_text::time;

/// Steel 200 x 8 mm in plane strain that flies at `speed` (m/s) onto a smooth wall at its end x-; `law` adds
/// to the material, `end` is the [time] table.
Scene impact(const std::string& law, const std::string& sides, double speed, const std::string& end) {
  using namespace scene_text;
  return parse_scene(
      model("strain") + plastic_steel(law) + box("bar", "200 8 mm", thick("100 mm")) + support("x-", "x") +
          sides + initial(fmt::format("{} 0 m/s", -speed)) + probe("near", "stress", "40 4 mm") +
          probe("far", "stress", "150 4 mm") + probe("yielded", "plastic_strain", "40 4 mm") + end,
      "impact.toml");
}

/// Uniaxial strain.
const std::string held = scene_text::support("all", "y");

/// The rules of plasticity beside von Mises with return mapping, as lines of a material.
const char* const rules[] = {
    "", "tension = \"sign\"\ntensile_strength = \"30 MPa\"\n",
    "tension = \"principal\"\ntensile_strength = \"30 MPa\"\n", "integration = \"no-return-8\"\n"};

// The stress works on the strain by the same trapezoid as the forces on the points, so stored energy and
// plastic work account for all of it, to round-off, under every rule. (The bar is free to bulge.)
TEST(Plastic, EnergyBalancesUnderEveryRule) {
  const std::string end = time("60 us");
  for (const char* method :
       {"fem-full", "fem-sri", "fem-assumed-strain", "sph-classic-full", "sph-virtual", "sph-corrected"})
    for (const char* law : rules) {
      const auto r = run(impact(law, "", 20, end), method, 4);
      EXPECT_LT(std::abs(r.ledger.imbalance()), 1e-9 * r.ledger.initial) << method << " " << law;
      EXPECT_GT(r.ledger.plastic, 0.05 * r.ledger.initial) << method << " " << law;
      EXPECT_EQ(r.history["plastic_work"].values.back(), r.ledger.plastic);
    }
}

// What plastic flow takes of fem-one-point's stabilization is counted with the bending at the end of the step
// (one_point.hpp): that is of the first order in the step, so a quarter of the step leaves a quarter of the
// imbalance and what is of higher order, a third at most. Under the sign rule, whose strength jumps where a
// strain changes its sign, the step also decides when that is: no order there. 2e-4 is measured (1.3e-4 at
// most), not derived.
TEST(Plastic, EnergyOfSoftenedStabilizationIsOfFirstOrder) {
  for (const char* law : rules) {
    const Scene scene = impact(law, "", 20, time("60 us"));
    const auto imbalance = [&](double safety) {
      compare::RunOptions options;
      options.march.safety = safety;
      const auto r = compare::run_scene(scene, compare::method_named("fem-one-point"), {4e-3}, options);
      EXPECT_GT(r.ledger.plastic, 0.05 * r.ledger.initial) << law;
      EXPECT_EQ(r.history["plastic_work"].values.back(), r.ledger.plastic);
      return std::abs(r.ledger.imbalance()) / r.ledger.initial;
    };
    const double coarse = imbalance(0.9), fine = imbalance(0.225);
    EXPECT_LT(coarse, 2e-4) << law;
    EXPECT_LT(fine, std::string_view(law).find("\"sign\"") == std::string_view::npos ? coarse / 3 : 2e-4)
        << law;
  }
}

// Uniaxial strain (Rakhmatulin; von Karman & Duwez): an elastic wave of speed sqrt((K + 4G/3)/rho) = 6001 m/s
// brings the elastic limit sigma_y (1 - nu)/(1 - 2 nu) = 525 MPa, a plastic wave of speed sqrt((K + 4/3 G
// H/(3G + H))/rho) = 4734 m/s the rest: sigma = 525 MPa + rho c_p (v - 525 MPa/(rho c_e)) = 854 MPa at v = 20
// m/s. Ahead of the return from the free end, at 33 us and x = 200 mm.
TEST(Plastic, TwoWavesOfUniaxialStrain) {
  const double E = 210e9, rho = 7850, G = E / 2.6, K = E / 1.2, H = E / 99, v = 20;
  const double elastic = std::sqrt((K + 4 * G / 3) / rho),
               plastic = std::sqrt((K + 4 * G * H / (3 * (3 * G + H))) / rho);
  const double limit = 300e6 * 0.7 / 0.4, top = limit + rho * plastic * (v - limit / (rho * elastic));
  EXPECT_NEAR(elastic, 6001, 1);
  EXPECT_NEAR(plastic, 4734, 1);
  EXPECT_NEAR(top, 854e6, 1e6);
  // Particles need half the spacing of cells: the mean dilatation makes short waves slower.
  for (const auto& [method, spacing] :
       {std::pair("fem-full", 1.0), {"fem-one-point", 1.0}, {"sph-corrected", 0.5}}) {
    const auto r = run(impact("", held, v, time("33 us", "samples = 2000\n")), method, spacing);
    // between the plastic front's passage at 40 mm (8.4 us) and the end, and between the two fronts at 150 mm
    // (25.0 and 31.7 us)
    EXPECT_NEAR(mean(r, "near_xx", 12e-6, 33e-6), -top, 0.01 * top) << method;
    EXPECT_NEAR(mean(r, "far_xx", 26.5e-6, 30.5e-6), -limit, 0.03 * limit) << method;
    EXPECT_NEAR(mean(r, "yielded_equivalent", 12e-6, 33e-6),
                (top - limit) / (rho * plastic * plastic) * 2 * G / (3 * G + H), 0.08e-3)
        << method << ": 1.24e-3, and what the ringing behind the front adds for good";
  }
}

}  // namespace
}  // namespace femsph::test
