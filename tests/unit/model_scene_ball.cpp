// A ball with its own cells: its volume comes near 4/3 pi R^3 with the square of the size, even or drawn to a
// pole; no corner is folded; cells at the pole are as many times smaller as asked; neighbours share vertices;
// faults of its scene.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "model/scene/shapes/ball.hpp"
#include "model_cells_measured.hpp"

namespace femsph {
namespace {

using test::Measured, test::measured, testing::ElementsAre, testing::HasSubstr;
using Part = OwnBall::Part;

using std::numbers::pi;

TEST(OwnBallSlow, VolumeComesNearWithTheSquareOfTheSize) {
  for (const Part part : {Part::whole, Part::half, Part::quarter})
    for (const int axis : {0, 1, 2})
      for (const double finer : {1.0, 3.0, 8.0}) {
        const OwnBall ball({{0.1, -0.2, 0.3}, 0.04, axis, part, finer});
        const double share = part == Part::whole ? 1 : part == Part::half ? 0.5 : 0.25;
        EXPECT_NEAR(ball.measure(), share * 4 / 3 * pi * 0.04 * 0.04 * 0.04, 1e-15);
        double before = 0;
        for (const int n : {16, 32, 64}) {
          if (n == 64 && (part != Part::quarter || axis != 2)) continue;
          const Point size{ball.upper()[0] - ball.lower()[0], ball.upper()[1] - ball.lower()[1],
                           ball.upper()[2] - ball.lower()[2]};
          const double d = 0.08 / n;
          const Measured m = measured(ball.mesh(
              {int(std::lround(size[0] / d)), int(std::lround(size[1] / d)), int(std::lround(size[2] / d))}));
          const double error = 1 - m.volume / ball.measure();
          EXPECT_GT(m.worst, 0.2) << ball.describe() << " " << n;
          EXPECT_GT(error, 0);  // chords for arcs
          if (before > 0) {
            const double order = std::log2(before / error);
            EXPECT_GT(order, 1.6) << ball.describe() << " " << n;
            EXPECT_LT(order, 2.4) << ball.describe() << " " << n;
          }
          before = error;
        }
      }
}

TEST(OwnBall, RimLiesOnTheSphereAndNeighboursShareVertices) {
  for (const Part part : {Part::whole, Part::half, Part::quarter}) {
    const OwnBall ball({{1, 2, 3}, 0.5, 2, part, 4});
    const int whole = part == Part::whole ? 12 : 6, first = part == Part::quarter ? 6 : 12;
    const CellMesh mesh = ball.mesh({first, whole, 12});
    std::map<std::set<int>, int> faces;
    for (const auto& c : mesh.cells)
      for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
          std::set<int> face;
          for (int v = 0; v < 8; ++v)
            if ((v >> axis & 1) == side) face.insert(c[v]);
          ++faces[face];
        }
    for (const auto& [face, count] : faces) {
      ASSERT_LE(count, 2);
      if (count == 2) continue;
      const auto all_on = [&, &face = face](const char* side) {
        return std::all_of(
            face.begin(), face.end(), [&](int v) { return ball.on_side(side, mesh.vertices[v], 1e-9); });
      };
      EXPECT_TRUE(all_on("outer") || (part != Part::whole && all_on("y-")) ||
                  (part == Part::quarter && all_on("x-")))
          << ball.describe();
    }
    for (const Point& p : mesh.vertices) EXPECT_TRUE(ball.contains(p, 1e-12));
  }
}

TEST(OwnBall, CellsAreFinerAtThePoleBySoMuch) {
  const auto at_pole = [](double finer) {
    const OwnBall ball({{0, 0, 1}, 1, 2, Part::quarter, finer});
    const CellMesh mesh = ball.mesh({20, 20, 40});
    std::vector<double> heights;
    for (const Point& p : mesh.vertices)
      if (std::hypot(p[0], p[1]) < 1e-9) heights.push_back(p[2]);
    std::sort(heights.begin(), heights.end());
    EXPECT_NEAR(heights.front(), 0, 1e-12);
    EXPECT_NEAR(heights.back(), 2, 1e-12);
    return heights[1];
  };
  const double even = at_pole(1);
  EXPECT_NEAR(even, 0.05, 0.01);
  EXPECT_NEAR(at_pole(4), even / 4, 0.1 * even / 4);
  EXPECT_NEAR(at_pole(8), even / 8, 0.2 * even / 8);
}

TEST(OwnBall, HoldsItsPoints) {
  const OwnBall ball({{1, 2, 3}, 0.5, 0, Part::half, 1});  // along x; second axis z
  EXPECT_TRUE(ball.contains({1, 1.7, 3.2}, 1e-9));
  EXPECT_FALSE(ball.contains({1, 1.7, 2.9}, 1e-9)) << "the other half";
  EXPECT_FALSE(ball.contains({1.4, 2, 3.4}, 1e-9));
  EXPECT_THAT(ball.lower(), ElementsAre(0.5, 1.5, 3));
  EXPECT_THAT(ball.upper(), ElementsAre(1.5, 2.5, 3.5));
  EXPECT_THAT(ball.sides(), ElementsAre("x-", "x+", "y-", "y+", "z-", "z+", "outer"));
  EXPECT_TRUE(ball.on_side("outer", {0.5, 2, 3}, 1e-9));
  EXPECT_FALSE(ball.on_side("outer", {0.6, 2, 3}, 1e-9));
  EXPECT_EQ(ball.describe(), "half ball of radius 500 mm");
  EXPECT_EQ(OwnBall({{}, 0.01, 2, Part::quarter, 8}).describe(),
            "quarter ball of radius 10 mm, 8 times finer at z-");
}

/// `rest`: lines of the body and tables after it; with a load on a side.
std::string fault_of(const std::string& rest, bool space = true) {
  const std::string centre = space ? "centre = [\"0 m\", \"0 m\", \"0 m\"]\n"
                                   : "centre = [\"0 m\", \"0 m\"]\n";
  return test::shape_fault("shape = \"ball\"\n" + centre + rest + scene_text::load("z+", "1 0 0 N"), space);
}

TEST(OwnBall, FaultsOfScenes) {
  const std::string radius = "radius = \"10 mm\"\n";
  EXPECT_EQ(fault_of(radius), "");
  EXPECT_EQ(fault_of(radius + "axis = \"y\"\npart = \"half\"\nfiner = 8\n"), "");
  for (const char* bad : {"0.5", "21", "nan", "-1"})
    EXPECT_THAT(fault_of(radius + "finer = " + bad + "\n"), HasSubstr("finer")) << bad;
  EXPECT_EQ(fault_of(radius + "finer = 0.5\n"),
            "\"finer\" is 0.5; expected how many times finer the cells are at the pole, from 1 to 20");
  EXPECT_EQ(fault_of(radius + "part = \"third\"\n"),
            "\"part\" is \"third\"; expected \"whole\", \"half\" or \"quarter\"");
  EXPECT_THAT(fault_of(""), HasSubstr("missing \"radius\""));
  EXPECT_EQ(fault_of(radius, false), "a ball in a plane scene; expected \"disc\"");
}

TEST(Supports, FaultsOfNames) {
  const auto support = [](const std::string& more) {
    return "radius = \"1 m\"\n[[supports]]\nat = \"z-\"\nfix = [\"x\"]\n" + more;
  };
  EXPECT_EQ(fault_of(support("name = \"root\"\n")), "");
  EXPECT_EQ(fault_of(support("name = \"root\"\nmode = \"mean\"\n")),
            "\"name\" with mode = \"mean\"; expected it only on a support that holds every point");
  EXPECT_THAT(fault_of(support("name = \"a,b\"\n")), HasSubstr("cannot be used; expected letters"));
  EXPECT_EQ(fault_of(support("name = \"root\"\n[[supports]]\nname = \"root\"\nat = \"z+\"\nfix = [\"y\"]\n")),
            "the name \"root\" is taken; expected a name that no other support has");
}

}  // namespace
}  // namespace femsph
