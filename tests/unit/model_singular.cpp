// Places without a finite value: a force or a reaction on a point (in space: on a line), the end of a clamp,
// a re-entrant corner. A warning is given where something is read there, and nowhere else: the paper's
// cantilever, loaded on a corner and read at mid height, has its limit.

#include <gmock/gmock.h>

#include <cmath>

#include "model/scene/reader/reader.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/round.hpp"
#include "model/scene/singular.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// 1000 x 100 x 100 mm of steel (in space 100 mm deep), with nothing on it.
Scene beam_of(int dim = 2) {
  Scene scene;
  scene.plane = dim == 2 ? Plane::stress : Plane::none;
  scene.materials["steel"] = {"steel", 2.1e11, 0.3, 7850};
  scene.bodies.push_back(
      {"beam", std::make_shared<Box>(dim, Point{0, 0, 0}, Point{1, 0.1, dim == 3 ? 0.1 : 0}), 0.1, "steel"});
  return scene;
}
Scene cantilever() {
  Scene scene = beam_of();
  scene.supports.push_back({Place{0, {"x-"}, {}, {}}, {true, true, false}});
  scene.loads.push_back({Place{0, {"x+", "y+"}, {}, {}}, {0, -25e3, 0}, {}});
  return scene;
}
void read(Scene& scene, const std::string& name, const Quantity* quantity, Point at) {
  scene.probes.push_back({name, 0, quantity, at});
}

/// What is read at singular places, by kind.
std::vector<std::string> observers(const Scene& scene, SingularPlace::Kind kind) {
  std::vector<std::string> names;
  for (const SingularPlace& place : singular_places(scene))
    if (place.kind == kind) names.insert(names.end(), place.observers.begin(), place.observers.end());
  return names;
}
using Kind = SingularPlace::Kind;

TEST(Singular, AForceOnACornerMattersOnlyToWhatIsReadThere) {
  Scene scene = cantilever();
  read(scene, "tip", quantity_named("displacement"), {1, 0.05, 0});
  read(scene, "root", quantity_named("stress"), {0.1, 0.1, 0});
  EXPECT_THAT(singular_places(scene), IsEmpty());
  read(scene, "under", quantity_named("displacement"), {1, 0.1, 0});
  read(scene, "near", quantity_named("stress"), {0.995, 0.1, 0});
  EXPECT_THAT(observers(scene, Kind::force), ElementsAre("under"));
  const auto near = singular_places(scene, 0.01);
  ASSERT_THAT(near, SizeIs(1));
  EXPECT_THAT(near[0].observers, ElementsAre("under", "near"));
  EXPECT_TRUE(near[0].certain());
  // Michell's wedge of a right angle, loaded along a side: (1/(pi/2 + 1) + 1/(pi/2 - 1)) 25 kN ln 2/(210 GPa
  // 0.1 m) = 1.767e-6 m.
  EXPECT_THAT(near[0].text,
              AllOf(HasSubstr("a force on a point: the exact displacement and stress there are infinite"),
                    HasSubstr("gains about 0.00177 mm with every halving")));
}

TEST(Singular, AForceOnASideHasItsLimit) {
  Scene scene = cantilever();
  scene.loads[0].place.sides = {"x+"};
  read(scene, "under", quantity_named("displacement"), {1, 0.1, 0});
  EXPECT_THAT(singular_places(scene), IsEmpty());
  scene.loads[0].place.within = Region{{0.9, 0.08, 0}, {1, 0.1, 0}};
  EXPECT_THAT(singular_places(scene), IsEmpty());
  scene.loads[0].place.within = Region{{0.9, 0.1, 0}, {1, 0.1, 0}};  // of no height: a point
  EXPECT_THAT(observers(scene, Kind::force), ElementsAre("under"));
  scene.loads[0].force = {};
  EXPECT_THAT(singular_places(scene), IsEmpty());
}

TEST(Singular, InSpaceALineIsNoSide) {
  Scene scene = beam_of(3);
  scene.loads.push_back({Place{0, {"x+", "y+"}, {}, {}}, {0, -1, 0}, {}});
  read(scene, "edge", quantity_named("velocity"), {1, 0.1, 0.03});
  read(scene, "middle", quantity_named("velocity"), {1, 0.05, 0.03});
  const auto found = singular_places(scene);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].observers, ElementsAre("edge"));
  EXPECT_THAT(found[0].text, HasSubstr("a force on a line"));
}

TEST(Singular, ADiscsLowestPlaceIsAPoint) {
  Scene scene = beam_of();
  scene.bodies[0].shape = std::make_shared<Round>(
      2, Round::Size{{0, 0, 0}, 0, 0.1, 0, 2, Round::Part::whole});
  scene.loads.push_back({Place{0, {"y+"}, {}, {}}, {0, -1, 0}, {}});
  read(scene, "top", quantity_named("displacement"), {0, 0.1, 0});
  EXPECT_THAT(observers(scene, Kind::force), ElementsAre("top"));
  scene.loads[0].place.sides = {"outer"};
  EXPECT_THAT(singular_places(scene), IsEmpty());
}

