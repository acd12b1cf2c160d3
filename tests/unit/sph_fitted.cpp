// Particles that follow round and slanted sides: exact mass, exact linear fields, boundary particles on the
// side, a quarter between symmetry planes equal to the whole; and a ring under pressure against Lame.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/motion/march.hpp"
#include "model/scene/shapes/ball.hpp"
#include "model/scene/shapes/quadrilateral.hpp"
#include "model/scene/shapes/round.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

Scene scene_of(std::shared_ptr<const Shape> shape, Plane plane, bool large = false) {
  Scene s = box_scene(plane, {1, 1, 0}, large);
  s.bodies[0].shape = std::move(shape);
  s.bodies[0].thickness = plane == Plane::none ? 1 : 0.5;
  return s;
}
std::shared_ptr<Round> ring(Round::Part part) {
  return std::make_shared<Round>(2, Round::Size{{}, 0.1, 0.2, 0, 2, part});
}

sph::Options options(double spacing) {
  sph::Options o;
  o.spacing = spacing;
  return o;
}

TEST(Fitted, MassAndSides) {
  const auto d = sph::discretize(scene_of(ring(Round::Part::whole), Plane::strain), 0, options(0.02));
  const double mass = std::accumulate(d->mass().begin(), d->mass().end(), 0.0),
               exact = 7850 * 0.5 * ring(Round::Part::whole)->measure();
  EXPECT_NEAR(mass, exact,
              1e-12 * exact);  // what chords leave out of arcs belongs to the particles of the rims
  for (const char* side : {"inner", "outer"}) {
    const auto points = d->points_of({0, {side}, {}, {}});
    EXPECT_GT(points.size(), 20u);
    for (const Weight& w : points) {
      const Point x = d->position(w.point);
      EXPECT_NEAR(std::hypot(x[0], x[1]), side[0] == 'i' ? 0.1 : 0.2, 1e-12);
      EXPECT_NEAR(w.weight, 1.0 / double(points.size()), 1e-12);
    }
  }
  EXPECT_EQ(d->boundary().size(),
            d->points_of({0, {"inner"}, {}, {}}).size() + d->points_of({0, {"outer"}, {}, {}}).size());
}

TEST(Fitted, LinearFieldsAreExact) {
  const double A[3][3] = {{1e-3, 2e-3, 0}, {-5e-4, -1e-3, 0}, {0, 0, 0}};
  const Scene scene = scene_of(std::make_shared<Quadrilateral>(std::array<Point, 4>{
                                   Point{0, 0, 0}, {0.48, 0.44, 0}, {0.48, 0.6, 0}, {0, 0.44, 0}}),
                               Plane::stress);
  for (const auto& s : {scene, scene_of(ring(Round::Part::half), Plane::stress)}) {
    const auto d = sph::discretize(s, 0, options(0.03));
    const auto u = linear_vector(*d, A);
    force(*d, u);
    for (const auto& e : state_of(*d, u).strain) {
      EXPECT_NEAR(e[0], 1e-3, 1e-14);
      EXPECT_NEAR(e[1], -1e-3, 1e-14);
      EXPECT_NEAR(e[3], 0.75e-3, 1e-14);
    }
  }
}

// The quarter between two symmetry planes carries a quarter of the whole's mass, and its particles feel the
// same accelerations.
TEST(Fitted, AQuarterIsTheWhole) {
  Scene quarter = scene_of(ring(Round::Part::quarter), Plane::strain);
  for (const char* side : {"x-", "y-"}) quarter.symmetries.push_back({Place{0, {side}, {}, {}}});
  // The whole's spacing is that of its bounding box, twice as long: the same cells.
  sph::Options plain = options(0.02);
  plain.projection = false;  // iterations agree less well: Projection.AQuarterIsTheWhole
  const auto whole = sph::discretize(scene_of(ring(Round::Part::whole), Plane::strain), 0, plain),
             part = sph::discretize(quarter, 0, plain);
  EXPECT_NEAR(4 * std::accumulate(part->mass().begin(), part->mass().end(), 0.0),
              std::accumulate(whole->mass().begin(), whole->mass().end(), 0.0), 1e-9);
  expect_same_accelerations(*part, *whole, 1e-9);
}

// Lame: u(a) = p a (1 + nu)/E ((1 - 2 nu) a^2 + b^2)/(b^2 - a^2).
TEST(Fitted, PressedRing) {
  Scene s = scene_of(ring(Round::Part::quarter), Plane::strain);
  for (const char* side : {"x-", "y-"}) s.symmetries.push_back({Place{0, {side}, {}, {}}});
  s.loads.push_back({Place{0, {"inner"}, {}, {}}, {}, {}, 100e6});
  s.settling = Settling{};
  s.duration = 1;
  std::vector<std::unique_ptr<Discretization>> bodies;
  bodies.push_back(sph::discretize(s, 0, options(0.01)));
  March march(s, std::move(bodies), {});
  march.run({});
  EXPECT_TRUE(march.settled());
  const MovingBody& body = march.bodies()[0];
  const double exact = 100e6 * 0.1 * 1.3 / 2.1e11 * (0.4 * 0.01 + 0.04) / 0.03;
  double mean = 0;
  const auto inner = body.discretization->points_of({0, {"inner"}, {}, {}});
  for (const Weight& w : inner)
    mean += w.weight * std::hypot(body.u[body.discretization->layout().at(w.point, 0)],
                                  body.u[body.discretization->layout().at(w.point, 1)]);
  EXPECT_NEAR(mean, exact, 0.02 * exact);
}

TEST(Fitted, ABallHasItsMassAndOneSmoothingLength) {
  const auto ball = [](double finer) {
    return std::make_shared<OwnBall>(OwnBall::Size{{0, 0, 0}, 0.01, 2, OwnBall::Part::quarter, finer});
  };
  const double exact = 7850 * ball(1)->measure();
  for (const double spacing : {0.002, 0.001}) {
    sph::Options o = options(spacing);
    o.projection = false;  // changes no mass, and is slow
    const auto d = sph::discretize(scene_of(ball(1), Plane::none), 0, o);
    EXPECT_NEAR(std::accumulate(d->mass().begin(), d->mass().end(), 0.0), exact, 1e-12 * exact);
  }
  EXPECT_THAT([&] { sph::discretize(scene_of(ball(4), Plane::none), 0, options(0.001)); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(
                  "SPH has one smoothing length, but the quarter ball of radius 10 mm, 4 "
                  "times finer at z- has cells of many sizes")));
}

}  // namespace
}  // namespace femsph::test
