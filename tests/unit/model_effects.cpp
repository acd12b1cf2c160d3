// The catalogue of effects, the list of effects of a march, and internal forces kept apart from those of
// effects.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "model/motion/effects/effect.hpp"
#include "model/motion/march.hpp"
#include "model/scene/reader/reader.hpp"
#include "model/scene/shapes/box.hpp"
#include "model_grid.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using testing::ElementsAre;

using namespace scene_text;

const std::string plain = model("stress") + material("m", "elastic", "1 Pa", "0", "2 kg/m^3") +
                          box("block", "1 1 m", thick("1 m"), "m") + scene_text::time("1 s");

TEST(Effects, EachStatesItsDescriptionAndItsKey) {
  std::set<std::string> words;
  for (const EffectEntry& effect : effects()) {
    EXPECT_TRUE(words.insert(effect.word).second) << effect.word << " twice";
    EXPECT_FALSE(effect.about.empty()) << effect.word;
    EXPECT_FALSE(effect.asked_by.empty()) << effect.word;
    EXPECT_TRUE(effect.on) << effect.word;
    EXPECT_EQ(effect.read != nullptr, !effect.tables.empty()) << effect.word;
  }
  EXPECT_GE(words.size(), 16u);
}

TEST(Effects, OfAPlainSceneAllAreOff) {
  const Scene scene = parse_scene(plain, "plain.toml");
  EXPECT_THAT(effects_on(scene), ElementsAre());
  EXPECT_THAT(effects_off(scene),
              ElementsAre("finite rotation", "plasticity", "symmetry", "bars", "initial velocity",
                          "initial displacement", "contact", "gravity", "damping", "settling"));
  EXPECT_FALSE(pushed_from_outside(scene));
}

TEST(Effects, WhatIsOnIsNotOff) {
  const Scene scene = parse_scene(
      plain + "[gravity]\nacceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n[settling]\nmethod = \"kinetic\"\n",
      "on.toml");
  EXPECT_THAT(effects_on(scene), ElementsAre("gravity", "settling by kinetic damping"));
  EXPECT_THAT(effects_off(scene),
              ElementsAre("finite rotation", "plasticity", "symmetry", "bars", "initial velocity",
                          "initial displacement", "contact", "damping"));
  EXPECT_TRUE(pushed_from_outside(scene));
}

// Effects from outside change the momentum of all bodies together; initial velocities, contacts and ties do
// not.
TEST(Effects, WhichActFromOutside) {
  std::set<std::string> outside;
  for (const EffectEntry& effect : effects())
    if (effect.outside) outside.insert(effect.word);
  EXPECT_THAT(outside, testing::UnorderedElementsAre("supports", "moved supports", "symmetry", "loads",
                                                     "gravity", "damping", "settling"));
}

/// Overrides two hooks of every step.
struct Two : Effect {
  void push_body(const Motion&, MovingBody&) override {}
  void reaction_work(const Motion&, double&) const override {}
};

TEST(Effects, OnlyOverriddenHooksAreCalled) {
  EXPECT_EQ(made(std::make_unique<Two>()).hooks,
            1u << unsigned(Hook::push_body) | 1u << unsigned(Hook::reaction_work));
}

Scene block() {
  Scene s;
  s.plane = Plane::stress;
  s.materials["m"] = Material{"m", 1, 0, test::Grid::rho};
  s.bodies.push_back({"block", std::make_shared<Box>(2, Point{}, Point{1, 1, 0}), 1, "m"});
  s.duration = 3;
  return s;
}

/// A grid on springs to its neighbour (points 2k and 2k + 1), so that the internal forces add up to zero.
class Sprung : public test::Grid {
 public:
  Sprung() : Grid({}, 1, 1, 3, 3) {}
  void internal_force(const double* u, const double*, double, double* f, double*) override { pull(u, f, -1); }
  void stiffness(const double* x, double* y) const override { pull(x, y, 1); }
  std::vector<Weight> points_of(const Place&) const override {
    return {{0, 0.25}, {1, 0.25}, {2, 0.25}, {3, 0.25}};
  }

