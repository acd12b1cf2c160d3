// Groups of a mesh as places of a scene, and messages about the mesh of a scene.

#include <gtest/gtest.h>

#include <fstream>

#include "model_faults.hpp"
#include "model_mesh_text.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using namespace mesh_text;
using namespace scene_text;
using test::message_of;

std::string scene_at(const std::string& at, const std::string& more = "") {
  return model("stress") + material("m", "elastic", "1 GPa", "0.3", "1000 kg/m^3") +
         "[bodies.b]\nshape = \"mesh\"\nfile = \"" + file +
         "\"\nunit = \"m\"\nthickness = \"1 m\"\nmaterial = \"m\"\n" + more + load(at, "1 0 N") +
         scene_text::time("1 s");
}

/// The sides of the place, "+" between them; or the message.
std::string place(const std::string& at) {
  try {
    const Scene scene = parse_scene(scene_at(at), "s");
    std::string all;
    for (const auto& side : scene.loads[0].place.sides) all += (all.empty() ? "" : "+") + side;
    return all;
  } catch (const InputError& e) {
    return without_file(e.what());
  }
}

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

// Ambiguous names, and groups that are no sides, are faults only where a scene uses them.
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

// What follows from a fault is not reported beside it.
TEST(MeshReader, OneCauseOneMessage) {
  std::string text = replaced(scene_at("anything"), "force = [\"1 N\", \"0 N\"]", "pressure = \"1 MPa\"");
  text = replaced(text, file, "none.msh");
  EXPECT_EQ(message_of(text, "s"), "s:10:8: no such file \"none.msh\"; expected a .msh file of Gmsh");
  const std::string plane =
      model("plain") + material("m", "elastic", "1 GPa", "0.3", "1000 kg/m^3") +
      box("b", "1 1 m", thick("1 m"), "m") +
      "[bodies.r]\nshape = \"disc\"\ncentre = [\"0 m\", \"3 m\"]\nradius = \"1 m\"\n" + rigid("1 kg") +
      "[[supports]]\nbody = \"r\"\nfix = [\"turn\"]\n[[loads]]\nbody = \"b\"\nat = \"x+\"\npressure = \"1 "
      "MPa\"\n"
      "[[initial]]\nbody = \"r\"\nspin = \"1 rad/s\"\n" +
      scene_text::time("1 s");
  EXPECT_EQ(
      message_of(plane, "s"), "s:2:9: \"plane\" is \"plain\"; expected \"stress\", \"strain\" or \"none\"");
}

}  // namespace
}  // namespace femsph
