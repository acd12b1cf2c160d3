// Bodies whose sides cut a lattice of particles: under one pressure all around they hold the uniform stress,
// and the area vectors of their sides close.

#include <gtest/gtest.h>

#include <algorithm>

#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/ball.hpp"
#include "model/scene/shapes/disc.hpp"
#include "model/scene/shapes/mesh.hpp"
#include "model/scene/shapes/quadrilateral.hpp"
#include "model/scene/shapes/round.hpp"
#include "sph_projection_support.hpp"

namespace femsph::test {
namespace {

/// Its free sides are those that have the ball's radius.
std::shared_ptr<MeshShape> mesh_of_a_ball() {
  CellMesh mesh = OwnBall({{}, 0.1, 2, Round::Part::whole, 1}).mesh({6, 6, 6});
  mesh.groups = {"skin"};
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < 3; ++a)
      for (int s = 0; s < 2; ++s) {
        std::vector<int> corners;
        for (int v = 0; v < 8; ++v)
          if ((v >> a & 1) == s) corners.push_back(cell[std::size_t(v)]);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](int v) { return std::abs(norm(mesh.vertices[std::size_t(v)]) - 0.1) < 1e-9; }))
          mesh.facets.push_back({{corners[0], corners[1], corners[2], corners[3]}, 0});
      }
  return std::make_shared<MeshShape>(mesh, "ball");
}

// Under the same pressure on all sides, a body whose lattice follows its sides in steps has the uniform
// stress exactly; the force and the moment of all its sides are zero.
TEST(Projection, SidesThatCutALatticeHoldAUniformStress) {
  const double turn = 0.4;
  const auto turned = [&](double x, double y) {
    return Point{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn), 0};
  };
  const std::array<Point, 4> corners{turned(0, 0), turned(0.2, 0), turned(0.2, 0.1), turned(0, 0.1)};
  const auto round = [](int dim, double inner) {
    return std::make_shared<Round>(
        dim, Round::Size{{}, inner, 0.1, dim == 3 ? 0.1 : 0, 2, Round::Part::whole});
  };
  const std::vector<ScatteredBody> bodies{
      {"disc", round(2, 0), 0.011},
      {"ring", round(2, 0.05), 0.0085},
      {"half ring", std::make_shared<Round>(2, Round::Size{{}, 0.05, 0.1, 0, 2, Round::Part::half}), 0.0085},
      {"disc without cells", std::make_shared<Ball>(2, Point{}, 0.1), 0.011},
      {"sphere without cells", std::make_shared<Ball>(3, Point{}, 0.1), 0.025},
      {"turned box", std::make_shared<Quadrilateral>(corners), 0.0125},
      {"cylinder", round(3, 0), 0.02},
      {"mesh of a ball", mesh_of_a_ball(), 0.021}};
  for (const ScatteredBody& b : bodies) {
    sph::Options o = corrected(b.spacing);
    o.fitted = false;
    const Scene scene = scene_of(b);
    const auto d = sph::discretize(scene, 0, o);
    const double e[3][3] = {{1e-4, 0, 0}, {0, 1e-4, 0}, {0, 0, d->layout().dim == 3 ? 1e-4 : 0}};
    const auto law = std::get<LinearElastic>(scene.material_of(scene.bodies[0]).law(scene.plane));
    const double p = 2 * law.mu * 1e-4 + law.lambda * 1e-4 * d->layout().dim;
    const double sigma[3][3] = {{p, 0, 0}, {0, p, 0}, {0, 0, p}};
    std::vector<std::string> sides = b.shape->sides();
    std::erase_if(sides, [&](const std::string& side) {
      return b.shape->names_whole_boundary() ? side.size() == 2 : false;
    });
    std::vector<Point> area(d->layout().points, Point{});
    Point all{};
    std::vector<Place> places;
    for (const std::string& side : sides) places.push_back({0, {side}, {}, {}, {}});
    if (b.shape->touches_sides_in_points()) places = {Place{0, {}, {}, {}, {}}};  // "all"
    for (const Place& place : places)
      for (const PointArea& part : d->outward_areas(place))
        area[part.point] = area[part.point] + part.area, all = all + part.area;
    const auto f = force(*d, linear_vector(*d, e));
    double most = 0, off = 0;
    for (std::size_t i = 0; i < area.size(); ++i)
      for (int c = 0; c < d->layout().dim; ++c) {
        const double load = scene.bodies[0].thickness * sigma[c][c] * area[i][std::size_t(c)];
        most = std::max(most, std::abs(load)), off = std::max(off, std::abs(load + f[d->layout().at(i, c)]));
      }
    EXPECT_LT(off, 1e-10 * most) << b.name;
    EXPECT_LT(norm(all), 1e-12) << b.name;
  }
}

// With symmetry planes as well: they are no sides, and what acts is a quarter of the whole.
TEST(Projection, SidesThatCutALatticeBesideSymmetryPlanes) {
  ScatteredBody b{"quarter of a disc",
                  std::make_shared<Round>(2, Round::Size{{}, 0, 0.1, 0, 2, Round::Part::quarter}),
                  0.011,
                  1,
                  0,
                  {"x-", "y-"}};
  sph::Options o = corrected(b.spacing);
  o.fitted = false;
  const auto d = sph::discretize(scene_of(b), 0, o);
  std::vector<Point> area(d->layout().points, Point{});
  Point all{};
  for (const PointArea& part : d->outward_areas({0, {"outer"}, {}, {}, {}}))
    area[part.point] = area[part.point] + part.area, all = all + part.area;
  EXPECT_NEAR(all[0], 0.1,
              1e-3);  // R, the integral of cos, but for what the planes bear: across them particles are held
  EXPECT_NEAR(all[1], 0.1, 1e-3);
  for (const Point& a : area) EXPECT_LT(norm(a), 2 * b.spacing);
  const double e[3][3] = {{1e-4, 0, 0}, {0, 1e-4, 0}, {0, 0, 0}};
  const Scene scene = scene_of(b);
  const auto law = std::get<LinearElastic>(scene.material_of(scene.bodies[0]).law(scene.plane));
  const double p = (2 * law.mu + 2 * law.lambda) * 1e-4, thickness = scene.bodies[0].thickness;
  const auto f = force(*d, linear_vector(*d, e));
  for (std::size_t i = 0; i < area.size(); ++i)
    for (int c = 0; c < 2; ++c) {
      if (d->position(i)[std::size_t(c)] <= 1e-9) continue;
      EXPECT_NEAR(f[d->layout().at(i, c)], -p * thickness * area[i][std::size_t(c)],
                  1e-9 * p * thickness * b.spacing);
    }
}

}  // namespace
}  // namespace femsph::test