 private:
  void pull(const double* u, double* f, double sign) const {
    for (std::size_t i = 0; i < layout().points; i += 2)
      for (int c = 0; c < 2; ++c) {
        const std::size_t a = layout().at(i, c), b = layout().at(i + 1, c);
        f[a] = sign * (u[a] - u[b]);
        f[b] = -f[a];
      }
  }
};

TEST(Effects, AMarchHoldsThoseOfItsScene) {
  Scene scene = block();
  const auto hooks = [&](Hook hook) {
    std::vector<std::unique_ptr<Discretization>> bodies;
    bodies.push_back(std::make_unique<Sprung>());
    return March(scene, std::move(bodies), {}).effects().with(hook).size();
  };
  for (const Hook hook :
       {Hook::push_body, Hook::push_rigid, Hook::push_between, Hook::constrain, Hook::find_reactions,
        Hook::after_kick, Hook::work_on_body, Hook::work_on_rigid, Hook::reaction_work, Hook::add_springs})
    EXPECT_EQ(hooks(hook), 0u) << int(hook);
  scene.gravity = Point{0, -9.81, 0};
  EXPECT_EQ(hooks(Hook::push_body), 1u);
  EXPECT_EQ(hooks(Hook::work_on_body), 1u);
  EXPECT_EQ(hooks(Hook::constrain), 0u);
}

// With gravity on, the forces on the points add up to the weight; the internal forces add up to zero, to
// the last bit, as each is the opposite of another.
TEST(Effects, InternalForcesAreKeptApart) {
  Scene scene = block();
  scene.gravity = Point{0, -9.81, 0};
  InitialVelocity start;
  start.gradient[0][0] = 0.1;
  scene.initial_velocities.push_back(start);
  std::vector<std::unique_ptr<Discretization>> bodies;
  bodies.push_back(std::make_unique<Sprung>());
  March march(scene, std::move(bodies), {});
  MarchEvents events;
  int samples = 0;
  events.sample = [&](const March& m) {
    ++samples;
    EXPECT_EQ(m.force_imbalance(), 0);
    const MovingBody& body = m.bodies()[0];
    double weight = 0, internal = 0;
    for (std::size_t i = 0; i < body.discretization->layout().points; ++i)
      weight += body.f[2 * i + 1], internal += std::abs(body.internal[2 * i]);
    EXPECT_NEAR(weight, -9.81 * test::Grid::rho, 1e-12);
    EXPECT_EQ(internal > 0, m.step() > 0);
  };
  int between = 0;
  events.between = [&](const March& m) { between += m.bodies()[0].internal.empty(); };
  march.run(events);
  EXPECT_GT(samples, 3);
  EXPECT_EQ(between, march.step()) << "kept beyond the sample";
}

// A support that holds a mean starts it at rest, whatever [[initial]] gives its points: constraints act after
// all other effects.
TEST(Effects, AHeldMeanStartsAtRest) {
  Scene scene = block();
  scene.initial_velocities.push_back({0, {0, 3, 0}});
  Support mean;
  mean.fixed[1] = mean.mean = true;
  scene.supports.push_back(mean);
  std::vector<std::unique_ptr<Discretization>> bodies;
  bodies.push_back(std::make_unique<Sprung>());
  March march(scene, std::move(bodies), {});
  MarchEvents events;
  events.sample = [&](const March& m) {
    double held = 0;
    for (std::size_t i = 0; i < 4; ++i) held += 0.25 * m.velocity(m.bodies()[0], 2 * i + 1);
    EXPECT_NEAR(held, 0, 1e-14);
    EXPECT_GT(m.velocity(m.bodies()[0], 2 * 15 + 1), 2.9) << "a free point";
  };
  march.run(events);
}

}  // namespace
}  // namespace femsph
