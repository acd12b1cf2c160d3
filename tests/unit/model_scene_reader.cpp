// A valid scene is read as it is written, in SI.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/reader.hpp"
#include "model_faults.hpp"

using namespace femsph;
using testing::ElementsAre;

namespace {

using test::scenes_folder;

Scene cantilever() { return read_scene(scenes_folder + "cantilever.toml"); }

}  // namespace

TEST(SceneReader, ModelMaterialAndBody) {
  const Scene scene = cantilever();
  EXPECT_EQ(scene.title, "Cantilever, 25 kN on the tip's top edge");
  EXPECT_EQ(scene.plane, Plane::stress);
  EXPECT_EQ(scene.dim(), 2);
  EXPECT_TRUE(scene.large_motion);
  ASSERT_EQ(scene.bodies.size(), 1u);
  const Body& beam = scene.bodies[0];
  EXPECT_EQ(beam.name, "beam");
  EXPECT_DOUBLE_EQ(beam.thickness, 0.1);
  EXPECT_DOUBLE_EQ(beam.shape->lower()[1], -0.05);
  EXPECT_DOUBLE_EQ(beam.shape->upper()[1], 0.05);
  EXPECT_DOUBLE_EQ(beam.shape->measure(), 0.1);
  EXPECT_EQ(beam.shape->describe(), "box 1000 x 100 mm");
  const Material& steel = scene.material_of(beam);
  EXPECT_EQ(steel.name, "steel");
  EXPECT_DOUBLE_EQ(steel.young, 210e9);
  EXPECT_DOUBLE_EQ(steel.poisson, 0.3);
  EXPECT_DOUBLE_EQ(steel.density, 7850);
  EXPECT_DOUBLE_EQ(std::get<LinearElastic>(steel.law(scene.plane)).mu, 210e9 / 2.6);
}

TEST(SceneReader, SupportsAndLoads) {
  const Scene scene = cantilever();
  ASSERT_EQ(scene.supports.size(), 2u);
  EXPECT_THAT(scene.supports[0].place.sides, ElementsAre("x-"));
  EXPECT_THAT(scene.supports[0].fixed, ElementsAre(true, true, false));
  EXPECT_EQ(scene.supports[0].place.source.line, 23);
  ASSERT_TRUE(scene.supports[1].place.point);
  EXPECT_THAT(*scene.supports[1].place.point, ElementsAre(1, 0, 0));
  EXPECT_THAT(scene.supports[1].fixed, ElementsAre(false, true, false));
  ASSERT_EQ(scene.loads.size(), 3u);
  EXPECT_THAT(scene.loads[0].place.sides, ElementsAre("x+", "y+"));
  EXPECT_THAT(scene.loads[0].force, ElementsAre(0, -25e3, 0));
  EXPECT_EQ(scene.loads[0].history.at(0), 1.0);
  EXPECT_DOUBLE_EQ(scene.loads[1].history.at(0.004), 0.4);
  EXPECT_TRUE(scene.loads[2].place.sides.empty());
  EXPECT_DOUBLE_EQ(scene.loads[2].history.at(0.002), -0.25);
}

TEST(SceneReader, WhatIsObserved) {
  const Scene scene = cantilever();
  ASSERT_EQ(scene.probes.size(), 1u);
  EXPECT_EQ(scene.probes[0].name, "tip");
  EXPECT_EQ(scene.probes[0].quantity, quantity_named("displacement"));
  EXPECT_THAT(scene.probes[0].point, ElementsAre(1, 0.05, 0));
  ASSERT_EQ(scene.sections.size(), 1u);
  EXPECT_EQ(scene.sections[0].quantity, quantity_named("stress"));
  EXPECT_EQ(scene.sections[0].count, 21);
  EXPECT_DOUBLE_EQ(scene.duration, 0.05);
  EXPECT_EQ(scene.samples, 200);
  EXPECT_EQ(scene.snapshots, 10);
}

TEST(SceneReader, EffectsAreThoseAskedFor) {
  const Scene scene = cantilever();
  EXPECT_THAT(*scene.gravity, ElementsAre(0, -9.81, 0));
  EXPECT_DOUBLE_EQ(*scene.damping, 100);
  EXPECT_THAT(scene.initial_velocities.at(0).velocity, ElementsAre(1, 0, 0));
  ASSERT_TRUE(scene.settling);
  EXPECT_DOUBLE_EQ(scene.settling->tolerance, 1e-3);
  EXPECT_DOUBLE_EQ(*scene.settling->rate, 1050);
  EXPECT_THAT(effects_on(scene), ElementsAre("finite rotation", "supports", "loads", "initial velocity",
                                             "gravity", "damping", "settling by damping"));
  EXPECT_THAT(effects_on(Scene{}), ElementsAre());
}

TEST(SceneReader, ThreeDimensions) {
  const Scene scene = parse_scene(R"(
[model]
plane = "none"
[materials.rubber]
law = "elastic"
young = "1 MPa"
poisson = 0.4
density = "1 t/m^3"
[bodies.upper]
shape = "mesh"
file = "two_hexes.msh"
unit = "cm"
material = "rubber"
[bodies.lower]
shape = "box"
size = ["1 m", "2 m", "3 m"]
material = "rubber"
[[supports]]
body = "upper"
at = "clamp z-"
fix = ["z"]
[[supports]]
body = "lower"
at = "x+ y- z+"
fix = ["x"]
[time]
duration = "1 s"
)",
                                  scenes_folder + "in_memory.toml");
  EXPECT_EQ(scene.dim(), 3);
  EXPECT_EQ(scene.bodies.at(0).name, "upper") << "bodies keep the order of the file";
  EXPECT_NE(scene.bodies[0].shape->cells(), nullptr);
  EXPECT_DOUBLE_EQ(scene.bodies[0].shape->upper()[0], 0.025);
  EXPECT_EQ(scene.bodies[0].thickness, 1.0);
  EXPECT_DOUBLE_EQ(scene.bodies.at(1).shape->measure(), 6);
  EXPECT_EQ(scene.supports.at(1).place.body, 1u);
}

TEST(TimeHistory, IsLinearBetweenItsPointsAndConstantBeyond) {
  const TimeHistory history{{1, 2, 4}, {0, 1, -1}};
  EXPECT_EQ(history.at(0), 0);
  EXPECT_EQ(history.at(1), 0);
  EXPECT_DOUBLE_EQ(history.at(1.25), 0.25);
  EXPECT_EQ(history.at(2), 1);
  EXPECT_DOUBLE_EQ(history.at(3), 0);
  EXPECT_EQ(history.at(9), -1);
  EXPECT_EQ(TimeHistory{}.at(0), 1) << "a step acts from the first instant";
}
