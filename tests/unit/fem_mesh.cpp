// Masses, places, interpolation, output cells: exact sums and linear completeness.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "fem_support.hpp"
#include "model/motion/effects/loads.hpp"
#include "model/motion/march.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/round.hpp"

namespace femsph::test {
namespace {

std::unique_ptr<Discretization> block(int dim, std::array<int, 3> divisions, double distortion,
                                      Element element = Element::full) {
  fem::Options options;
  options.element = element;
  options.divisions = divisions;
  options.distortion = distortion;
  return fem::discretize(box_scene(dim == 3 ? Plane::none : Plane::stress, {1.2, 0.8, dim == 3 ? 0.5 : 0.0},
                                   210e9, 0.3, dim == 3 ? 1.0 : 0.25),
                         0, options);
}

double weight_sum(const std::vector<Weight>& weights) {
  return std::accumulate(
      weights.begin(), weights.end(), 0.0, [](double s, const Weight& w) { return s + w.weight; });
}

Point centre_of(const Discretization& d, const std::vector<Weight>& weights) {
  Point p{};
  for (const Weight& w : weights)
    for (int c = 0; c < 3; ++c) p[c] += w.weight * d.position(w.point)[c];
  return p;
}

TEST(FemMass, TotalAndCentreAreExactOnDistortedCells) {
  for (const int dim : {2, 3}) {
    const auto d = block(dim, {6, 5, 4}, 0.2);
    const double total = 7850 * 1.2 * 0.8 * (dim == 3 ? 0.5 : 0.25);
    EXPECT_NEAR(std::accumulate(d->mass().begin(), d->mass().end(), 0.0), total, 1e-12 * total);
    const Point centre = centre_of(*d, d->points_of({0, {}, {}, {}}));  // the whole body: by mass
    EXPECT_NEAR(centre[0], 0.6, 1e-13);
    EXPECT_NEAR(centre[1], 0.4, 1e-13);
  }
}

TEST(FemMass, VolumesOfMaterialPointsFillTheBody) {
  for (const Element element : all_elements)
    for (const int dim : {2, 3}) {
      const auto d = block(dim, {4, 3, 3}, 0.2, element);
      double volume = 0, moment = 0;
      for (std::size_t i = 0; i < d->material_points(); ++i) {
        volume += d->material_volume(i);
        moment += d->material_volume(i) * d->material_position(i)[0];
      }
      EXPECT_NEAR(volume, 1.2 * 0.8 * (dim == 3 ? 0.5 : 0.25), 1e-13);
      EXPECT_NEAR(moment / volume, 0.6, element == Element::full || element == Element::sri ? 1e-13 : 0.01);
    }
}

// Lame's thick ring under inner pressure, one quarter between symmetry planes: nodal forces of the pressure,
// p r h dtheta each, balance the stress only if they are consistent: their resultant on a quarter is p r_i
// thickness along both axes, exactly (the projected length).
TEST(FemPressure, ResultantOnAQuarterRing) {
  Scene scene = scene_of(std::make_shared<Round>(2, Round::Size{{}, 0.1, 0.2, 0, 2, Round::Part::quarter}),
                         Plane::strain, 210e9, 0.3, 0.5);
  scene.loads.push_back({Place{0, {"inner"}, {}, {}}, {}, {}, 100e6});
  scene.duration = 1;
  fem::Options options;
  options.divisions = {10, 10, 0};
  std::vector<std::unique_ptr<Discretization>> bodies;
  bodies.push_back(fem::discretize(scene, 0, options));
  const March march(scene, std::move(bodies), {});
  Point sum{};
  const MovingBody& body = march.bodies()[0];
  for (const auto& load : march.effects().find<Loads>()->on(march.motion(), body))
    sum[load.slot % 2] += load.force;
  EXPECT_NEAR(sum[0], 100e6 * 0.1 * 0.5, 1e-6);
  EXPECT_NEAR(sum[1], 100e6 * 0.1 * 0.5, 1e-6);
}

TEST(FemPlaces, AUniformTractionActsAtTheMiddleOfItsPlace) {
  // Inner vertices moved, those of the boundary kept: 4 x 3 cells on the face x+, so interior nodes take
  // 1/12, edges 1/24, corners 1/48.
  const auto d = block(3, {5, 4, 3}, 0.2);
  const auto face = d->points_of({0, {"x+"}, {}, {}});
  EXPECT_EQ(face.size(), 20u);
  EXPECT_NEAR(weight_sum(face), 1, 1e-14);
  const Point middle = centre_of(*d, face);
  EXPECT_NEAR(middle[0], 1.2, 1e-14);
  EXPECT_NEAR(middle[1], 0.4, 1e-14);
  EXPECT_NEAR(middle[2], 0.25, 1e-14);
  for (const Weight& w : face) {
    const Point p = d->position(w.point);
    const bool edge_y = p[1] < 1e-9 || p[1] > 0.8 - 1e-9, edge_z = p[2] < 1e-9 || p[2] > 0.5 - 1e-9;
    EXPECT_NEAR(w.weight, (edge_y ? 0.5 : 1.0) * (edge_z ? 0.5 : 1.0) / 12, 1e-14);
  }
  EXPECT_TRUE(std::is_sorted(
      face.begin(), face.end(), [](const Weight& a, const Weight& b) { return a.point < b.point; }));

  const auto edge = d->points_of({0, {"x+", "y+"}, {}, {}});
  EXPECT_EQ(edge.size(), 4u);
  for (const Weight& w : edge) {
    const double z = d->position(w.point)[2];
    EXPECT_NEAR(w.weight, z < 1e-9 || z > 0.5 - 1e-9 ? 1.0 / 6 : 1.0 / 3, 1e-14);
  }
  const auto corner = d->points_of({0, {"x+", "y+", "z-"}, {}, {}});
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_EQ(corner[0].weight, 1.0);
  EXPECT_TRUE(d->points_of({0, {"x-", "x+"}, {}, {}}).empty());
}

TEST(FemPlaces, InThePlaneASideIsAnEdgeAndTwoSidesACorner) {
  const auto d = block(2, {6, 4, 0}, 0);
  const auto side = d->points_of({0, {"y+"}, {}, {}});
  EXPECT_EQ(side.size(), 7u);
  EXPECT_NEAR(weight_sum(side), 1, 1e-14);
  const auto corner = d->points_of({0, {"x+", "y+"}, {}, {}});
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_NEAR(d->position(corner[0].point)[0], 1.2, 1e-14);
  const auto near = d->points_of({0, {}, Point{0.61, 0.39, 0}, {}});
  ASSERT_EQ(near.size(), 1u);
  EXPECT_NEAR(d->position(near[0].point)[0], 0.6, 1e-14);
}

TEST(FemInterpolation, ReproducesLinearFieldsAndNeverExtrapolates) {
  for (const int dim : {2, 3}) {
    const auto d = block(dim, {6, 5, 4}, 0.2);
    const auto linear = [](const Point& x) { return Point{1 + 2 * x[0] - 3 * x[1] + x[2], x[1], x[2]}; };
    const auto u = field(*d, linear);
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 200; ++i) {
      const Point p{1.2 * uniform(engine), 0.8 * uniform(engine), dim == 3 ? 0.5 * uniform(engine) : 0.0};
      EXPECT_NEAR(weight_sum(d->interpolation(p)), 1, 1e-13);
      EXPECT_NEAR(value_at(*d, u, p, 0), linear(p)[0], 1e-12);
    }
    for (const Point& p : {Point{0, 0, 0}, Point{1.2, 0.8, dim == 3 ? 0.5 : 0.0}, Point{1.2, 0.3, 0}})
      EXPECT_NEAR(value_at(*d, u, p, 0), linear(p)[0], 1e-12);
    EXPECT_THROW(d->interpolation({1.21, 0.4, 0}), std::runtime_error);
    EXPECT_THROW(d->interpolation({0.3, -0.01, 0}), std::runtime_error);
  }
}

TEST(FemTopology, CellsAreInVtkOrderAndTurnLeft) {
  const auto d = block(2, {3, 2, 0}, 0);
  const Topology t = d->topology();
  ASSERT_EQ(t.cells.size(), d->units());
  for (const auto& cell : t.cells) {
    double area = 0;  // shoelace: positive only in cyclic, counterclockwise order
    for (int a = 0; a < 4; ++a) {
      const Point p = d->position(cell[a]), q = d->position(cell[(a + 1) % 4]);
      area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
    EXPECT_NEAR(area, 0.4 * 0.4, 1e-14);
  }
}

TEST(FemMesh, CellsOfAFileMayComeInAnyOrientation) {
  // A brick of two hexahedra whose second is written from another corner, in a left-handed order: same
  // volume, same stiffness as the box.
  CellMesh mesh;
  mesh.dim = 3;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) mesh.vertices.push_back({0.5 * i, 1.0 * j, 1.0 * k});
  mesh.cells.push_back({0, 1, 3, 4, 6, 7, 9, 10});
  mesh.cells.push_back({1, 4, 2, 5, 7, 10, 8, 11});
  const Scene scene = scene_of(std::make_shared<MeshShape>(mesh, "two"), Plane::none, 1.0, 0.25);
  const auto wave = [](const Point& x) {
    return Point{std::sin(3 * x[0] + x[1]), x[2] * x[0], std::cos(x[1] + 2 * x[2])};
  };
  for (const Element element : all_elements) {
    fem::Options options;
    options.element = element;
    const auto read = fem::discretize(scene, 0, options);
    options.divisions = {2, 1, 1};
    const auto box = fem::discretize(box_scene(Plane::none, {1, 1, 1}, 1.0, 0.25), 0, options);
    EXPECT_NEAR(read->energies(field(*read, wave).data()).strain,
                box->energies(field(*box, wave).data()).strain, 1e-13);
    EXPECT_DOUBLE_EQ(read->spacing(), 0.5);
  }
}

TEST(FemMesh, RefusesABoxWithoutDivisions) {
  EXPECT_THROW(fem::discretize(box_scene(Plane::stress, {1, 1, 0}), 0, {}), std::runtime_error);
}

}  // namespace
}  // namespace femsph::test
