// Bodies that collide keep momentum, moment of momentum and energy, by both solvers and between the two.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "contact_support.hpp"
#include "model/motion/effects/contact.hpp"
#include "momentum.hpp"

namespace femsph::test {
namespace {

/// Of the bodies "lower" and "upper", alike and unlike.
const char* const like_and_unlike[] = {
    "fem-full", "sph-corrected", "lower=fem-full,upper=sph-corrected", "lower=sph-corrected,upper=fem-full"};

struct Collision {
  double linear = 0, angular = 0, imbalance = 0, initial = 0, friction = 0,
         depth = 0;  ///< changes over the run, relative to the start
  bool touched = false;
};

Collision collide(const Scene& scene, const std::string& method, double spacing_mm) {
  const compare::BodyMethods methods = compare::read_body_methods(method, &scene);
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].rigid)
      bodies.push_back(compare::discretize(scene, b, methods, {spacing_mm * 1e-3, {}}));
  March march(scene, std::move(bodies), {});
  std::optional<Momentum> start;
  Collision hit;
  MarchEvents events;
  events.sample = [&](const March& m) {
    const Momentum now = test::momentum(m);
    if (!start) start = now;
    double p = 0, h = 0, p0 = 0, h0 = 0;
    for (int c = 0; c < 3; ++c) {
      p += std::abs(now.linear[c] - start->linear[c]), p0 += std::abs(start->linear[c]);
      h += std::abs(now.angular[c] - start->angular[c]), h0 += std::abs(start->angular[c]);
    }
    hit.linear = std::max(hit.linear, p / p0);
    hit.angular = std::max(hit.angular, h / h0);
    hit.touched = hit.touched || m.effects().find<ContactOfBodies>()->pairs()[0].touching() > 0;
    const Ledger l = m.ledger();
    hit.imbalance = std::max(hit.imbalance, std::abs(l.imbalance()) / l.initial);
    hit.friction = l.friction / l.initial;
  };
  march.run(events);
  hit.depth = march.effects().find<ContactOfBodies>()->pairs()[0].deepest_share();
  fmt::print(
      "{}: linear {:.1e}, angular {:.1e}, imbalance {:.1e}, friction loss {:.3f}, depth {:.4f} d, step "
      "-{:.1f} %\n",
      method, hit.linear, hit.angular, hit.imbalance, hit.friction, hit.depth,
      100 * (1 - march.critical_step() / march.critical_step_without_contact()));
  return hit;
}

void expect_kept(const Collision& hit, double angular, const char* method) {
  EXPECT_TRUE(hit.touched) << method;
  EXPECT_LT(hit.linear, 1e-12) << method;
  EXPECT_LT(hit.angular, angular) << method;
  EXPECT_LT(hit.imbalance, 0.005) << method;
}

// Two blocks of unequal size meet off centre and turn: what one loses the other gains, with friction too.
// Both discretizations keep momentum and (in large motion) moment of momentum themselves, so the sums of both
// bodies stay put to round-off. Speeds as in the paper's block on block, 20 m/s: strains about 20 / 5300 =
// 0.4 %, so a depth of about 0.4 % / 0.25 of the spacing.
TEST(Contact, CollidingBlocksKeepMomentumAndEnergy) {
  for (const double friction : {0.0, 0.3}) {
    const Scene scene = steel_bodies(
        block("lower", "0 0 mm", "60 30 mm") + block("upper", "37 30.1 mm", "40 40 mm") +
            moving("upper", "-5 -20 m/s") + touching("upper", "lower", friction) + lasting(60e-6),
        "0.3", true);
    for (const char* method : like_and_unlike) {
      const Collision hit = collide(scene, method, 2.5);
      expect_kept(hit, 1e-11, method);
      EXPECT_LT(hit.depth, 0.05) << method;
      if (friction > 0) {
        EXPECT_GT(hit.friction, 0.001) << method;
      }
    }
  }
}

// The same with a rigid disc, which spins after the impact.
TEST(Contact, RigidDiscOnABlockKeepsMomentumAndEnergy) {
  const Scene scene = steel_bodies(
      block("block", "0 0 mm", "60 30 mm") +
          "[bodies.disc]\nshape = \"disc\"\nrigid = true\ncentre = [\"20 mm\", \"50.1 mm\"]\nradius = "
          "\"20 mm\"\nmass = \"0.1 kg\"\n" +
          moving("disc", "3 -5 m/s") + touching("disc", "block", 0.2) + lasting(100e-6),
      "0.3", true);
  for (const char* method : both) {
    const Collision hit = collide(scene, method, 2);
    expect_kept(hit, 1e-11, method);
    EXPECT_GT(hit.friction, 0) << method;
  }
}

// In space: a cube against a larger one, facets of 5 and 4 mm.
TEST(Contact, CollidingCubesKeepMomentumAndEnergy) {
  using namespace scene_text;
  const Scene scene = parse_scene(
      model("none", large_motion) + steel() + box("lower", "40 40 40 mm") +
          box("upper", "37 37 22 mm", origin("12 15 40.05 mm")) + moving("upper", "2 1 -10 m/s") +
          touching("upper", "lower", 0.2) + lasting(40e-6),
      "cubes.toml");
  for (const char* method : like_and_unlike) {
    expect_kept(collide(scene, method, 5), 1e-10, method);
  }
}

}  // namespace
}  // namespace femsph::test
