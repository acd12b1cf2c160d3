// The grid of a body is the one that deal.II makes, vertex by vertex and to the last bit: boxes, shapes that
// are cut into cells, and meshes whose cells start at any corner, so that deal.II turns them.

#include <gtest/gtest.h>

#include <random>

#include "fem/mesh/deal_ii.hpp"
#include "fem/mesh/grid.hpp"
#include "fem_support.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/disc.hpp"
#include "model/scene/shapes/mesh.hpp"
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

/// A lattice of cells, each turned at random about its axes, and one vertex that no cell uses.
CellMesh turned_cells(int dim, std::array<int, 3> n, unsigned seed) {
  std::mt19937 random(seed);
  CellMesh mesh;
  mesh.dim = dim;
  if (dim == 2) n[2] = 0;
  mesh.vertices.push_back({9, 9, 0});
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) mesh.vertices.push_back({1.1 * i, 0.9 * j, 1.3 * k});
  const std::array<int, 8> about_z{1, 3, 0, 2, 5, 7, 4, 6}, about_x{2, 3, 6, 7, 0, 1, 4, 5};
  for (int k = 0; k < std::max(1, n[2]); ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 8> cell{};
        for (int a = 0; a < 1 << dim; ++a)
          cell[a] = 1 + i + (a & 1) + (n[0] + 1) * (j + (a >> 1 & 1) + (n[1] + 1) * (k + (a >> 2)));
        for (int turn = static_cast<int>(random() % 16); turn > 0; --turn) {
          const auto& place = dim == 3 && random() % 2 ? about_x : about_z;
          std::array<int, 8> turned{};
          for (int a = 0; a < 1 << dim; ++a) turned[a] = cell[place[a]];
          cell = turned;
        }
        mesh.cells.push_back(cell);
      }
  return mesh;
}

// Cells whose shared edges do not agree are turned by deal.II; those that agree are left alone by both.
TEST(FemGrid, CellsThatStartAnywhereAreTurnedAsDealIITurnsThem) {
  int differently_given = 0;
  for (unsigned seed = 1; seed < 20; ++seed)
    for (const int dim : {2, 3}) {
      const CellMesh mesh = turned_cells(dim, {4, 3, 2}, seed);
      expect_grid_of_deal_ii(MeshShape(mesh, "turned"), {});
      const CellMesh once = fem::make_grid(MeshShape(mesh, "turned"), {});
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        differently_given += once.cells[c][0] + 1 != mesh.cells[c][0];
    }
  EXPECT_GT(differently_given, 100);
}

}  // namespace
}  // namespace femsph::test
