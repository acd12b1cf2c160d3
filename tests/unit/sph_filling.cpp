// Particles that fill a body of any shape, at any spacing, have its volume and first moment (sums of V and V
// x); their sides have its area vectors and moments; and a support on a slanted or curved side holds the
// layer that the side cuts.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "model/motion/bodies/mass_properties.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/ball.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/disc.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/quadrilateral.hpp"
#include "model/scene/shapes/round.hpp"
#include "model/scene/shapes/structured.hpp"
#include "sph/particles/partial_volumes.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

using sph::MassRule;

/// A strip 2 x 1 of n x m cells, turned by `angle`, drawn in at x = 2 by `taper`; its ends and its lower side
/// are named.
std::shared_ptr<MeshShape> strip(int n, int m, double angle, double taper = 0) {
  CellMesh mesh;
  mesh.groups = {"left", "right", "bottom", "top"};
  const double c = std::cos(angle), s = std::sin(angle);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n, y = double(j) / m * (1 - taper * x / 2);
      mesh.vertices.push_back({c * x - s * y, s * x + c * y, 0});
    }
  const auto at = [&](int i, int j) { return i + (n + 1) * j; };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
      mesh.cells.push_back({at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
  for (int j = 0; j < m; ++j)
    mesh.facets.push_back({{at(0, j), at(0, j + 1)}, 0}),
        mesh.facets.push_back({{at(n, j), at(n, j + 1)}, 1});
  for (int i = 0; i < n; ++i)
    mesh.facets.push_back({{at(i, 0), at(i + 1, 0)}, 2}),
        mesh.facets.push_back({{at(i, m), at(i + 1, m)}, 3});
  return std::make_shared<MeshShape>(mesh, "strip");
}

/// The cells of a round shape as a mesh.
std::shared_ptr<MeshShape> mesh_of(const StructuredShape& shape, int divisions) {
  return std::make_shared<MeshShape>(shape.mesh({divisions, divisions, divisions}), "cells");
}

Scene scene_of(std::shared_ptr<const Shape> shape) {
  Scene s = box_scene(shape->dim() == 2 ? Plane::strain : Plane::none, {1, 1, 1});
  s.bodies[0].shape = std::move(shape);
  return s;
}

struct FilledShape {
  const char* name;
  std::shared_ptr<const Shape> shape;
};
std::vector<FilledShape> plane_cases() {
  using Part = Round::Part;
  return {{"box", std::make_shared<Box>(2, Point{0.3, -1, 0}, Point{2, 1, 0})},
          {"disc", std::make_shared<Ball>(2, Point{1, 2, 0}, 1.0)},
          {"ring", std::make_shared<Round>(2, Round::Size{{}, 0.5, 1, 0, 2, Part::whole})},
          {"half ring", std::make_shared<Round>(2, Round::Size{{}, 0.5, 1, 0, 2, Part::half})},
          {"quadrilateral", std::make_shared<Quadrilateral>(std::array<Point, 4>{
                                Point{0, 0, 0}, {2, 0.3, 0}, {1.7, 1.3, 0}, {-0.2, 1, 0}})},
          {"mesh", strip(8, 4, 0)},
          {"turned mesh", strip(7, 5, std::numbers::pi / 6)},
          {"tapered mesh", strip(16, 8, 0, 0.9)},
          {"meshed disc", mesh_of(Round(2, {{}, 0, 1, 0, 2, Part::whole}), 12)}};
}
std::vector<FilledShape> solid_cases() {
  using Part = Round::Part;
  return {{"box", std::make_shared<Box>(3, Point{0.3, -1, 0}, Point{2, 1, 1})},
          {"sphere", std::make_shared<Ball>(3, Point{1, 2, 0}, 1.0)},
          {"half tube", std::make_shared<Round>(3, Round::Size{{}, 0.4, 1, 2, 2, Part::half})},
          {"cylinder", std::make_shared<Round>(3, Round::Size{{}, 0, 1, 2, 0, Part::whole})},
          {"quarter ball", std::make_shared<OwnBall>(OwnBall::Size{{}, 1, 2, Part::quarter, 1})},
          {"meshed cylinder", mesh_of(Round(3, {{}, 0, 1, 2, 2, Part::whole}), 9)},
          {"meshed ball", mesh_of(OwnBall({{}, 1, 2, Part::whole, 1}), 6)}};
}

void expect_weight(const FilledShape& c, double spacing, bool fitted) {
  const Scene scene = scene_of(c.shape);
  for (const char* formulation : {"corrected", "classic"}) {
    sph::Options o;
    o.spacing = spacing, o.fitted = fitted, o.projection = false, o.formulation = formulation;
    const auto d = sph::discretize(scene, 0, o);
    const MassError error = mass_error(scene, 0, *d);
    EXPECT_NEAR(error.mass, 0, 1e-10) << c.name << ", spacing " << spacing << (fitted ? "" : ", lattice");
    EXPECT_NEAR(error.centre, 0, 1e-10) << c.name << ", spacing " << spacing << (fitted ? "" : ", lattice");
    for (const double mass : d->mass())
      ASSERT_GT(mass, 0) << c.name << ", spacing " << spacing << (fitted ? "" : ", lattice");
  }
}

TEST(FillingSlow, MassAndCentreAreThoseOfTheBody) {
  for (const FilledShape& c : plane_cases())
    for (const double spacing : {0.2, 0.13, 0.07})
      for (const bool fitted : {true, false}) expect_weight(c, spacing, fitted);
  for (const FilledShape& c : solid_cases())
    for (const double spacing : {0.31, 0.23})
      for (const bool fitted : {true, false}) expect_weight(c, spacing, fitted);
}

// The share rule has the body's mass by definition; counting whole cells (the paper's) has not, and says so.
TEST(Filling, WholeCellsSayHowFarOffTheyAre) {
  const Scene scene = scene_of(std::make_shared<Box>(2, Point{}, Point{2, 1, 0}));
  const auto share = sph::discretize(scene, 0, classic(0.1, MassRule::share)),
             full = sph::discretize(scene, 0, classic(0.1, MassRule::full));
  EXPECT_EQ(mass_warning(scene, 0, *share), "");
  // 21 x 11 particles for 20 x 10 cells: 15.5 % more of 7850 x 0.1 x 2 kg.
  EXPECT_EQ(mass_warning(scene, 0, *full),
            "body \"block\": its particles weigh 1813.35 kg, centre (1000, 500) mm, the body 1570 kg, centre "
            "(1000, 500) mm: "
            "the mass is +15.50 % off, the centre of gravity 0.00 % of the body's diagonal");
}

// The integrals of the hat functions of a lattice of spacing 1 over the triangle x + y < 4. In a cell that
// the side halves they are, over x + y < 1, of (1-x)(1-y), x(1-y), (1-x)y and xy: 5/24, 1/8, 1/8 and 1/24. So
// a place on the side has 1/4 + 2/8, one just outside 1/24, one just inside 3/4 + 5/24.
TEST(Filling, PartialVolumesAreIntegralsOfHatFunctions) {
  const Quadrilateral triangle(std::array<Point, 4>{Point{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {0, 4, 0}});
  sph::Options o;
  o.spacing = 1, o.fitted = false;
  const sph::Particles p = sph::fill(triangle, o);
  const sph::PartialVolumes volumes = sph::partial_volumes(triangle, p.lattice, {});
  const auto share = [&](int i, int j) { return volumes.share[std::size_t(i + 5 * j)]; };
  EXPECT_NEAR(share(0, 0), 0.25, 1e-3);
  EXPECT_NEAR(share(2, 0), 0.5, 1e-3);
  EXPECT_EQ(share(1, 1), 1.0);
  EXPECT_NEAR(share(1, 3), 0.5, 1e-3);
  EXPECT_NEAR(share(1, 2), 23.0 / 24, 1e-3);
  EXPECT_NEAR(share(2, 3), 1.0 / 24, 1e-3);
  EXPECT_EQ(share(3, 3), 0.0);
  EXPECT_EQ(p.lattice.particle(2, 3, 0), -1);
}

// A box needs no integration: volumes are the cell times 1, 1/2, 1/4, 1/8, to the last bit.
TEST(Filling, ABoxIsFilledToTheLastBit) {
  for (const int dim : {2, 3}) {
    const sph::Particles p = sph::fill(Box(dim, {0.1, -0.3, 0.7}, {0.7, 0.3, 0.4}), corrected(0.1));
    for (std::size_t i = 0; i < p.size(); ++i) {
      double share = 1;
      for (int a = 0; a < dim; ++a)
        share *= p.lattice.place[i][std::size_t(a)] % (p.lattice.count[std::size_t(a)] - 1) == 0 ? 0.5 : 1;
      EXPECT_EQ(p.volume[i], p.cell * share);
    }
  }
}

// The centres that shapes state are those of their cells, which leave out the segments
// between chords and arcs: less than 1 - sin x / x of the area, with x half the angle of a sector.
TEST(FillingSlow, CentroidsAreThoseOfTheCells) {
  using Part = Round::Part;
  for (const Part part : {Part::whole, Part::half, Part::quarter}) {
    const Round ring(2, {{0.3, 0.2, 0}, 0.5, 1, 0, 2, part}), tube(3, {{0.3, 0.2, 0.1}, 0.4, 1, 2, 0, part}),
        cylinder(3, {{}, 0, 1, 2, 1, part});
    const OwnBall ball({{0.3, 0.2, 0.1}, 1, 2, part, 1});
    for (const StructuredShape* shape :
         std::initializer_list<const StructuredShape*>{&ring, &tube, &cylinder, &ball})
      EXPECT_LT(norm(shape->centroid() - mesh_of(*shape, 40)->centroid()), 1e-3) << shape->describe();
  }
}

// A particle that has a side through its cell is held: on a slanted end, every particle within half a cell's
// diagonal and none beyond.
TEST(Filling, ASlantedSideHoldsTheLayerThatItCuts) {
  const double angle = std::numbers::pi / 6;
  const Scene scene = scene_of(strip(8, 4, angle));
  for (const double spacing : {0.1, 0.05, 0.023}) {
    sph::Options o;
    o.spacing = spacing, o.fitted = false;
    const auto d = sph::discretize(scene, 0, o);
    const auto layer = d->points_of({0, {"left"}, {}, {}});
    EXPECT_GE(layer.size(), std::size_t(1 / spacing));
    EXPECT_LE(layer.size(), std::size_t(2.2 / spacing));
    Point mean{};
    double sum = 0;
    for (const Weight& w : layer) {
      const Point x = d->position(w.point);
      EXPECT_LE(std::abs(std::cos(angle) * x[0] + std::sin(angle) * x[1]), 1.3 * spacing);
      mean = mean + w.weight * x, sum += w.weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(mean[0], -0.5 * std::sin(angle), 0.5 * spacing);  // the middle of the side
    EXPECT_NEAR(mean[1], 0.5 * std::cos(angle), 0.5 * spacing);
    // Two sides: their corner alone.
    const auto corner = d->points_of({0, {"left", "bottom"}, {}, {}});
    ASSERT_FALSE(corner.empty());
    for (const Weight& w : corner) EXPECT_LE(norm(d->position(w.point)), 1.5 * spacing);
  }
}

// The area vectors of a side are its own, and so is the moment of a pressure on it; those of all sides close.
// On a lattice and fitted.
TEST(Filling, PressureHasTheForceAndTheMomentOfTheSide) {
  const double angle = std::numbers::pi / 6;
  for (const bool fitted : {false, true})
    for (const double spacing : {0.1, 0.037}) {
      const Scene scene = scene_of(strip(20, 10, angle));
      sph::Options o;
      o.spacing = spacing, o.fitted = fitted;
      const auto d = sph::discretize(scene, 0, o);
      Point all{};
      for (const char* side : {"left", "right", "bottom", "top"}) {
        Point area{};
        double moment = 0;
        for (const PointArea& part : d->outward_areas({0, {side}, {}, {}})) {
          const Point x = d->position(part.point);
          area = area + part.area;
          moment += x[0] * part.area[1] - x[1] * part.area[0];
        }
        all = all + area;
        if (side[0] != 'r') continue;
        EXPECT_NEAR(area[0], std::cos(angle), 1e-9);
        EXPECT_NEAR(area[1], std::sin(angle), 1e-9);
        // About the origin: the middle of the side is at 2 (c, s) + 0.5 (-s, c), so x_m c' - .. = -0.5.
        EXPECT_NEAR(moment, -0.5, 1e-9);
      }
      EXPECT_NEAR(norm(all), 0, 1e-9);
    }
}

// A quarter of a hole under pressure pushes with p R along both axes, whatever way it is filled.
TEST(Filling, PressureOnACurvedSide) {
  const auto ring = std::make_shared<Round>(2, Round::Size{{}, 0.5, 1, 0, 2, Round::Part::quarter});
  for (const bool fitted : {false, true}) {
    sph::Options o;
    o.spacing = 0.06, o.fitted = fitted;
    const auto d = sph::discretize(scene_of(ring), 0, o);
    Point area{};
    for (const PointArea& part : d->outward_areas({0, {"inner"}, {}, {}})) area = area + part.area;
    EXPECT_NEAR(area[0], -0.5, 1e-3) << fitted;
    EXPECT_NEAR(area[1], -0.5, 1e-3) << fitted;
  }
}

// Cut to the spacing a mesh stays conforming: as many free facets as its rim has pieces, in space too,
// whichever way its cells are turned.
TEST(Filling, CutMeshesConform) {
  std::string why;
  const auto plane = sph::cut_to_spacing(
      *strip(4, 2, 0.3)->cells(), 0.1, why);  // cells 0.5 x 0.5: 5 pieces each way
  ASSERT_TRUE(plane) << why;
  EXPECT_EQ(plane->cells.size(), 4u * 2 * 25);
  EXPECT_EQ(plane->vertices.size(), 21u * 11);
  CellMesh two;  // unit cubes side by side, the second turned about x and then about y
  two.dim = 3;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) two.vertices.push_back({double(i), double(j), double(k)});
  const auto at = [](int i, int j, int k) { return i + 3 * j + 6 * k; };
  const auto cell = [&](auto&& place) {
    std::array<int, 8> c{};
    for (int v = 0; v < 8; ++v) c[std::size_t(v)] = place(v & 1, v >> 1 & 1, v >> 2);
    return c;
  };
  two.cells = {cell([&](int i, int j, int k) { return at(i, j, k); }),
               cell([&](int i, int j, int k) { return at(2 - j, i, k); })};
  const auto cut = sph::cut_to_spacing(two, 0.26, why);  // 4 pieces an edge
  ASSERT_TRUE(cut) << why;
  EXPECT_EQ(cut->cells.size(), 2u * 64);
  EXPECT_EQ(cut->vertices.size(), 9u * 5 * 5);
}

// Where cells are too uneven for one smoothing length, the particles are those of a lattice, with a warning.
TEST(Filling, UnevenMeshesAreFilledByALatticeWithAWarning) {
  const auto even = sph::discretize(scene_of(strip(8, 4, 0)), 0, corrected(0.1)),
             uneven = sph::discretize(scene_of(strip(8, 4, 0, 0.9)), 0, corrected(0.1));
  EXPECT_TRUE(even->warnings().empty());
  ASSERT_EQ(uneven->warnings().size(), 1u);
  EXPECT_TRUE(uneven->warnings()[0].starts_with("its mesh can only be cut into pieces of "))
      << uneven->warnings()[0];
}

}  // namespace
}  // namespace femsph::test
