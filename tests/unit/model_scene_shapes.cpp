// Shapes: points inside, sides. Meshes from Gmsh: cells of positive volume. The mesh files are written by
// hand:
//   l_shape.msh    three unit squares of (0,2)^2 without its upper right quarter, one of them clockwise, one
//   vertex unused; two_hexes.msh  (0,2) x (0,1) x (0,1) sheared by x += z/2, its second cell with the top
//   below the bottom.

#include <gmock/gmock.h>
#include <gmsh.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <stdexcept>

#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/child.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "model_faults.hpp"

using namespace femsph;
using testing::ElementsAre;

namespace {

using test::scenes_folder;
constexpr double near = 1e-9;

MeshShape l_shape() { return {read_gmsh(scenes_folder + "l_shape.msh", 2, 1e-3), "l_shape.msh"}; }
MeshShape two_hexes() { return {read_gmsh(scenes_folder + "two_hexes.msh", 3, 1.0), "two_hexes.msh"}; }

std::string complaint(const std::string& file, int dim) {
  try {
    read_gmsh(scenes_folder + file, dim, 1.0);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

Patch patch_of(const CellMesh& mesh, int cell) {
  Patch patch{mesh.dim, {}};
  for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[mesh.cells[cell][v]];
  return patch;
}

}  // namespace

TEST(Box, HoldsItsPointsAndNamesItsSides) {
  const Box box(3, {0, 1, 2}, {3, 4, 5});
  EXPECT_TRUE(box.contains({3, 5, 7}, 0));
  EXPECT_FALSE(box.contains({3, 5, 7.1}, 0.05));
  EXPECT_TRUE(box.contains({3, 5, 7.1}, 0.2));
  EXPECT_THAT(box.sides(), ElementsAre("x-", "x+", "y-", "y+", "z-", "z+"));
  EXPECT_TRUE(box.on_side("z+", {1, 2, 7}, near));
  EXPECT_FALSE(box.on_side("z-", {1, 2, 7}, near));
  EXPECT_EQ(box.measure(), 60);
  EXPECT_THROW(Box(2, {}, {1, 1}).on_side("z-", {}, near), std::invalid_argument);
}

TEST(MeshShape, PlaneMeshHoldsWhatItsCellsHold) {
  const MeshShape shape = l_shape();
  EXPECT_EQ(shape.cells()->vertices.size(), 8u) << "the unused vertex is gone";
  EXPECT_DOUBLE_EQ(shape.upper()[0], 2e-3);
  EXPECT_DOUBLE_EQ(shape.measure(), 3e-6);
  EXPECT_TRUE(shape.contains({0.5e-3, 1.5e-3, 0}, near));
  EXPECT_TRUE(shape.contains({1e-3, 1e-3, 0}, near));
  EXPECT_FALSE(shape.contains({1.5e-3, 1.5e-3, 0}, near)) << "the quarter that is missing";
  EXPECT_FALSE(shape.contains({1.01e-3, 1.01e-3, 0}, near));
  EXPECT_TRUE(shape.contains({1.01e-3, 1.01e-3, 0}, 0.02e-3));
  EXPECT_FALSE(shape.contains({-1, 7, 0}, near));
}

TEST(MeshShape, SidesAreTheBoundingBoxAndThePhysicalGroups) {
  const MeshShape shape = l_shape();
  EXPECT_THAT(shape.sides(), ElementsAre("x-", "x+", "y-", "y+", "foot", "notch"));
  EXPECT_TRUE(shape.on_side("foot", {0.3e-3, 0, 0}, near));
  EXPECT_FALSE(shape.on_side("foot", {0.3e-3, 1e-3, 0}, near));
  EXPECT_TRUE(shape.on_side("notch", {1e-3, 1.7e-3, 0}, near));
  EXPECT_TRUE(shape.on_side("notch", {1e-3, 1e-3, 0}, near));
  EXPECT_FALSE(shape.on_side("notch", {1e-3, 0.9e-3, 0}, near));
  EXPECT_TRUE(shape.on_side("y+", {0.5e-3, 2e-3, 0}, near));
}

TEST(MeshShape, CellsAreLexicographicAndPositive) {
  const MeshShape plane = l_shape(), space = two_hexes();
  for (int cell = 0; cell < 3; ++cell)
    EXPECT_NEAR(smallest_corner_jacobian(patch_of(*plane.cells(), cell)), 1e-6, 1e-18);
  for (int cell = 0; cell < 2; ++cell)
    EXPECT_NEAR(smallest_corner_jacobian(patch_of(*space.cells(), cell)), 1.0, 1e-12);
}

TEST(MeshShape, HexahedraInSpace) {
  const MeshShape shape = two_hexes();
  EXPECT_NEAR(shape.measure(), 2, 1e-14) << "shear keeps the volume";
  EXPECT_TRUE(shape.contains({0.45, 0.5, 0.85}, near));
  EXPECT_FALSE(shape.contains({0.40, 0.5, 0.85}, near)) << "outside of the slanted face x = z/2";
  EXPECT_TRUE(shape.contains({2.5, 1, 1}, near));
  EXPECT_TRUE(shape.on_side("clamp", {0.25, 0.3, 0.5}, near));
  EXPECT_FALSE(shape.on_side("clamp", {0.35, 0.3, 0.5}, near));
}

TEST(Multilinear, FindsPointsOfADistortedHexahedron) {
  const Patch patch{
      3,
      {{{0, 0, 0},
        {2, .2, -.1},
        {-.2, 1, 0},
        {1.7, 1.4, .2},
        {.1, .1, 1},
        {2.2, 0, .8},
        {0, 1.1, 1.3},
        {1.5, 1, 1}}}};
  ASSERT_GT(smallest_corner_jacobian(patch), 0);
  for (int i = 0; i <= 64; ++i) {
    const std::array<double, 3> xi = {(i % 5) / 4.0, (i / 5 % 5) / 4.0, (i / 25) / 2.0};
    EXPECT_LT(distance(patch, patch.at(xi)), 1e-12);
  }
  EXPECT_NEAR(distance(patch, {-.3, 0, 0}), .3, .05);
}

TEST(Gmsh, RefusesOtherCellsWithOneSentence) {
  const std::string quads = "linear quadrilaterals (in Gmsh: Recombine Surface, first order)";
  EXPECT_EQ(
      complaint("triangles.msh", 2),
      "\"" + scenes_folder + "triangles.msh\" holds cells of type \"Triangle 3\"; expected only " + quads);
  EXPECT_EQ(complaint("two_hexes.msh", 2),
            "\"" + scenes_folder +
                "two_hexes.msh\" holds cells of type \"Hexahedron 8\" in a plane scene; expected " + quads);
  EXPECT_EQ(complaint("l_shape.msh", 3),
            "\"" + scenes_folder +
                "l_shape.msh\" holds no 3-dimensional cells; expected linear "
                "hexahedra (in Gmsh: transfinite or extruded recombined "
                "volumes, first order)");
  EXPECT_EQ(complaint("bow_tie.msh", 2), "cell 1 of \"" + scenes_folder +
                                             "bow_tie.msh\" is folded or flat (its Jacobian is not positive "
                                             "at every Gauss point); expected convex cells");
  EXPECT_EQ(complaint("upright.msh", 2),
            "\"" + scenes_folder + "upright.msh\" leaves the plane z = 0; expected a plane mesh in x and y");
  EXPECT_EQ(complaint("none.msh", 2),
            "no such file \"" + scenes_folder + "none.msh\"; expected a .msh file of Gmsh");
  EXPECT_EQ(complaint("not_a_mesh.msh", 2),
            "\"" + scenes_folder + "not_a_mesh.msh\" is not a .msh file; expected a mesh saved by Gmsh");
  EXPECT_EQ(complaint("cantilever.toml", 2),
            "\"" + scenes_folder + "cantilever.toml\" is not a .msh file; expected a mesh saved by Gmsh");
}

TEST(Gmsh, EveryVersionOfTheFormat) {
  const CellMesh original = read_gmsh(scenes_folder + "l_shape.msh", 2, 1.0);
  for (const double version : {1.0, 2.2, 4.0, 4.1})
    for (const double binary : {0.0, 1.0}) {
      if (version == 4.0 && binary == 1.0) continue;  // Gmsh does not write it
      const std::string file = testing::TempDir() + "femsph_l_shape_again.msh";
      gmsh::initialize(0, nullptr, false);
      gmsh::option::setNumber("General.Terminal", 0);
      gmsh::open(scenes_folder + "l_shape.msh");
      gmsh::option::setNumber("Mesh.MshFileVersion", version);
      gmsh::option::setNumber("Mesh.Binary", binary);
      gmsh::write(file);
      gmsh::finalize();
      const CellMesh again = read_gmsh(file, 2, 1.0);
      EXPECT_EQ(again.vertices, original.vertices) << version;
      EXPECT_EQ(again.cells, original.cells) << version;
      EXPECT_EQ(again.facets.size(), 4u) << version;
      EXPECT_EQ(again.groups.size(), 2u) << version;
    }
}

TEST(Gmsh, MeshWithoutGroups) {
  const CellMesh mesh = read_gmsh(scenes_folder + "no_groups.msh", 2, 1.0);
  EXPECT_EQ(mesh.cells.size(), 2u);
  EXPECT_EQ(mesh.facets.size(), 0u);
  EXPECT_EQ(mesh.groups.size(), 0u);
  EXPECT_DOUBLE_EQ(MeshShape(mesh, "no_groups.msh").measure(), 6);
}

// Gmsh itself does not survive all of these: each damaged file is read, or refused with one sentence that
// names it.
TEST(GmshSlow, DamagedFilesAreRefusedWithOneSentence) {
  const std::string file = testing::TempDir() + "femsph_damaged.msh";
  const auto content = [](const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  std::array<std::string, 3> originals = {
      content(scenes_folder + "l_shape.msh"), content(scenes_folder + "two_hexes.msh")};
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(scenes_folder + "l_shape.msh");
  gmsh::option::setNumber("Mesh.Binary", 1);
  gmsh::write(file);
  gmsh::finalize();
  originals[2] = content(file);
  std::mt19937 random(11);
  int refused = 0;
  // Read in the dimension of the undamaged mesh: in the other one, all are refused for their cells.
  const auto try_to_read = [&](const std::string& bytes, int dim) {
    std::ofstream(file, std::ios::binary) << bytes;
    try {
      read_gmsh(file, dim, 1.0);
    } catch (const std::runtime_error& e) {
      ++refused;
      EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("femsph_damaged.msh"),
                                           testing::Not(testing::HasSubstr("\n"))));
    }
  };
  for (std::size_t mesh = 0; mesh < originals.size(); ++mesh)
    for (int k = 0; k < 30; ++k) {
      std::string bytes = originals[mesh];
      const std::size_t at =
          12 +
          random() % (bytes.size() - 12);  // behind "$MeshFormat", without which no file gets as far as Gmsh
      if (k % 3 == 0)
        bytes.resize(at);
      else if (k % 3 == 1)
        bytes[at] = char(random());
      else
        bytes.insert(at, "99999999999");
      try_to_read(bytes, mesh == 1 ? 3 : 2);
    }
  RecordProperty("refused", refused);
  EXPECT_GT(refused, 45);
  std::string lengths = originals[0];  // a number of nodes beyond any memory
  lengths.insert(lengths.find("$Nodes") + 7, "99999999");
  try_to_read(lengths, 2);
}

TEST(Gmsh, RefusesWhatIsNoFile) {
  const std::string pipe = testing::TempDir() + "femsph_pipe.msh";
  std::remove(pipe.c_str());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(read_gmsh(pipe, 2, 1.0), std::runtime_error);
  EXPECT_THROW(read_gmsh("/dev/zero", 2, 1.0), std::runtime_error);
  EXPECT_THROW(read_gmsh("/", 2, 1.0), std::runtime_error);
  std::remove(pipe.c_str());
}

// A library that crashes, hangs or takes all memory ends the child process alone.
TEST(Child, HandsBackWhatItMadeOrNothing) {
  std::string result;
  const ChildLimits limits{1, std::size_t(64) << 20};
  EXPECT_TRUE(in_child([] { return std::string(1 << 20, 'a'); }, limits, result));
  EXPECT_EQ(result, std::string(1 << 20, 'a'));
  EXPECT_FALSE(in_child([]() -> std::string { std::abort(); }, limits, result));
  EXPECT_FALSE(in_child([]() -> std::string { throw std::runtime_error("no"); }, limits, result));
  EXPECT_FALSE(in_child(
      []() -> std::string {
        for (std::atomic<long> k = 0;;) ++k;
      },
      limits, result));
}

TEST(Gmsh, StaysSilent) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  complaint("l_shape.msh", 2);
  complaint("triangles.msh", 2);
  complaint("not_a_mesh.msh", 2);
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}