// Three-point bending: the whole beam sinks into its supports; the pin's x bears nothing, since nothing acts
// along x and it alone holds it.
TEST(Singular, PointSupportsThatBearAReaction) {
  Scene scene = beam_of();
  scene.supports.push_back({Place{0, {}, Point{0.1, 0, 0}, {}}, {true, true, false}});
  scene.supports.push_back({Place{0, {}, Point{0.9, 0, 0}, {}}, {false, true, false}});
  scene.loads.push_back({Place{0, {"y+"}, {}, {}}, {0, -1, 0}, {}});
  read(scene, "below", quantity_named("displacement"), {0.5, 0, 0});
  read(scene, "held", quantity_named("displacement"), {0.1, 0, 0});
  read(scene, "stress", quantity_named("stress"), {0.5, 0, 0});
  read(scene, "foot", quantity_named("stress"), {0.9, 0, 0});
  const auto found = singular_places(scene);
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_THAT(found[0].observers, ElementsAre("below"));
  EXPECT_THAT(found[1].observers, ElementsAre("below", "held", "foot"));
  EXPECT_FALSE(found[0].certain());
}

// A bar that a single point keeps from sliding: no force acts across it.
TEST(Singular, APointSupportThatBearsNothing) {
  Scene scene = beam_of();
  scene.supports.push_back({Place{0, {"x-"}, {}, {}}, {true, false, false}});
  scene.supports.push_back({Place{0, {"x-", "y-"}, {}, {}}, {false, true, false}});
  scene.loads.push_back({Place{0, {"x+"}, {}, {}}, {1e3, 0, 0}, {}});
  read(scene, "end", quantity_named("displacement"), {1, 0.05, 0});
  EXPECT_THAT(singular_places(scene), IsEmpty());
  scene.gravity = Point{0, -9.81, 0};
  EXPECT_THAT(observers(scene, Kind::hold), ElementsAre("end"));
}

// 0.7112 for nu = 0.3 in plane strain is the value of the literature (Williams 1952; Szabo and Babuska 1991,
// example of the clamped square).
TEST(Singular, ExponentOfAClampedCorner) {
  EXPECT_NEAR(clamped_corner_exponent(0.3, Plane::strain), 0.7112, 1e-4);
  EXPECT_NEAR(
      clamped_corner_exponent(0.3, Plane::stress), clamped_corner_exponent(0.3 / 1.3, Plane::strain), 1e-12);
  EXPECT_EQ(clamped_corner_exponent(0, Plane::strain), 1);
}

TEST(Singular, StressWhereAClampEnds) {
  Scene scene = cantilever();
  read(scene, "corner", quantity_named("stress"), {0, 0, 0});
  read(scene, "middle", quantity_named("stress"), {0, 0.05, 0});
  read(scene, "still", quantity_named("displacement"), {0, 0, 0});
  scene.sections.push_back({"root", 0, quantity_named("strain"), {0, 0, 0}, {0, 0.1, 0}, 11});
  scene.sections.push_back({"inner", 0, quantity_named("strain"), {0.1, 0, 0}, {0.1, 0.1, 0}, 11});
  const auto found = singular_places(scene);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::clamp);
  EXPECT_THAT(found[0].observers, ElementsAre("corner", "root"));
  EXPECT_THAT(found[0].text, HasSubstr("(as distance^-0.24)"));
  Scene other = scene;
  other.materials["steel"].poisson = 0;
  EXPECT_THAT(singular_places(other), IsEmpty());
  other = scene;
  other.supports[0].fixed[1] = false;  // a smooth wall
  EXPECT_THAT(singular_places(other), IsEmpty());
  other = scene;
  other.symmetries.push_back({Place{0, {"y-"}, {}, {}}});  // the body goes on beyond: no corner there
  EXPECT_THAT(observers(other, Kind::clamp), ElementsAre("root"));
  other.sections.clear();
  EXPECT_THAT(singular_places(other), IsEmpty());
  other = scene;
  Plasticity perfect;  // stress is bounded by the yield stress, strain by nothing
  perfect.yield = 3e8;
  other.materials["steel"].parameters = perfect;
  EXPECT_THAT(observers(other, Kind::clamp), ElementsAre("root"));
}

TEST(Singular, StressWhereAHeldPatchEnds) {
  Scene scene = beam_of();
  scene.supports.push_back(
      {Place{0, {"y-"}, {}, {}, Region{{0, 0, 0}, {0.2, 0.1, 0}}}, {false, true, false}});
  read(scene, "end", quantity_named("stress"), {0.2, 0, 0});
  read(scene, "inside", quantity_named("stress"), {0.1, 0, 0});
  EXPECT_THAT(observers(scene, Kind::clamp), ElementsAre("end"));
}

// An L of three squares: its inner corner takes 270 degrees.
TEST(Singular, StressInAReentrantCorner) {
  Scene scene = beam_of();
  CellMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}};
  mesh.cells = {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}};
  scene.bodies[0].shape = std::make_shared<MeshShape>(mesh, "L.msh");
  read(scene, "inner", quantity_named("equivalent_stress"), {1, 1, 0});
  read(scene, "outer", quantity_named("equivalent_stress"), {2, 1, 0});
  read(scene, "moves", quantity_named("displacement"), {1, 1, 0});
  EXPECT_THAT(observers(scene, Kind::notch), ElementsAre("inner"));
}

TEST(Singular, TheReaderWarnsWithThePlace) {
  using namespace scene_text;
  const std::string text = "title = \"t\"\n" + clamped_beam("1000 100 mm", "100 mm") +
                           load("x+ y+", "0 -25 kN") + scene_text::time("1 ms");
  const auto probe_at = [](const char* point) { return probe("tip", "displacement", point); };
  EXPECT_THAT(parse_scene(text + probe_at("1000 50 mm"), "s.toml").warnings, IsEmpty());
  const auto warnings = parse_scene(text + probe_at("1000 100 mm"), "s.toml").warnings;
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_THAT(warnings[0], AllOf(StartsWith("s.toml:18:6: a force on a point"),
                                 HasSubstr("for what \"tip\" reads there")));
}

}  // namespace
}  // namespace femsph
