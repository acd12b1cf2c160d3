// The grid of a body is the one that deal.II makes, vertex by vertex and to the last bit: of boxes, of shapes
// that are cut into cells, and of meshes whose shared edges agree. Other meshes are turned by deal.II.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "fem/mesh/deal_ii.hpp"
#include "fem/mesh/grid.hpp"
#include "fem_support.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/disc.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/multilinear.hpp"
#include "model/scene/shapes/quadrilateral.hpp"
#include "model/scene/shapes/round.hpp"

namespace femsph::test {
namespace {

void expect_grid_of_deal_ii(const Shape& shape, const std::array<int, 3>& divisions) {
  const CellMesh own = fem::make_grid(shape, divisions), other = fem::deal_ii().grid(shape, divisions, 0.0);
  EXPECT_EQ(own.dim, other.dim);
  EXPECT_EQ(own.vertices, other.vertices) << shape.describe();
  EXPECT_EQ(own.cells, other.cells) << shape.describe();
}

TEST(FemGrid, BoxesAndCutShapesAreDealIIs) {
  expect_grid_of_deal_ii(Box(2, {0.1, -0.7, 0}, {1.3, 0.37, 0}), {7, 5, 0});
  expect_grid_of_deal_ii(Box(3, {0.1, -0.7, 0.03}, {1.3, 0.37, 0.91}), {7, 5, 3});
  expect_grid_of_deal_ii(Round(2, {{0.2, 0.1, 0}, 0.1, 0.5}), {4, 12, 0});
  expect_grid_of_deal_ii(Ball(2, {0.2, 0.1, 0}, 0.5), {4, 4, 0});
}

using Cell = std::array<int, 8>;

/// The cell from another corner: turned by 90 degrees about z or x.
Cell turned(const Cell& cell, int dim, bool about_x) {
  constexpr Cell z{1, 3, 0, 2, 5, 7, 4, 6}, x{2, 3, 6, 7, 0, 1, 4, 5};
  Cell out{};
  for (int a = 0; a < 1 << dim; ++a) out[a] = cell[about_x ? x[a] : z[a]];
  return out;
}

/// A lattice of 4 x 3 (x 2) cells, and one vertex, the first, that no cell uses.
CellMesh lattice(int dim) {
  const std::array<int, 3> n{4, 3, dim == 3 ? 2 : 0};
  CellMesh mesh;
  mesh.dim = dim;
  mesh.vertices.push_back({9, 9, 0});
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) mesh.vertices.push_back({1.1 * i, 0.9 * j, 1.3 * k});
  for (int k = 0; k < std::max(1, n[2]); ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        Cell cell{};
        for (int a = 0; a < 1 << dim; ++a)
          cell[a] = 1 + i + (a & 1) + (n[0] + 1) * (j + (a >> 1 & 1) + (n[1] + 1) * (k + (a >> 2)));
        mesh.cells.push_back(cell);
      }
  return mesh;
}

// All cells start at the same other corner: their shared edges agree in direction, so deal.II leaves them as
// they are, and so must the grid that is made without deal.II.
TEST(FemGrid, CellsWhoseEdgesAgreeAreLeftAsTheyAre) {
  for (const int dim : {2, 3})
    for (int turn = 0; turn < (dim == 3 ? 16 : 4); ++turn) {
      CellMesh mesh = lattice(dim);
      for (Cell& cell : mesh.cells) {
        for (int k = 0; k < turn % 4; ++k) cell = turned(cell, dim, false);
        for (int k = 0; k < turn / 4; ++k) cell = turned(cell, dim, true);
      }
      EXPECT_TRUE(fem::edges_agree(mesh));
      expect_grid_of_deal_ii(MeshShape(mesh, "turned"), {});
      const CellMesh grid = fem::make_grid(MeshShape(mesh, "turned"), {});
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (int a = 0; a < 1 << dim; ++a) EXPECT_EQ(grid.cells[c][a] + 1, mesh.cells[c][a]);
    }
}

// Each cell starts at a corner of its own: their shared edges disagree, and the grid has the same cells, by
// deal.II, turned so that the edges agree.
TEST(FemGrid, CellsWhoseEdgesDisagreeAreTurned) {
  for (unsigned seed = 1; seed < 20; ++seed)
    for (const int dim : {2, 3}) {
      std::mt19937 random(seed);
      CellMesh mesh = lattice(dim);
      for (Cell& cell : mesh.cells)
        for (int k = static_cast<int>(random() % 16); k > 0; --k)
          cell = turned(cell, dim, dim == 3 && random() % 2 != 0);
      ASSERT_FALSE(fem::edges_agree(mesh));
      const CellMesh grid = fem::make_grid(MeshShape(mesh, "turned"), {});
      EXPECT_TRUE(fem::edges_agree(grid));
      ASSERT_EQ(grid.cells.size(), mesh.cells.size());
      ASSERT_EQ(grid.vertices.size() + 1, mesh.vertices.size());
      for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        std::set<Point> given, made;
        Patch patch{dim, {}};
        for (int a = 0; a < 1 << dim; ++a) {
          given.insert(mesh.vertices[mesh.cells[c][a]]), made.insert(grid.vertices[grid.cells[c][a]]);
          patch.corners[a] = grid.vertices[grid.cells[c][a]];
        }
        EXPECT_EQ(given, made) << "seed " << seed << ", cell " << c;
        EXPECT_GT(measure(patch), 0);
      }
    }
}

}  // namespace
}  // namespace femsph::test
