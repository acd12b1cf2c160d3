// What the check of a mesh finds: duplicate cells and nodes, open seams, separate pieces, folded cells.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "model/scene/shapes/mesh_check.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "model_mesh_text.hpp"

namespace femsph {
namespace {

using namespace mesh_text;

/// What the reader says of a mesh; empty: it is read.
std::string complaint(const Text& text, int dim = 2, const MeshOptions& options = {},
                      std::size_t announced = 0) {
  try {
    text.write(announced);
    read_gmsh(file, dim, 1.0, options);
  } catch (const std::runtime_error& e) {
    return without_file(e.what());
  }
  return "";
}

/// Two cubes, one on the other, each with its own vertices on their common face.
Text two_cubes() {
  Text text;
  for (int n = 0; n < 16; ++n)
    text.nodes.push_back(fmt::format("{} {} {} {}", 101 + n, n & 1, n >> 1 & 1, (n >> 2 & 1) + (n >> 3 & 1)));
  text.elements = {"7 5 2 1 1 101 102 104 103 105 106 108 107", "9 5 2 1 1 109 110 112 111 113 114 116 115"};
  return text;
}

const std::string cure =
    "; expected cells that share their vertices (in Gmsh: Coherence), or open_seams = true if a slit is "
    "meant";

TEST(MeshCheck, KeepsTheNumbersOfTheFile) {
  const CellMesh mesh = read(two_squares());
  EXPECT_EQ(mesh.cell_numbers, (std::vector<std::size_t>{31, 32}));
  ASSERT_EQ(mesh.vertex_numbers.size(), 6u);
  for (std::size_t v = 0; v < 6; ++v) {
    const double x = double(mesh.vertex_numbers[v] % 10 - 1), y = double(mesh.vertex_numbers[v] / 10 - 1);
    EXPECT_EQ(mesh.vertices[v], (Point{x, y, 0}));
  }
}

// Gmsh writes a cell of two groups twice in version 2.2, with a number of its own each time.
TEST(MeshCheck, ACellOfTwoGroupsCountsOnce) {
  Text text = two_squares();
  text.elements = {
      "31 3 2 5 1 11 12 22 21", "32 3 2 6 1 11 12 22 21", "33 3 2 5 1 12 13 23 22", "34 3 2 6 1 12 13 23 22"};
  const CellMesh mesh = read(text);
  EXPECT_EQ(mesh.cell_numbers, (std::vector<std::size_t>{31, 33}));
  EXPECT_DOUBLE_EQ(MeshShape(mesh, "").measure(), 2);
}

TEST(MeshCheck, RefusesWhatIsThereTwice) {
  Text cell = two_squares(), node = cell, element = cell, lines = cell;
  cell.elements.push_back("33 3 2 5 1 21 11 12 22");
  EXPECT_EQ(complaint(cell),
            "cells 31 and 33 of FILE are one and the same, with the same vertices and in the same group; "
            "expected each cell once");
  node.nodes.push_back("13 9 9 0");
  EXPECT_EQ(complaint(node), "FILE defines node 13 twice; expected each number once");
  element.elements[1].replace(0, 2, "31");
  EXPECT_EQ(complaint(element), "FILE defines element 31 twice; expected each number once");
  EXPECT_EQ(complaint(lines, 2, {}, 3),
            "FILE holds more elements than the 3 that it announces; expected a mesh saved by Gmsh");
}

TEST(MeshCheck, OpenSeams) {
  EXPECT_EQ(complaint(doubled()),
            "FILE has an open seam: 1 pair of cell sides that lie on each other and share no side, those of "
            "cells 31 (vertices 12, 22) "
            "and 32 (vertices 53, 52) at (1000, 500) mm" +
                cure);
  EXPECT_EQ(complaint(doubled("1.0001")).substr(0, 24), "FILE has an open seam: 1")
      << "a gap of a ten thousandth of a cell";
  EXPECT_EQ(complaint(two_cubes(), 3),
            "FILE has an open seam: 1 pair of cell sides that lie on each other and share no side, those of "
            "cells 7 (vertices 105, 106, "
            "108, 107) and 9 (vertices 109, 111, 112, 110) at (500, 500, 1000) mm" +
                cure);
  // The left square with two half as high beside it: one of their three vertices on its side is not its own.
  const Text hanging = {
      {"11 0 0 0", "12 1 0 0", "13 2 0 0", "21 0 1 0", "22 1 1 0", "23 2 1 0", "62 1 .5 0", "63 2 .5 0"},
      {"31 3 2 5 1 11 12 22 21", "32 3 2 5 1 12 13 63 62", "33 3 2 5 1 62 63 23 22"},
      {}};
  EXPECT_EQ(complaint(hanging),
            "FILE has an open seam: 1 vertex lies on a side of a cell that does not have it, vertex 62 at "
            "(1000, 500) mm on cell 31 "
            "(vertices 12, 22)" +
                cure);
}

TEST(MeshCheck, Pieces) {
  const Text apart = doubled("1.5");
  EXPECT_EQ(complaint(apart),
            "FILE is in 2 pieces, as cells 31 and 32 show: nothing holds them together; expected one, or "
            "pieces = 2 if that is meant");
  EXPECT_EQ(complaint(apart, 2, {2, false}), "");
  EXPECT_EQ(complaint(apart, 2, {3, false}), "FILE is in 2 pieces and not in 3, as \"pieces\" says");
  EXPECT_EQ(complaint(two_squares(), 2, {2, false}), "FILE is in 1 piece and not in 2, as \"pieces\" says");
  EXPECT_EQ(complaint(doubled(), 2, {2, true}), "") << "a slit that is meant";
  const Text hinge = {{"11 0 0 0", "12 1 0 0", "21 0 1 0", "22 1 1 0", "23 2 1 0", "32 1 2 0", "33 2 2 0"},
                      {"31 3 2 5 1 11 12 22 21", "32 3 2 5 1 22 23 33 32"},
                      {}};
  EXPECT_EQ(complaint(hinge),
            "FILE is in 2 pieces that hang together at vertices alone, as cells 31 and 32 at vertex 22, "
            "(1000, 1000) mm: a hinge, which takes "
            "no moment; expected cells joined by their sides, or pieces = 2 if that is meant");
}

TEST(MeshCheck, CellsOnTheSameSide) {
  Text text = two_squares();  // the second square folded back over the first
  text.nodes[2] = "13 .1 .1 0", text.nodes[5] = "23 .1 .9 0";
  EXPECT_EQ(complaint(text),
            "cells 31 and 32 of FILE overlap: they lie on the same side of the side that they share; "
            "expected cells beside each other");
  text = two_squares();
  text.nodes.insert(text.nodes.end(), {"14 3 -1 0", "24 3 2 0"});
  text.elements.push_back("33 3 2 5 1 12 14 24 22");
  EXPECT_EQ(complaint(text), "cells 31, 32 and 33 of FILE share one side; expected two cells at most");
}

// A unit square whose corner (1, 1) is drawn in to (q, q): J = 1 - (1 - q) (xi + eta). At that corner J = 2 q
// - 1, zero or less up to q = 1/2; at the last Gauss point, xi = eta = 0.7887, J > 0 from q = 0.366 on.
TEST(MeshCheck, CellsThatAreNotConvex) {
  const auto drawn_in = [](const std::string& q) {
    return Text{
        {"11 0 0 0", "12 1 0 0", "21 0 1 0", "22 " + q + " " + q + " 0"}, {"31 3 2 5 1 11 12 22 21"}, {}};
  };
  EXPECT_TRUE(cells_with_bad_corners(read(drawn_in("0.6"))).empty());
  const CellMesh mesh = read(drawn_in("0.45"));
  EXPECT_EQ(cells_with_bad_corners(mesh), (std::vector<int>{0}));
  EXPECT_NEAR(
      smallest_corner_jacobian({2, {mesh.vertices[0], mesh.vertices[1], mesh.vertices[3], mesh.vertices[2]}}),
      2 * 0.45 - 1, 1e-12);
  EXPECT_EQ(complaint(drawn_in("0.1")),
            "cell 31 of FILE is folded or flat (its Jacobian is not positive at every Gauss point); expected "
            "convex cells");
  EXPECT_EQ(complaint({{"11 0 0 0", "12 1 0 0", "22 1 1 0"}, {"31 3 2 5 1 11 12 22 22"}, {}}),
            "cell 31 of FILE uses vertex 22 twice; expected 4 different corners");
  EXPECT_EQ(complaint({{"11 0 0 0", "12 1 0 0", "21 0 1 0", "22 0 1 0"}, {"31 3 2 5 1 11 12 22 21"}, {}}),
            "cell 31 of FILE has two corners at one place, (0, 1000) mm, vertices 21 and 22; expected 4 "
            "different corners");
}

}  // namespace
}  // namespace femsph
