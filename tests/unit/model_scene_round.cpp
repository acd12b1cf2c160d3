// Rings, discs, tubes, cylinders and quadrilaterals: what they hold, their sides, and their own cells, whose
// area comes near the shape's with the square of the size (the rim is cut into chords: a sector of angle a
// loses a - sin a of a) and whose corners are never folded.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "model/scene/shapes/quadrilateral.hpp"
#include "model/scene/shapes/round.hpp"
#include "model_cells_measured.hpp"

namespace femsph {
namespace {

using test::Measured, test::measured, test::shape_fault, testing::ElementsAre, testing::HasSubstr;
using Part = Round::Part;

using std::numbers::pi;

std::vector<Round> samples(int dim) {
  std::vector<Round> all;
  for (const Part part : {Part::whole, Part::half, Part::quarter})
    for (const double inner : {0.0, 0.03, 0.01})
      for (const int axis : {0, 2})
        all.emplace_back(
            dim, Round::Size{{0.1, -0.2, dim == 3 ? 0.3 : 0}, inner, 0.04, dim == 3 ? 0.05 : 0, axis, part});
  return all;
}

TEST(Round, CellsFillTheShape) {
  for (const int dim : {2, 3})
    for (const Round& round : samples(dim)) {
      double before = 0;
      for (const int n : {8, 16, 32}) {
        std::array<int, 3> divisions{n, n, n};
        const Measured m = measured(round.mesh(divisions));
        const double error = 1 - m.volume / round.measure();
        EXPECT_GT(m.worst, 0.3) << round.describe() << " " << n;
        EXPECT_GT(error, 0);
        if (before > 0) {
          EXPECT_LT(error, 0.45 * before) << round.describe() << " " << n;
        }
        before = error;
      }
      EXPECT_LT(before, 3e-3);
    }
}

TEST(Round, NeighboursShareVertices) {
  // Every inner edge belongs to two cells: a whole ring has only its two rims as boundary, 4 sectors each.
  const Round ring(2, {{}, 0.03, 0.04, 0, 2, Part::whole});
  const CellMesh mesh = ring.mesh({16, 16, 0});
  std::map<std::set<int>, int> edges;
  for (const auto& c : mesh.cells)
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}}) ++edges[{c[a], c[b]}];
  int lone = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_LE(count, 2);
    if (count > 1) continue;
    ++lone;
    for (const int v : edge)
      EXPECT_TRUE(ring.on_side("inner", mesh.vertices[v], 1e-12) ||
                  ring.on_side("outer", mesh.vertices[v], 1e-12));
  }
  EXPECT_EQ(lone, int(2 * mesh.cells.size() / 2));  // two layers across the wall
}

TEST(Round, HoldsItsPoints) {
  const Round tube(3, {{1, 2, 3}, 0.5, 1, 2, 0, Part::half});  // along x; second axis z
  EXPECT_TRUE(tube.contains({1, 2.7, 3}, 1e-9));
  EXPECT_TRUE(tube.contains({3, 2, 3.9}, 1e-9));
  EXPECT_FALSE(tube.contains({3.01, 2, 3.9}, 1e-9));
  EXPECT_FALSE(tube.contains({2, 2, 2.3}, 1e-9)) << "the other half";
  EXPECT_FALSE(tube.contains({2, 2.2, 3.2}, 1e-9)) << "the hollow";
  EXPECT_THAT(tube.lower(), ElementsAre(1, 1, 3));
  EXPECT_THAT(tube.upper(), ElementsAre(3, 3, 4));
  EXPECT_THAT(tube.sides(), ElementsAre("x-", "x+", "y-", "y+", "z-", "z+", "outer", "inner"));
  EXPECT_TRUE(tube.on_side("inner", {2, 2.3, 3.4}, 1e-9));
  EXPECT_FALSE(tube.on_side("inner", {2, 2.3, 3.5}, 1e-9));
  EXPECT_EQ(tube.describe(), "half tube of radii 500 and 1000 mm, 2000 mm long");
  const Round disc(2, {{0, 0, 0}, 0, 1, 0, 2, Part::quarter});
  EXPECT_TRUE(disc.contains({0, 0, 0}, 1e-9));
  EXPECT_FALSE(disc.contains({-0.1, 0.1, 0}, 1e-9));
  EXPECT_DOUBLE_EQ(disc.measure(), pi / 4);
}

