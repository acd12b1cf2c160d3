// Bodies by different methods that meet: FEM on SPH, and SPH on FEM.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

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
  double force = 0, time = 0, impulse = 0;  ///< over the exact ones
  double momentum = 0, energy = 0;          ///< changes over the run, relative to the start
};

/// Hertz: two equal balls meet at 60 m/s. By symmetry each meets a rigid plane at 30 m/s. With E* = E / (1 -
/// nu^2), m = 32.882 g: force 34.202 kN on a quarter, for 26.53 us (Johnson, Contact Mechanics, 11.4; as
/// studies/exact/hertz-30.toml); the ball at rest takes the momentum of the other, m / 4 x 60 m/s = 0.49323 N
/// s.
Impact collide_balls(const std::string& text) {
  using namespace scene_text;
  const Scene scene = parse_scene(
      model("none") + steel() + ball("lower", "0 0 -10 mm") + ball("upper", "0 0 10 mm") +
          contact("upper", "lower", named("blow") + "stiffness = 10\n") +
          initial("0 0 -60 m/s", of_body("upper")) + time("34 us", "samples = 600\n"),
      "balls.toml");
  const compare::BodyMethods methods = compare::read_body_methods(text, &scene);
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < 2; ++b) bodies.push_back(compare::discretize(scene, b, methods, {1e-3, {}}));
  March march(scene, std::move(bodies), {});
  Impact hit;
  std::optional<double> start;
  MarchEvents events;
  double before = 0, time_before = 0;
  events.sample = [&](const March& m) {
    const double now = momentum(m).linear[2];
    if (!start) start = now;
    hit.momentum = std::max(hit.momentum, std::abs(now / *start - 1));
    hit.energy = std::max(hit.energy, std::abs(m.ledger().imbalance()) / m.ledger().initial);
    std::vector<Point> forces(1);
    for (const Effect* effect : m.effects().all()) effect->contact_forces(forces);
    const double force = std::abs(forces[0][2]);
    hit.force = std::max(hit.force, force / 34202.1);
    hit.impulse += 0.5 * (force + before) * (m.time() - time_before) / 0.493230;
    if (force > 0 || before > 0) hit.time += (m.time() - time_before) / 26.53e-6;
    before = force, time_before = m.time();
  };
  march.run(events);
  fmt::print("{}: force {:.4f}, time {:.4f}, impulse {:.4f}, momentum {:.1e}, energy {:.1e}\n", text,
             hit.force, hit.time, hit.impulse, hit.momentum, hit.energy);
  return hit;
}

TEST(BodyMethods, HertzBetweenCellsAndParticles) {
  const Impact fem = collide_balls("fem-assumed-strain"), sph = collide_balls("sph-corrected");
  for (const char* methods :
       {"upper=fem-assumed-strain,lower=sph-corrected", "upper=sph-corrected,lower=fem-assumed-strain"}) {
    const Impact hit = collide_balls(methods);
    const auto expect_between = [&](double Impact::*value, double slack) {
      EXPECT_GT(hit.*value, std::min(fem.*value, sph.*value) - slack) << methods;
      EXPECT_LT(hit.*value, std::max(fem.*value, sph.*value) + slack) << methods;
    };
    expect_between(&Impact::force, 0.01);
    expect_between(&Impact::time, 0.01);
    EXPECT_NEAR(hit.time, 1, 0.03) << methods;
    EXPECT_NEAR(hit.impulse, 1, 0.02) << methods;
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
      EXPECT_GT(mixed, std::min(a, b) - 0.02 * std::abs(a)) << methods << " " << column;
      EXPECT_LT(mixed, std::max(a, b) + 0.02 * std::abs(a)) << methods << " " << column;
    }
    fmt::print("{}: balance {:.1e}, imbalance {:.1e} of {:.4g} J\n", methods, r.balance.force,
               r.ledger.imbalance(), r.ledger.initial);
    EXPECT_LT(r.balance.force, 1e-9) << methods;
    EXPECT_LT(std::abs(r.ledger.imbalance()), 0.005 * r.ledger.initial) << methods;
  }
}

}  // namespace
}  // namespace femsph::test
