// Bodies by different methods that meet: FEM on SPH, and SPH on FEM.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "model/results/recorder.hpp"
#include "momentum.hpp"
#include "support.hpp"

namespace femsph::test {
namespace {

/// A quarter of a steel ball of 10 mm radius.
std::string ball(const char* name, const char* centre) {
  const std::string body = scene_text::of_body(name);
  return fmt::format(
             "[bodies.{}]\nshape = \"ball\"\ncentre = {}\nradius = \"10 mm\"\npart = \"quarter\"\n"
             "material = \"steel\"\n",
             name, scene_text::list(centre)) +
         "[[symmetry]]\nat = \"x-\"\n" + body + "[[symmetry]]\nat = \"y-\"\n" + body;
}

struct Impact {
  double force = 0, time = 0, impulse = 0, approach = 0;  ///< over the exact ones
  double momentum = 0, energy = 0;                        ///< changes over the run, relative to the start
};

Scene colliding_balls() {
  using namespace scene_text;
  return parse_scene(
      model("none") + steel() + ball("lower", "0 0 -10 mm") + ball("upper", "0 0 10 mm") +
          contact("upper", "lower", named("blow") + "stiffness = 3\n") +
          initial("0 0 -60 m/s", of_body("upper")) +
          probe("upper", "displacement", "0 0 10 mm", of_body("upper")) +
          probe("lower", "displacement", "0 0 -10 mm", of_body("lower")) + time("32 us", "samples = 200\n"),
      "balls.toml");
}

/// Compares with theory what the history of the balls says.
Impact read_impact(const History& history) {
  const auto &t = history["time"].values, &f = history["contact_blow_force_z"].values,
             &upper = history["upper_z"].values, &lower = history["lower_z"].values;
  Impact hit;
  for (std::size_t k = 1; k < t.size(); ++k) {
    hit.force = std::max(hit.force, std::abs(f[k]) / 34202.1);
    hit.approach = std::max(hit.approach, (lower[k] - upper[k]) / (2 * 270.394e-6));
    hit.impulse += 0.5 * (t[k] - t[k - 1]) * std::abs(f[k] + f[k - 1]) / 0.493230;
    if (f[k] != 0 || f[k - 1] != 0) hit.time += (t[k] - t[k - 1]) / 26.53e-6;
  }
  return hit;
}

Impact collide_balls(const std::string& text) {
  const Scene scene = colliding_balls();
  const compare::BodyMethods methods = compare::read_body_methods(text, &scene);
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < 2; ++b) bodies.push_back(compare::discretize(scene, b, methods, {1e-3, {}}));
  March march(scene, std::move(bodies), {});
  Recorder recorder(march);
  std::optional<double> start;
  double momentum_change = 0, energy_change = 0;
  MarchEvents events;
  events.sample = [&](const March& m) {
    recorder.sample(m);
    const double now = test::momentum(m).linear[2];
    if (!start) start = now;
    momentum_change = std::max(momentum_change, std::abs(now / *start - 1));
    const Ledger ledger = m.ledger();
    energy_change = std::max(energy_change, std::abs(ledger.imbalance()) / ledger.initial);
  };
  march.run(events);
  Impact hit = read_impact(recorder.history());
  hit.momentum = momentum_change, hit.energy = energy_change;
  fmt::print(
      "{}: force {:.4f}, time {:.4f}, impulse {:.4f}, approach {:.4f}, momentum {:.1e}, energy {:.1e}\n",
      text, hit.force, hit.time, hit.impulse, hit.approach, hit.momentum, hit.energy);
  return hit;
}

// Hertz: two equal balls meet at 60 m/s. By symmetry each meets a rigid plane at 30 m/s: force 34.202 kN on a
// quarter, for 26.53 us, approach of the centres 2 x 270.39 um (Johnson, Contact Mechanics, 11.4; as in
// studies/exact/hertz-30.toml). The ball at rest takes the momentum of the other, m / 4 x 60 m/s with m =
// 32.882 g: 0.49323 N s. The penalty (stiffness 3) adds to the approach, and cells of 1 mm are coarse for a
// contact of 1.6 mm radius: FEM alone has 7 % more force, SPH alone 6 %. There the bodies mirror each other,
// so that points meet points; in a mixed pair they meet facets.
TEST(BodyMethods, HertzBetweenCellsAndParticles) {
  const Impact fem = collide_balls("fem-assumed-strain"), sph = collide_balls("sph-corrected");
  for (const char* methods :
       {"upper=fem-assumed-strain,lower=sph-corrected", "upper=sph-corrected,lower=fem-assumed-strain"}) {
    const Impact hit = collide_balls(methods);
    const auto expect_between = [&](double Impact::*value, double slack) {
      EXPECT_GT(hit.*value, std::min(fem.*value, sph.*value) - slack) << methods;
      EXPECT_LT(hit.*value, std::max(fem.*value, sph.*value) + slack) << methods;
    };
    expect_between(&Impact::force, 0.03);
    expect_between(&Impact::time, 0.01);
    expect_between(&Impact::impulse, 0.001);
    expect_between(&Impact::approach, 0.01);
    EXPECT_NEAR(hit.force, 1, 0.06) << methods;
    EXPECT_NEAR(hit.time, 1, 0.03) << methods;
    EXPECT_NEAR(hit.impulse, 1, 0.01) << methods;
    EXPECT_NEAR(hit.approach, 1, 0.05) << methods;
    EXPECT_LT(hit.momentum, 1e-9) << methods;
    EXPECT_LT(hit.energy, 0.005) << methods;
  }
}

// The blocks of studies/two-blocks: plastic, one on the floor. Displacement of the upper block, strain inside
// the lower one.
TEST(BodyMethods, BlockOnBlockLiesBetweenTheTwoMethods) {
  const Scene scene = read_scene(FEMSPH_SOURCE_DIR "/studies/two-blocks/scene.toml");
  const auto fem = run(scene, "fem-full", 2.5), sph = run(scene, "sph-corrected", 2.5);
  for (const char* methods : {"A=fem-full,B=sph-corrected", "A=sph-corrected,B=fem-full"}) {
    const auto r = run(scene, methods, 2.5);
    for (const char* column : {"A_y", "inside_yy"}) {
      const double a = last(fem, column), b = last(sph, column), mixed = last(r, column);
      fmt::print("{} {}: {:.5g} between {:.5g} (fem) and {:.5g} (sph)\n", methods, column, mixed, a, b);
      EXPECT_GT(mixed, std::min(a, b) - 0.005 * std::abs(a)) << methods << " " << column;
      EXPECT_LT(mixed, std::max(a, b) + 0.005 * std::abs(a)) << methods << " " << column;
    }
    fmt::print("{}: balance {:.1e}, imbalance {:.1e} of {:.4g} J\n", methods, r.balance.force,
               r.ledger.imbalance(), r.ledger.initial);
    EXPECT_LT(r.balance.force, 1e-9) << methods;
    EXPECT_LT(std::abs(r.ledger.imbalance()), 0.005 * r.ledger.initial) << methods;
  }
}

}  // namespace
}  // namespace femsph::test
