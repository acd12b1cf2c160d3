// A method for each body: how it is written, to which bodies options apply, and what a run of it is called.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/program/commands.hpp"
#include "compare/run/capacity.hpp"
#include "compare/run/plan/method_option.hpp"
#include "compare_support.hpp"
#include "model/scene/shapes/mesh.hpp"

namespace femsph::compare {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

/// Steel boxes 1 m x 0.1 m, "bar" over "plate", and with `rigid` a rigid "floor" below.
Scene bar_on_plate(bool rigid = false) {
  Scene scene = cantilever();
  scene.file = "pair.toml";
  scene.bodies[0].name = "bar";
  scene.bodies.push_back(
      {"plate", std::make_shared<Box>(2, Point{0, -0.1, 0}, Point{1, 0.1, 0}), 0.1, "steel"});
  if (rigid)
    scene.bodies.push_back(
        {"floor", std::make_shared<Box>(2, Point{0, -0.3, 0}, Point{1, 0.1, 0}), 0.1, "", true, 1});
  return scene;
}

RunCommand with_solver(const std::string& solver) {
  RunCommand c;
  c.solver = solver;
  return c;
}

std::string refusal(const RunCommand& c, const Scene& scene) {
  try {
    methods_of(c, scene);
  } catch (const BadCommand& e) {
    return e.what();
  }
  return "";
}
std::string refusal(const std::string& solver, const Scene& scene = bar_on_plate()) {
  return refusal(with_solver(solver), scene);
}

TEST(BodyMethods, EachBodyHasItsMethod) {
  const Scene scene = bar_on_plate(true);
  const auto read = [&](const char* solver) { return methods_of(with_solver(solver), scene); };
  const auto names = [&](const BodyMethods& m) {
    return std::pair(m.of(scene.bodies[0]).name, m.of(scene.bodies[1]).name);
  };
  EXPECT_THAT(names(read("sph")), Pair("sph-corrected", "sph-corrected"));
  EXPECT_THAT(names(read("plate=fem-sri,bar=sph")), Pair("sph-corrected", "fem-sri"));
  EXPECT_THAT(names(read("fem,bar=sph-classic-share")), Pair("sph-classic-share", "fem-full"));
  EXPECT_EQ(read("sph").name, "sph-corrected");
  EXPECT_EQ(read("sph").unit_name(), "particle");
  EXPECT_FALSE(read("sph").by_body());
  // The name is as written, without blanks and with full names of methods.
  EXPECT_EQ(read(" bar = sph , plate=fem ").name, "bar=sph-corrected,plate=fem-full");
  EXPECT_EQ(read("fem,bar=sph").name, "fem-full,bar=sph-corrected");
  EXPECT_EQ(read("fem,bar=sph").unit_name(), "particle or element");
  EXPECT_EQ(read("fem,bar=fem-sri").unit_name(), "element");
  Scene one = cantilever();
  EXPECT_EQ(methods_of(with_solver("box=fem"), one).name, "box=fem-full");
}

TEST(BodyMethods, MistakesAreExplained) {
  EXPECT_THAT(refusal("bra=sph,plate=fem"),
              HasSubstr("--solver: no body \"bra\"; expected \"bar\" or \"plate\"; did you mean \"bar\"?"));
  EXPECT_THAT(refusal("bar=sph,plate=fem-fulll"),
              AllOf(HasSubstr("--solver: no method \"fem-fulll\""), HasSubstr("did you mean \"fem-full\"?")));
  EXPECT_THAT(refusal("bar=,plate=fem"), HasSubstr("--solver: no method \"\""));
  EXPECT_THAT(refusal("=sph,plate=fem"), HasSubstr("--solver: no body \"\"; expected \"bar\" or \"plate\""));
  EXPECT_EQ(
      refusal("bar=sph,bar=fem"), "--solver: the body \"bar\" is named twice; expected one method for it");
  EXPECT_EQ(refusal("bar=sph"),
            "--solver: no method is given for the body plate; expected also plate=METHOD, or one METHOD "
            "without a body, for all bodies that are not named");
  EXPECT_EQ(refusal("fem,sph"),
            "--solver: fem-full and sph-corrected are both without a body; expected one method at most for "
            "the bodies that are not named");
  EXPECT_EQ(refusal("fem,bar=sph,plate=sph"),
            "--solver: fem-full is for no body, as every deformable body is named; expected it with a body, "
            "or not");
  EXPECT_EQ(refusal("floor=fem,sph", bar_on_plate(true)),
            "--solver: the body \"floor\" is rigid; expected deformable bodies only, as a rigid body has no "
            "particles or cells and needs no method");
  EXPECT_EQ(refusal("bar=sph,plate=fem", bar_on_plate(true)), "");
}

// An option applies to the bodies whose methods have it, and is refused if none has.
TEST(BodyMethods, OptionsApplyWhereTheyHaveAnEffect) {
  const Scene scene = bar_on_plate();
  RunCommand c = with_solver("bar=sph,plate=fem");
  c.numbers["smoothing"] = 1.2;
  const BodyMethods methods = methods_of(c, scene);
  EXPECT_EQ(std::get<sph::Options>(methods.of(scene.bodies[0]).options).smoothing, 1.2);
  EXPECT_THAT(
      describe(methods, scene),
      ElementsAre(Pair("method of bar", "sph-corrected smoothing=1.2"), Pair("method of plate", "fem-full")));
  EXPECT_EQ(bodies_with(methods, method_option("smoothing")), "bar");
  c.solver = "sph,plate=fem";
  EXPECT_EQ(bodies_with(methods_of(c, scene), method_option("smoothing")), "every body but plate");
  c.solver = "bar=sph,plate=sph-classic-share";
  EXPECT_EQ(bodies_with(methods_of(c, scene), method_option("smoothing")), "");
  c.solver = "bar=fem,plate=fem-sri";
  EXPECT_EQ(
      refusal(c, scene), "--smoothing does nothing with bar=fem-full,plate=fem-sri: it is an option of SPH");
  c = with_solver("bar=sph-virtual,plate=fem");
  c.numbers["hourglass"] = 0.1;
  EXPECT_EQ(refusal(c, scene),
            "--hourglass does nothing with bar=sph-virtual,plate=fem-full: classic SPH has no hourglass "
            "control, and of the elements, only fem-one-point has an hourglass control");
  EXPECT_TRUE(describe(methods_of(with_solver("sph"), scene), scene).empty());
}

// Divisions must mean one spacing for bodies of particles only; cells from a file need a spacing if another
// body has particles.
TEST(BodyMethods, OneResolutionServesEveryBody) {
  Scene scene = bar_on_plate();
  const auto complaint =
      [&](const char* solver, std::optional<std::string> spacing, std::vector<int> divisions) -> std::string {
    RunCommand c = with_solver(solver);
    c.spacing = spacing;
    c.divisions = divisions;
    try {
      resolution_of(c, scene, methods_of(c, scene));
    } catch (const BadCommand& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(complaint("bar=sph,plate=fem", {}, {100, 10}), "");
  EXPECT_THAT(complaint("bar=sph,plate=fem", {}, {50, 10}), HasSubstr("SPH has one spacing"));
  EXPECT_EQ(complaint("bar=fem,plate=fem-sri", {}, {50, 10}), "");
  CellMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.cells = {{0, 1, 2, 3}};
  for (Body& body : scene.bodies) body.shape = std::make_shared<MeshShape>(mesh, "cell.msh");
  EXPECT_THAT(complaint("bar=fem,plate=fem", "10 mm", {}),
              HasSubstr("--spacing does nothing with bar=fem-full,plate=fem-full: the cells of every"));
  EXPECT_EQ(complaint("bar=sph,plate=fem", "10 mm", {}), "");
  EXPECT_THAT(complaint("bar=sph,plate=fem", {}, {}), HasSubstr("no resolution is given"));
}

TEST(BodyMethods, MemoryIsTheSumOverTheBodies) {
  const Scene scene = bar_on_plate();
  const Resolution fine{1e-3, {}};
  const auto size = [&](const char* solver) {
    return estimated_size(scene, methods_of(with_solver(solver), scene), fine);
  };
  const Size fem = size("fem"), sph = size("sph"), mixed = size("bar=sph,plate=fem");
  EXPECT_NEAR(mixed.bytes, 0.5 * (fem.bytes + sph.bytes), 1e-9 * fem.bytes);
  EXPECT_NEAR(mixed.units, 0.5 * (fem.units + sph.units), 1e-9 * fem.units);
  try {
    refuse_excess(scene, methods_of(with_solver("bar=sph,plate=fem"), scene), {1e-5, {}}, 1e9);
    ADD_FAILURE() << "not refused";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), HasSubstr(" particles and elements, which need "));
  }
}

// Probes are read of each body with its own method, and the record says which it is.
TEST(BodyMethods, ARunSaysTheMethodOfEachBody) {
  Scene scene = bar_on_plate(true);
  scene.supports.push_back({Place{1, {"x-"}, {}, {}}, {true, true, false}});
  scene.duration = 1e-5;
  const Folder folder("by-body");
  std::filesystem::create_directories(folder / "out");
  RunOptions options;
  options.folder = folder / "out";
  options.fields = false;
  const RunResult r = run_scene(
      scene, methods_of(with_solver("bar=sph,plate=fem"), scene), {0.025, {}}, options);
  EXPECT_THAT(r.derived, ::testing::Contains(Pair("method of bar", "sph-corrected")));
  EXPECT_THAT(r.derived, ::testing::Contains(Pair("plate elements", "160")));
  EXPECT_THAT(r.derived, ::testing::Contains(Pair("bar particles", "205")));
  EXPECT_EQ(r.cells_over_height, 4);
  const std::string record = folder.read("out/record.toml");
  EXPECT_THAT(record, HasSubstr("bar=sph-corrected,plate=fem-full"));
  EXPECT_THAT(record, HasSubstr("method of plate"));
}

}  // namespace
}  // namespace femsph::compare
