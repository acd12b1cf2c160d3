// From the command line to a method and a resolution: every number has a range, and an option without effect
// is refused.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "compare/price/advise.hpp"
#include "compare/program/commands.hpp"
#include "compare_support.hpp"
#include "model/scene/shapes/mesh.hpp"

namespace femsph::compare {
namespace {

using namespace test;
using ::testing::HasSubstr;

const double nan = std::numeric_limits<double>::quiet_NaN(),
             infinite = std::numeric_limits<double>::infinity();

RunCommand by(const char* solver) {
  RunCommand c;
  c.solver = solver;
  return c;
}

/// The message of a call; empty if it is accepted.
template <class Call>
std::string complaint(Call&& call) {
  try {
    call();
  } catch (const BadCommand& e) {
    return e.what();
  }
  return "";
}

/// With one member of the command set.
template <class Member, class Value>
std::string of_method(const char* solver, Member member, Value value) {
  RunCommand c = by(solver);
  c.*member = value;
  return complaint([&] { methods_of(c, cantilever()); });
}

/// With one option of the method.
std::string of_method(const char* solver, const char* option, double value) {
  RunCommand c = by(solver);
  c.numbers[option] = value;
  return complaint([&] { methods_of(c, cantilever()); });
}
std::string of_method(const char* solver, const char* option, const char* value) {
  RunCommand c = by(solver);
  c.words[option] = value;
  return complaint([&] { methods_of(c, cantilever()); });
}

/// A scene of one body: a box, or, with cells of its own, one cell.
Scene one_cell() {
  Scene scene = cantilever();
  scene.file = "cell.toml";
  CellMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.cells = {{0, 1, 2, 3}};
  scene.bodies[0].shape = std::make_shared<MeshShape>(mesh, "cell.msh");
  return scene;
}

std::string of_resolution(const Scene& scene, const char* solver, std::optional<std::string> spacing,
                          std::vector<int> divisions) {
  RunCommand c = by(solver);
  c.spacing = spacing;
  c.divisions = divisions;
  return complaint([&] { resolution_of(c, scene, methods_of(c, scene)); });
}

TEST(Command, NumbersOfAMethodHaveRanges) {
  for (const double bad : {nan, infinite, -1.0, 0.0, 0.5, 5.0})
    EXPECT_THAT(of_method("sph", "smoothing", bad), HasSubstr("; expected a number from 0.6 to 4")) << bad;
  EXPECT_EQ(of_method("sph", "smoothing", nan), "--smoothing is nan; expected a number from 0.6 to 4");
  EXPECT_EQ(of_method("sph", "smoothing", 1.2), "");
  for (const char* solver : {"sph", "fem-one-point"}) {
    for (const double bad : {nan, infinite, -0.1, 11.0})
      EXPECT_THAT(of_method(solver, "hourglass", bad), HasSubstr("--hourglass is ")) << bad;
    EXPECT_EQ(of_method(solver, "hourglass", 0.0), "");
  }
  EXPECT_EQ(of_method("sph-classic-share", &RunCommand::viscosity, std::vector<double>{1, -1, 0.01}),
            "--viscosity: beta is -1; expected a number from 0 to 100");
  EXPECT_EQ(of_method("sph-classic-share", &RunCommand::viscosity, std::vector<double>{1, 1, 0}),
            "--viscosity: gamma is 0; expected a number above 0, up to 100");
  EXPECT_EQ(of_method("sph-classic-share", &RunCommand::viscosity, std::vector<double>{1, 1, 0.01}), "");
  EXPECT_EQ(of_method("sph", "kernel", "wendland"),
            "--kernel cannot be \"wendland\"; expected \"cubic-spline\" or \"wendland-c2\"");
  EXPECT_THAT(
      complaint([] { methods_of(by("sph-corected"), cantilever()); }),
      AllOf(HasSubstr("--solver: no method \"sph-corected\""), HasSubstr("did you mean \"sph-corrected\"?")));
}

TEST(Command, SafetyAndThreadsHaveRanges) {
  for (const double bad : {nan, infinite, -1.0, 0.0, 1.0001})
    EXPECT_THAT(complaint([&] { checked_safety(bad); }),
                HasSubstr("; expected a number above 0, up to 1: the step over the critical step"));
  EXPECT_EQ(checked_safety(1), 1);
  for (const int bad : {0, -3, 513})
    EXPECT_EQ(complaint([&] { checked_threads(bad); }),
              fmt::format("--threads is {}; expected a whole number from 1 to 512", bad));
  EXPECT_EQ(checked_threads(512), 512);
}

TEST(Command, AnOptionWithoutEffectIsRefused) {
  EXPECT_EQ(
      of_method("fem", "smoothing", 1.2), "--smoothing does nothing with fem-full: it is an option of SPH");
  EXPECT_EQ(of_method("fem", "mass", "full"), "--mass does nothing with fem-full: it is an option of SPH");
  EXPECT_EQ(
      of_method("fem", "hourglass", 0.1),
      "--hourglass does nothing with fem-full: of the elements, only fem-one-point has an hourglass control");
  EXPECT_EQ(of_method("sph-virtual", "hourglass", 0.1),
            "--hourglass does nothing with sph-virtual: classic SPH has no hourglass control");
  EXPECT_EQ(of_method("sph", &RunCommand::viscosity, std::vector<double>{1, 1, 0.01}),
            "--viscosity does nothing with sph-corrected: it belongs to classic and to updated SPH");
  EXPECT_EQ(of_method("sph", "mass", "full"),
            "");  // the mass of boundary particles is a choice there too
  const Scene cell = one_cell(), box = cantilever();
  EXPECT_EQ(of_resolution(cell, "fem", "10 mm", {}),
            "--spacing does nothing with fem-full: the cells of every deformable body of cell.toml come from "
            "its shape");
  EXPECT_EQ(of_resolution(cell, "fem", {}, {4, 4}),
            "--divisions does nothing with fem-full: the cells of every deformable body of cell.toml come "
            "from its shape");
  EXPECT_EQ(of_resolution(cell, "fem", {}, {}), "");
  EXPECT_EQ(of_resolution(cell, "sph", "10 mm", {}), "");
  Scene both = cell;
  both.bodies.push_back(box.bodies[0]);
  EXPECT_EQ(of_resolution(both, "fem", "10 mm", {}), "");
}

TEST(Command, ResolutionsAreOneAxisANumber) {
  const Scene scene = cantilever();  // 1 m x 0.1 m
  EXPECT_EQ(of_resolution(scene, "fem", {}, {}),
            "no resolution is given; expected a spacing, such as --spacing \"10 mm\"");
  EXPECT_EQ(of_resolution(scene, "fem", "10 mm", {100, 10}),
            "both --spacing and --divisions are given; expected one of them");
  EXPECT_THAT(of_resolution(scene, "fem", "-10 mm", {}), HasSubstr("expected a length above zero"));
  EXPECT_THAT(of_resolution(scene, "fem", "nan mm", {}), HasSubstr("--spacing \"nan mm\""));
  EXPECT_THAT(of_resolution(scene, "fem", {}, {100}),
              HasSubstr("--divisions: 1 number; expected 2, one along each axis of"));
  EXPECT_THAT(
      of_resolution(scene, "fem", {}, {100, 10, 10}), HasSubstr("--divisions: 3 numbers; expected 2"));
  EXPECT_THAT(of_resolution(scene, "fem", {}, {100, 0}),
              HasSubstr("--divisions: 0; expected whole numbers from 1 to 1000000"));
  EXPECT_THAT(
      of_resolution(scene, "fem", {}, {100, -4}), HasSubstr("--divisions: -4; expected whole numbers"));
  EXPECT_EQ(of_resolution(scene, "fem", {}, {50, 10}), "");
}

// SPH uses all divisions, or refuses them: 100 x 10 of 1000 x 100 mm are particles 10 mm apart, 50 x 10 would
// be 20 and 10 mm.
TEST(Command, DivisionsForParticlesMustMeanOneSpacing) {
  const Scene scene = cantilever();
  EXPECT_EQ(of_resolution(scene, "sph", {}, {100, 10}), "");
  EXPECT_DOUBLE_EQ(spacing_of(*scene.bodies[0].shape, {0, {100, 10, 0}}), 0.01);
  EXPECT_EQ(of_resolution(scene, "sph", {}, {50, 10}),
            "--divisions: SPH has one spacing, and these divisions of the box 1000 x 100 mm give 20 mm along "
            "x and 10 mm along y; expected a spacing");
}

TEST(Command, AdviceIsNotConfirmedByTheSameMethodTwice) {
  Scene scene = cantilever();
  scene.probes.push_back({"tip", 0, quantity_named("displacement"), {1, 0.05, 0}});
  AdviseCommand c;
  c.error = "1%";
  c.component = "y";
  c.methods = {"fem-full", "sph-corrected", "fem-full"};
  EXPECT_EQ(complaint([&] { question_of(c, scene); }), "--methods: fem-full is given twice");
  c.methods = {"fem-full", "sph-corrected"};
  c.safety = 1.5;
  EXPECT_THAT(complaint([&] { question_of(c, scene); }), HasSubstr("--safety is 1.5"));
  c.safety = 0.9;
  for (const char* bad : {"nan", "-1%", "0", "inf", "100%", "1e999", "1 percent", ""}) {
    c.error = bad;
    EXPECT_NE(complaint([&] { question_of(c, scene); }), "") << bad;
  }
  c.error = "1%";
  for (const char* bad : {"nan s", "-1 s", "0 s", "inf s", "5", ""}) {
    c.budget = bad;
    EXPECT_THAT(complaint([&] { question_of(c, scene); }), HasSubstr("--budget")) << bad;
  }
}

}  // namespace
}  // namespace femsph::compare
