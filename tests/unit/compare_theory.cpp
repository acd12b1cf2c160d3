// Theory values of the two bodies of the paper. Steel: E = 210 GPa, nu = 0.3, rho = 7850 kg/m^3.

#include <gmock/gmock.h>

#include "compare/reference/theory.hpp"
#include "compare/reference/values/cantilever.hpp"
#include "compare_support.hpp"
#include "model/scene/shapes/box.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;
using namespace test;

double value(const std::string& name, const Scene& scene, Point at = {}, double time = 0) {
  return theory_named(name).value(scene, at, time);
}

// 1.5 kN over 0.01 m^2 = 0.15 MPa; u = 0.15e6/2.1e11 * 0.3 m = 2.1429e-7 m; c = sqrt(E/rho) = 5172.2 m/s, 4
// L/c = 232.01 us.
TEST(Theory, Bar) {
  const Scene scene = bar();
  EXPECT_DOUBLE_EQ(value("bar_stress", scene), -0.15e6);
  EXPECT_NEAR(value("bar_displacement", scene), -2.142857e-7, 1e-12);
  EXPECT_NEAR(value("bar_displacement_at", scene, {0.15, 0.05, 0}), -1.0714286e-7, 1e-12);
  EXPECT_NEAR(value("bar_period", scene), 232.01e-6, 0.005e-6);
  EXPECT_NEAR(value("bar_peak", scene), 2 * value("bar_displacement", scene), 1e-15);
}

// The end swings on a triangle; the middle is reached after L/2c, doubled after 3L/2c, empty again after
// 7L/2c.
TEST(Theory, WaveInABar) {
  const Scene scene = bar();
  const double period = value("bar_period", scene), stress = value("bar_stress", scene);
  EXPECT_NEAR(
      value("bar_displacement_history", scene, {}, period / 4), value("bar_displacement", scene), 1e-18);
  EXPECT_NEAR(value("bar_displacement_history", scene, {}, period), 0, 1e-18);
  const Point middle{0.15, 0.05, 0};
  const double level[] = {0, 1, 1, 2, 2, 1, 1, 0};  // in eighths of the period
  for (int k = 0; k < 8; ++k)
    EXPECT_EQ(value("bar_stress_history", scene, middle, (k + 0.5) * period / 8), level[k] * stress) << k;
}

// I = 0.1^4/12 m^4: P L^3/(3 E I) = 4.7619 mm; shear adds P L/(5/6 G A) = 0.0371 mm; sigma at the root M y/I
// = 150 MPa, tension above.
TEST(Theory, Cantilever) {
  const Scene scene = cantilever();
  EXPECT_NEAR(value("cantilever_tip", scene), -4.7619e-3, 1e-7);
  EXPECT_NEAR(value("cantilever_tip_timoshenko", scene), -4.7990e-3, 1e-7);
  EXPECT_NEAR(value("cantilever_deflection", scene, {1, 0.05, 0}), value("cantilever_tip", scene), 1e-15);
  EXPECT_NEAR(value("cantilever_stress", scene, {0, 0.1, 0}), 150e6, 1);
  EXPECT_NEAR(value("cantilever_stress", scene, {0.1, 0, 0}), -135e6, 1);
  EXPECT_NEAR(value("cantilever_strain", scene, {0, 0.1, 0}), 150e6 / 2.1e11, 1e-12);
  EXPECT_NEAR(value("cantilever_frequency", scene), 83.552, 5e-4);
  EXPECT_NEAR(cantilever_eigenvalue(1), 1.8751040687, 1e-9);
  EXPECT_NEAR(cantilever_eigenvalue(2), 4.6940911330, 1e-9);
}

// Over 50 ms, four periods: nearly twice the static deflection at the tip, 2.40 P L at the root.
TEST(Theory, StepResponseOfTheCantilever) {
  const Scene scene = cantilever();
  EXPECT_NEAR(value("cantilever_tip_peak", scene) / value("cantilever_tip", scene), 1.996, 1e-3);
  EXPECT_NEAR(value("cantilever_root_moment_peak", scene) / (-25e3 * 1.0), 2.40, 0.01);
  // Twelve over the sum of beta^4 is 1: the mean of the motion is the static deflection.
  double mean = 0;
  const double period = 1 / value("cantilever_frequency", scene);
  for (int i = 0; i < 1000; ++i)
    mean += value("cantilever_tip_history", scene, {}, (i + 0.5) * period / 1000) / 1000;
  EXPECT_NEAR(mean / value("cantilever_tip", scene), 1, 0.002);
}

// The depths and loads of the 3D cases are chosen for 0.5143 mm each.
TEST(Theory, ShortCantileverIn3D) {
  for (const auto& [depth, load] : {std::pair{0.025, 25e3}, {0.0125, 12.5e3}, {0.005, 5e3}})
    EXPECT_NEAR(value("cantilever_tip", steel_box(0.3, 0.1, {0, -load, 0}, depth)), -0.5143e-3, 1e-7);
}

// The strain across the width is held: E/(1 - nu^2) stands for E in bending, stretching and vibration; stress
// is statics alone.
TEST(Theory, PlaneStrain) {
  Scene scene = cantilever();
  const double tip = value("cantilever_tip", scene), stress = value("cantilever_stress", scene, {0, 0.1, 0});
  scene.plane = Plane::strain;
  EXPECT_NEAR(value("cantilever_tip", scene) / tip, 0.91, 1e-12);
  EXPECT_DOUBLE_EQ(value("cantilever_stress", scene, {0, 0.1, 0}), stress);
}

TEST(Theory, OriginMovesWithTheBody) {
  Scene scene = cantilever();
  scene.bodies[0].shape = std::make_shared<Box>(2, Point{1, -0.05, 0}, Point{1, 0.1, 0});
  EXPECT_NEAR(value("cantilever_stress", scene, {1, 0.05, 0}), 150e6, 1);
}

TEST(Theory, RefusesOtherScenes) {
  EXPECT_THAT(message_of([] { value("bar_stress", cantilever()); }), HasSubstr("not along x"));
  EXPECT_THAT(message_of([] { value("cantilever_tip", bar()); }), HasSubstr("not along y"));
  Scene scene = cantilever();
  scene.loads[0].place.sides = {"y+"};
  EXPECT_THAT(message_of([&] { value("cantilever_tip", scene); }), HasSubstr("a load is not on x+"));
  scene = cantilever();
  scene.loads[0].history = {{0, 0.01}, {0, 1}};
  EXPECT_NO_THROW(value("cantilever_tip", scene));
  EXPECT_THAT(message_of([&] { value("cantilever_tip_peak", scene); }), HasSubstr("not a step"));
  scene = cantilever();
  scene.bodies.push_back(scene.bodies[0]);
  EXPECT_THAT(message_of([&] { value("cantilever_tip", scene); }), HasSubstr("2 bodies"));
  scene = cantilever();
  scene.supports[0].fixed[0] = false;
  EXPECT_THAT(message_of([&] { value("cantilever_tip", scene); }), HasSubstr("not held along x"));
  scene = cantilever();
  scene.gravity = Point{0, -9.81, 0};
  EXPECT_THAT(message_of([&] { value("cantilever_tip", scene); }), HasSubstr("gravity"));
}

TEST(Theory, LookupSuggestsNames) {
  EXPECT_THAT(
      message_of([] { theory_named("cantilever_tipp"); }), HasSubstr("did you mean \"cantilever_tip\"?"));
}

}  // namespace
}  // namespace femsph::compare