TEST(Quadrilateral, CooksMembrane) {
  const Quadrilateral cook({Point{0, 0, 0}, {48, 44, 0}, {48, 60, 0}, {0, 44, 0}});
  EXPECT_DOUBLE_EQ(cook.measure(), 48 * (44 + 16) / 2.0);
  const CellMesh mesh = cook.mesh({4, 8, 0});
  EXPECT_EQ(mesh.cells.size(), 32u);
  EXPECT_NEAR(measured(mesh).volume, cook.measure(), 1e-9);
  EXPECT_GT(measured(mesh).worst, 0.3);
  EXPECT_TRUE(cook.contains({24, 30, 0}, 0));
  EXPECT_FALSE(cook.contains({24, 20, 0}, 0));
  EXPECT_TRUE(cook.on_side("bottom", {24, 22, 0}, 1e-9));
  EXPECT_TRUE(cook.on_side("right", {48, 52, 0}, 1e-9));
  EXPECT_FALSE(cook.on_side("top", {24, 51, 0}, 1e-9));
  EXPECT_TRUE(cook.on_side("x-", {0, 30, 0}, 1e-9));
}

TEST(Round, FaultsOfScenes) {
  const std::string ring = "shape = \"ring\"\ncentre = [\"0 mm\", \"0 mm\"]\n";
  EXPECT_EQ(shape_fault(ring + "inner = \"30 mm\"\nouter = \"40 mm\"\npart = \"quarter\"\n", false), "");
  EXPECT_EQ(shape_fault(ring + "inner = \"40 mm\"\nouter = \"40 mm\"\n", false),
            "\"inner\" is 40 mm, not below \"outer\", 40 mm; expected the smaller radius");
  EXPECT_EQ(shape_fault(ring + "inner = \"30 mm\"\nouter = \"40 mm\"\npart = \"third\"\n", false),
            "\"part\" is \"third\"; expected \"whole\", \"half\" or \"quarter\"");
  EXPECT_THAT(shape_fault(ring + "outer = \"40 mm\"\n", false), HasSubstr("missing \"inner\""));
  EXPECT_EQ(
      shape_fault(
          "shape = \"ring\"\ncentre = [\"0 mm\", \"0 mm\", \"0 mm\"]\ninner = \"30 mm\"\nouter = \"40 mm\"\n",
          true),
      "a ring in a three-dimensional scene; expected \"tube\"");
  const std::string cylinder =
      "shape = \"cylinder\"\ncentre = [\"0 mm\", \"0 mm\", \"0 mm\"]\nradius = \"3 mm\"\n";
  EXPECT_EQ(shape_fault(cylinder + "axis = \"y\"\nlength = \"32 mm\"\n", true), "");
  EXPECT_THAT(shape_fault(cylinder + "length = \"32 mm\"\n", true), HasSubstr("missing \"axis\""));
  EXPECT_THAT(shape_fault(cylinder + "axis = \"y\"\nlength = \"0 mm\"\n", true),
              HasSubstr("expected a length greater than zero"));
  const std::string cook =
      "shape = \"quadrilateral\"\ncorner1 = [\"0 m\", \"0 m\"]\ncorner2 = [\"48 m\", \"44 m\"]\ncorner3 = "
      "[\"48 m\", \"60 m\"]\n";
  EXPECT_EQ(shape_fault(cook + "corner4 = [\"0 m\", \"44 m\"]\n", false), "");
  EXPECT_EQ(shape_fault(cook + "corner4 = [\"60 m\", \"50 m\"]\n", false),
            "the corners turn the wrong way at \"corner3\"; expected a convex quadrilateral, "
            "counterclockwise from the lower left");
}

TEST(Pressure, FaultsOfScenes) {
  const std::string ring =
      "shape = \"ring\"\ncentre = [\"0 mm\", \"0 mm\"]\ninner = \"30 mm\"\nouter = \"40 mm\"\n";
  EXPECT_EQ(shape_fault(ring + "[[loads]]\nat = \"inner\"\npressure = \"100 MPa\"\n", false), "");
  EXPECT_EQ(shape_fault(ring + "[[loads]]\nat = \"all\"\npressure = \"100 MPa\"\n", false),
            "\"pressure\" needs one side of a body; expected at = \"x+\" or the like");
  EXPECT_EQ(
      shape_fault(
          ring + "[[loads]]\nat = \"inner\"\npressure = \"100 MPa\"\nforce = [\"1 N\", \"0 N\"]\n", false),
      "both \"force\" and \"pressure\"; expected one of them");
}

}  // namespace
}  // namespace femsph
