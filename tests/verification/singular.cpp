// What the warnings about singular places claim, measured: under a force on a point the displacement of the
// elastic body gains the same with every halving of the cells (in a plane) or twice as much each time (in
// space), and what is read away from it converges.

#include "model/scene/singular.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "compare/run/run.hpp"
#include "compare/study/study_limits.hpp"
#include "fem/fem.hpp"
#include "model/scene/reader/reader.hpp"
#include "model/scene/shapes/box.hpp"

namespace femsph {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Scene block(int dim) {
  Scene scene;
  scene.plane = dim == 2 ? Plane::stress : Plane::none;
  scene.materials["steel"] = {"steel", 2.1e11, 0.3, 7850};
  scene.bodies.push_back(
      {"block", std::make_shared<Box>(dim, Point{0, 0, 0}, Point{0.1, 0.1, dim == 3 ? 0.1 : 0}), 0.05,
       "steel"});
  scene.supports.push_back({Place{0, {dim == 2 ? "x-" : "z-"}, {}, {}}, {true, true, dim == 3}});
  scene.settling.emplace();
  return scene;
}

/// Changes of a probe's component along the force over two halvings of the cells.
std::array<double, 2> changes(const Scene& scene, const char* probe, int component, std::array<int, 3> cells,
                              int degree) {
  std::array<double, 3> u;
  for (double& value : u) {
    value = fem::static_limit(scene, cells, degree).probes.at(probe)[component];
    for (int& n : cells) n *= 2;
  }
  return {std::abs(u[1] - u[0]), std::abs(u[2] - u[1])};
}

TEST(SingularForce, SinksByFlamantsLogarithmOnASide) {
  Scene scene = block(2);
  scene.loads.push_back({Place{0, {}, Point{0.05, 0.1, 0}, {}}, {0, -1e5, 0}, {}});
  scene.probes.push_back({"under", 0, quantity_named("displacement"), {0.05, 0.1, 0}});
  scene.probes.push_back({"away", 0, quantity_named("displacement"), {0.1, 0.1, 0}});
  const double each = 1e5 * sinks_per_halving(scene, scene.loads[0].place);
  EXPECT_NEAR(each, 2 * std::log(2) * 1e5 / (std::acos(-1.0) * 2.1e11 * 0.05), 1e-15);
  const auto under = changes(scene, "under", 1, {8, 8, 1}, 2), away = changes(scene, "away", 1, {8, 8, 1}, 2);
  EXPECT_NEAR(under[0] / each, 1, 0.03);  // what the rest of the body adds falls with the square of the cells
  EXPECT_NEAR(under[1] / each, 1, 0.008);
  EXPECT_LT(away[1], 0.5 * away[0]);
  EXPECT_LT(away[1], 0.02 * each);
}

TEST(SingularForce, SinksByMichellsWedgeAtACorner) {
  Scene scene = block(2);
  scene.loads.push_back({Place{0, {"x+", "y+"}, {}, {}}, {0, -1e5, 0}, {}});
  scene.probes.push_back({"under", 0, quantity_named("displacement"), {0.1, 0.1, 0}});
  const double each = 1e5 * sinks_per_halving(scene, scene.loads[0].place);
  const auto under = changes(scene, "under", 1, {8, 8, 1}, 2);
  EXPECT_NEAR(under[0] / each, 1, 0.08);
  EXPECT_NEAR(under[1] / each, 1, 0.03);
  // In plane strain by E/(1 - nu^2).
  scene.plane = Plane::strain;
  EXPECT_NEAR(changes(scene, "under", 1, {8, 8, 1}, 2)[1] / (0.91 * each), 1, 0.03);
}

TEST(SingularForce, InSpaceTheChangeDoubles) {
  Scene scene = block(3);
  scene.loads.push_back({Place{0, {}, Point{0.05, 0.05, 0.1}, {}}, {0, 0, -1e5}, {}});
  scene.probes.push_back({"under", 0, quantity_named("displacement"), {0.05, 0.05, 0.1}});
  const auto under = changes(scene, "under", 2, {2, 2, 2}, 1);
  EXPECT_NEAR(under[1] / under[0], 2, 0.2);
}

// The whole way of a study: the limit under the force is called unknown, that away from it is compared with.
TEST(SingularForce, AStudyComparesWithNoLimitUnderIt) {
  Scene scene = block(2);
  scene.loads.push_back({Place{0, {"x+", "y+"}, {}, {}}, {0, -1e5, 0}, {}});
  scene.probes.push_back({"under", 0, quantity_named("displacement"), {0.1, 0.1, 0}});
  scene.probes.push_back({"beside", 0, quantity_named("displacement"), {0.1, 0.05, 0}});
  compare::Study study;
  study.scenes["s.toml"] = scene;
  study.runs.push_back({"case", "fem-full", compare::method_named("fem-full"), {0.02, {}}, "s.toml", {}});
  study.limit = compare::LimitSpec{{20, 20, 0}, 2, ""};
  compare::StudyOutcome outcome;
  const auto limits = compare::static_limits(study, {compare::run_scene, fem::static_limit}, {}, outcome);
  ASSERT_EQ(outcome.failures, 0);
  compare::QuantitySpec quantity;
  quantity.name = "u", quantity.observed = {"under", "", "", "", "y", {"mm", 1e-3}};
  compare::KnownLimit known = limits.at("s.toml");
  EXPECT_THAT(compare::doubt_of(quantity, scene, known), HasSubstr("a force on a point"));
  Scene unaware = scene;  // the numbers alone tell as much
  unaware.loads.clear();
  EXPECT_THAT(compare::doubt_of(quantity, unaware, known),
              HasSubstr("the changes do not decrease as they do towards a limit"));
  quantity.observed.probe = "beside";
  EXPECT_THAT(compare::doubt_of(quantity, scene, known), IsEmpty());
}

/// Two blocks of different height and one spacing: what a run says of itself does not depend on their order.
TEST(TwoBodies, SpacingAndCellsAreThoseOfTheCoarsest) {
  for (const bool swapped : {false, true}) {
    Scene scene = block(2);
    scene.settling.reset();
    scene.duration = 1e-6, scene.samples = 1, scene.snapshots = 0;
    scene.bodies[0].shape = std::make_shared<Box>(2, Point{0, 0, 0}, Point{0.1, 0.1, 0});
    scene.bodies.push_back(
        {"low", std::make_shared<Box>(2, Point{0.2, 0, 0}, Point{0.1, 0.035, 0}), 0.05, "steel"});
    scene.loads.push_back({Place{1, {"x+"}, {}, {}}, {1, 0, 0}, {}});
    if (swapped)
      std::swap(scene.bodies[0], scene.bodies[1]),
          scene.supports[0].place.body = 1, scene.loads[0].place.body = 0;
    compare::RunOptions options;
    options.scalars.insert("surface_weight_loss");
    const auto fem = compare::run_scene(scene, compare::method_named("fem-full"), {0.01, {}}, {});
    EXPECT_NEAR(fem.spacing, 0.01, 1e-12);  // 10 cells of 10 mm; 4 of 8.75 mm
    EXPECT_EQ(fem.cells_over_height, 10);
    const auto sph = compare::run_scene(
        scene, compare::method_named("sph-classic-share"), {0.01, {}}, options);
    EXPECT_NEAR(sph.scalars.at("surface_weight_loss"), 0.30, 0.15);
    static double first = sph.scalars.at("surface_weight_loss");
    EXPECT_EQ(sph.scalars.at("surface_weight_loss"), first);
  }
}

}  // namespace
}  // namespace femsph
