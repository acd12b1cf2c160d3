// What the look at a mesh finds, and what places can call its groups. Every mesh is written here: unit
// squares (cubes), numbered as no program numbers by itself, so that a message with the file's own numbers
// cannot come from an index.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "model/scene/reader/reader.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/mesh_check.hpp"
#include "model/scene/shapes/multilinear.hpp"

using namespace femsph;

namespace {

const std::string file = testing::TempDir() + "femsph_mesh_" + std::to_string(getpid()) +
                         ".msh";  // tests run side by side

/// A mesh of version 2.2: lines as they stand in the file.
struct Text {
  std::vector<std::string> nodes, elements, names;

  void write(std::size_t announced_elements = 0) const {
    std::ofstream out(file);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    if (!names.empty()) out << "$PhysicalNames\n" << names.size() << '\n';
    for (const auto& name : names) out << name << '\n';
    if (!names.empty()) out << "$EndPhysicalNames\n";
    out << "$Nodes\n" << nodes.size() << '\n';
    for (const auto& node : nodes) out << node << '\n';
    out << "$EndNodes\n$Elements\n" << (announced_elements ? announced_elements : elements.size()) << '\n';
    for (const auto& element : elements) out << element << '\n';
    out << "$EndElements\n";
  }
};

CellMesh read(const Text& text, int dim = 2, const MeshOptions& options = {}) {
  text.write();
  return read_gmsh(file, dim, 1.0, options);
}

/// The message without the quoted file, which FILE stands for.
std::string complaint(const Text& text, int dim = 2, const MeshOptions& options = {},
                      std::size_t announced = 0) {
  try {
    text.write(announced);
    read_gmsh(file, dim, 1.0, options);
  } catch (const std::runtime_error& e) {
    std::string what = e.what();
    for (std::size_t at; (at = what.find('"' + file + '"')) != std::string::npos;)
      what.replace(at, file.size() + 2, "FILE");
    return what;
  }
  return "";
}

/// (0, 2) x (0, 1) of two squares, 31 and 32, with a line on the left and on the right.
Text two_squares() {
  return {{"11 0 0 0", "12 1 0 0", "13 2 0 0", "21 0 1 0", "22 1 1 0", "23 2 1 0"},
          {"31 3 2 5 1 11 12 22 21", "32 3 2 5 1 12 13 23 22", "41 1 2 1 7 11 21", "42 1 2 2 8 13 23"},
          {"1 1 \"left\"", "1 2 \"right\"", "2 5 \"plate\""}};
}

/// The same, its squares joined by nothing: the right one has the vertices 52 and 53 on 12 and 22.
Text doubled(const std::string& x = "1") {
  return {{"11 0 0 0", "12 1 0 0", "13 2 0 0", "21 0 1 0", "22 1 1 0", "23 2 1 0", "52 " + x + " 0 0",
           "53 " + x + " 1 0"},
          {"31 3 2 5 1 11 12 22 21", "32 3 2 5 1 52 13 23 53"},
          {}};
}

/// Two cubes on each other, whose common face each has for itself.
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

}  // namespace

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

namespace {

std::string scene_at(const std::string& at, const std::string& more = "") {
  return "[model]\nplane = \"stress\"\n[materials.m]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = "
         "0.3\ndensity = \"1000 kg/m^3\"\n"
         "[bodies.b]\nshape = \"mesh\"\nfile = \"" +
         file + "\"\nunit = \"m\"\nthickness = \"1 m\"\nmaterial = \"m\"\n" + more + "[[loads]]\nat = \"" +
         at + "\"\nforce = [\"1 N\", \"0 N\"]\n[time]\nduration = \"1 s\"\n";
}

/// The sides of the place, "+" between them; or the message.
std::string place(const std::string& at) {
  try {
    const Scene scene = parse_scene(scene_at(at), "s");
    std::string all;
    for (const auto& side : scene.loads[0].place.sides) all += (all.empty() ? "" : "+") + side;
    return all;
  } catch (const InputError& e) {
    std::string what = e.what();
    for (std::size_t i; (i = what.find('"' + file + '"')) != std::string::npos;)
      what.replace(i, file.size() + 2, "FILE");
    return what;
  }
}

}  // namespace

TEST(MeshGroups, ByNameAndByNumber) {
  Text text = two_squares();
  text.write();
  EXPECT_EQ(place("right"), "right");
  EXPECT_EQ(place("2"), "right") << "a group with a name, by its number";
  EXPECT_EQ(place("2 y-"), "right+y-");
  EXPECT_EQ(place("plate"),
            "s:15:6: physical group 5 of FILE holds cells and no sides of cells; expected a group of lines");
  EXPECT_EQ(
      place("5"),
      "s:15:6: unknown side \"5\"; expected \"x-\", \"x+\", \"y-\", \"y+\", \"left\", \"right\" or \"all\"");
  text.names.clear();
  text.write();
  EXPECT_EQ(place("1"), "1");
  text.names = {"1 1 \"the left\"", "1 2 \"x- y-\""};
  text.write();
  EXPECT_EQ(place("the left"), "the left") << "a name with a blank";
  EXPECT_EQ(place("x- y-"),
            "s:15:6: \"x- y-\" is the name of a physical group, and several sides; expected the group's "
            "number, or another name for it");
  EXPECT_EQ(place("2"), "x- y-");
}

