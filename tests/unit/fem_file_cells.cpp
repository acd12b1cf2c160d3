// Cells of a mesh file: they keep the numbers of the file through every reordering, and a cell whose Jacobian
// is negative at a corner but positive at the Gauss points works with all elements. The mesh is the seven
// bricks in a unit cube of R. H. MacNeal and R. L. Harder, Finite Elem. Anal. Des. 1 (1985) 3: with their
// coordinates, brick 4 has J = -0.013 at a corner.

#include <gtest/gtest.h>

#include "fem/mesh/mesh.hpp"
#include "fem_support.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/mesh_check.hpp"

namespace femsph::test {
namespace {

CellMesh seven_bricks() {
  CellMesh mesh;
  mesh.dim = 3;
  mesh.vertices = {{.249, .342, .192}, {.826, .288, .288}, {.850, .649, .263}, {.273, .750, .230},
                   {.320, .186, .643}, {.677, .305, .683}, {.788, .693, .644}, {.165, .745, .702},
                   {0, 0, 0},          {1, 0, 0},          {1, 1, 0},          {0, 1, 0},
                   {0, 0, 1},          {1, 0, 1},          {1, 1, 1},          {0, 1, 1}};
  const int around[7][8] = {
      {1, 2, 3, 4, 5, 6, 7, 8},    {9, 10, 11, 12, 1, 2, 3, 4},  {13, 14, 15, 16, 5, 6, 7, 8},
      {9, 10, 14, 13, 1, 2, 6, 5}, {10, 11, 15, 14, 2, 3, 7, 6}, {11, 12, 16, 15, 3, 4, 8, 7},
      {12, 9, 13, 16, 4, 1, 5, 8}};
  for (int c = 0; c < 7; ++c) {
    std::array<int, 8> cell{};
    for (int v = 0; v < 8; ++v) cell[std::array{0, 1, 3, 2, 4, 5, 7, 6}[v]] = around[c][v] - 1;
    mesh.cells.push_back(cell);
    mesh.cell_numbers.push_back(std::size_t(101 + 10 * c));
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertex_numbers.push_back(v + 1);
  check_mesh(mesh, {}, "bricks");
  return mesh;
}

TEST(FileCells, KeepTheirNumbers) {
  const CellMesh bricks = seven_bricks();
  const fem::Mesh mesh = fem::make_mesh(MeshShape(bricks, "bricks"), {}, 0.0);
  ASSERT_EQ(mesh.cell_numbers.size(), 7u);
  for (std::size_t c = 0; c < 7; ++c) {
    const std::size_t own = (mesh.cell_numbers[c] - 101) / 10;
    Point here{}, there{};
    for (int a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d)
        here[d] += mesh.node(std::size_t(mesh.cell(c)[a]))[d],
            there[d] += bricks.vertices[bricks.cells[own][a]][d];
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(here[d], there[d], 1e-14) << "the same eight corners";
  }
}

TEST(FileCells, AreNamedByTheirNumbers) {
  const Scene scene = scene_of(std::make_shared<MeshShape>(seven_bricks(), "bricks"), Plane::none, 1e9, 0.25);
  const auto fem = fem::discretize(scene, 0, {});
  // The inner brick is turned inside out; those around it grow.
  const auto u = field(*fem, [](const Point& x) {
    const bool inner = x[0] > 0 && x[0] < 1;
    return inner ? Point{2 * (0.5 - x[0]), 2 * (0.5 - x[1]), 2 * (0.5 - x[2])} : Point{};
  });
  const auto trouble = fem->trouble(u.data());
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->what.substr(0, trouble->what.find(" has turned")), "cell 101");
}

TEST(FileCells, OneThatIsNotConvexWorksInEveryElement) {
  const CellMesh bricks = seven_bricks();
  EXPECT_EQ(cells_with_bad_corners(bricks), (std::vector<int>{3}));
  const Scene scene = scene_of(std::make_shared<MeshShape>(bricks, "bricks"), Plane::none, 1e9, 0.25);
  const std::array<Point, 3> H{Point{2e-3, 1e-3, -3e-3}, Point{-4e-3, 5e-3, 2e-3}, Point{1e-3, 6e-3, -2e-3}};
  for (const Element element : all_elements) {
    fem::Options options;
    options.element = element;
    const auto fem = fem::discretize(scene, 0, options);
    double mass = 0;
    for (const double m : fem->mass()) {
      EXPECT_GT(m, 0);
      mass += m;
    }
    EXPECT_NEAR(mass, 7850, 1e-9);
    const auto u = field(*fem, [&](const Point& x) {
      Point v{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) v[i] += H[i][j] * x[j];
      return v;
    });
    for (const auto& e : state_of(*fem, u).strain) {  // patch test: the gradient is exact everywhere
      EXPECT_NEAR(e[0], H[0][0], 1e-14);
      EXPECT_NEAR(e[3], 0.5 * (H[0][1] + H[1][0]), 1e-14);
    }
    const auto f = force(*fem, u);  // and constant stress gives no force on inner nodes
    for (std::size_t i = 0; i < fem->layout().points; ++i)
      if (const Point x = fem->position(i); x[0] > 0 && x[0] < 1) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[fem->layout().at(i, c)], 0, 1e-10 * largest(f));
      }
    // Points of this brick are found, near its bad corner (vertex 1) as well.
    for (const Point& p :
         {bricks.vertices[0], Point{.249, .34, .192}, Point{.249, .342, .2}, Point{.26, .33, .19}}) {
      const auto weights = fem->interpolation(p);
      Point x{};
      for (const Weight& w : weights)
        for (int c = 0; c < 3; ++c) x[c] += w.weight * fem->position(w.point)[c];
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(x[c], p[c], 1e-6);
    }
  }
}

}  // namespace
}  // namespace femsph::test