// Names that could mean two things, and groups that are no sides, harm nobody who does not use them.
TEST(MeshGroups, WordsThatMeanTwoThings) {
  Text text = two_squares();
  text.nodes.insert(text.nodes.end(), {"98 5 5 0", "99 6 5 0"});
  text.elements.insert(text.elements.end(),
                       {"43 1 2 3 9 11 12", "44 1 2 4 10 98 99", "45 1 2 6 11 21 22", "46 1 2 7 12 11 22"});
  text.names = {"1 1 \"left\"", "1 2 \"x+\"", "1 3 \"all\"",  "1 4 \"axis\"",
                "1 6 \"left\"", "1 7 \"y+\"", "2 5 \"plate\""};
  text.write();
  EXPECT_EQ(place("y-"), "y-");
  EXPECT_EQ(place("x+"), "x+") << "the group of this name is this side";
  EXPECT_EQ(place("left"),
            "s:15:6: \"left\" means physical groups 1 (lines) and 6 (lines) of FILE; expected the number of "
            "a group of lines, \"1\" or \"6\", or names that differ");
  EXPECT_EQ(place("6"), "6");
  EXPECT_EQ(place("all"),
            "s:15:6: \"all\" is the whole body and, in FILE, the name of physical group 3 (lines); expected "
            "the group's number, or another name for it");
  EXPECT_EQ(place("3"), "3");
  EXPECT_EQ(place("axis"),
            "s:15:6: physical group 4 of FILE holds element 44, which is the side of no cell; expected sides "
            "of cells alone");
  EXPECT_EQ(place("7"),
            "s:15:6: physical group 7 of FILE holds element 46, which is the side of no cell; expected sides "
            "of cells alone")
      << "a diagonal";
  text.names = {"1 1 \"one\"", "1 1 \"another\""};
  text.write();
  EXPECT_EQ(
      place("one"),
      "s:15:6: \"one\" is one of several names of physical group 1 of FILE; expected its number, \"1\"");
  EXPECT_EQ(place("1"), "1");
}

// Other programs give all lines one elementary number: Gmsh then takes both groups for each other.
TEST(MeshGroups, TwoGroupsOfOneEntity) {
  Text text = two_squares();
  text.elements[2] = "41 1 2 1 7 11 21", text.elements[3] = "42 1 2 2 7 13 23";
  const MeshShape shape(read(text), "");
  EXPECT_TRUE(shape.on_side("left", {0, 0.5, 0}, 1e-9));
  EXPECT_FALSE(shape.on_side("left", {2, 0.5, 0}, 1e-9));
  EXPECT_TRUE(shape.on_side("right", {2, 0.5, 0}, 1e-9));
}

TEST(MeshReader, SaysWhatIsMeantAndWarns) {
  doubled().write();
  EXPECT_EQ(parse_scene(scene_at("x+", "pieces = 2\nopen_seams = true\n"), "s").bodies.size(), 1u);
  Text{{"11 0 0 0", "12 1 0 0", "21 0 1 0", "22 .45 .45 0"}, {"31 3 2 5 1 11 12 22 21"}, {}}.write();
  const Scene scene = parse_scene(scene_at("x-"), "s");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0],
            "s:10:8: one cell of the mesh is not convex (cell 31): sound at its Gauss points, folded or flat "
            "at a corner, where results are poor");
}

TEST(MeshReader, UpperCaseNamesAreNames) {
  const std::string upper = testing::TempDir() + "FEMSPH_MESH.MSH";
  two_squares().write();
  std::ofstream(upper) << std::ifstream(file).rdbuf();
  EXPECT_EQ(read_gmsh(upper, 2, 1.0).cells.size(), 2u);
}

namespace {

std::string message_of(const std::string& text) {
  try {
    parse_scene(text, "s");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

// What follows from a fault is not reported beside it.
TEST(MeshReader, OneCauseOneMessage) {
  std::string text = scene_at("anything");
  text.replace(text.find("force = [\"1 N\", \"0 N\"]"), 22, "pressure = \"1 MPa\"");
  text.replace(text.find(file), file.size(), "none.msh");
  EXPECT_EQ(message_of(text), "s:10:8: no such file \"none.msh\"; expected a .msh file of Gmsh");
  const std::string plane =
      "[model]\nplane = \"plain\"\n[materials.m]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = "
      "0.3\ndensity = \"1000 kg/m^3\"\n"
      "[bodies.b]\nshape = \"box\"\nsize = [\"1 m\", \"1 m\"]\nthickness = \"1 m\"\nmaterial = \"m\"\n"
      "[bodies.r]\nshape = \"disc\"\ncentre = [\"0 m\", \"3 m\"]\nradius = \"1 m\"\nrigid = true\nmass = \"1 "
      "kg\"\n"
      "[[supports]]\nbody = \"r\"\nfix = [\"turn\"]\n[[loads]]\nbody = \"b\"\nat = \"x+\"\npressure = \"1 "
      "MPa\"\n"
      "[[initial]]\nbody = \"r\"\nspin = \"1 rad/s\"\n[time]\nduration = \"1 s\"\n";
  EXPECT_EQ(message_of(plane), "s:2:9: \"plane\" is \"plain\"; expected \"stress\", \"strain\" or \"none\"");
}
