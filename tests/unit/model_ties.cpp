// Tied bodies on grids of points, masses and cells: the forces keep G a = 0, and have neither resultant nor
// moment.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/motion/effects/ties.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/box.hpp"
#include "model_grid.hpp"

namespace femsph {
namespace {

/// A grid of 4 x 4 cells on [0, 1]^2, and one of 6 x 6 above it, a gap higher.
struct Tower {
  explicit Tower(double gap = 0) {
    scene.plane = Plane::stress;
    scene.materials["m"] = Material{"m", 1, 0, 2.0};
    scene.bodies.push_back({"lower", std::make_shared<Box>(2, Point{0, 0, 0}, Point{1, 1, 0}), 1, "m"});
    scene.bodies.push_back({"upper", std::make_shared<Box>(2, Point{0, 1 + gap, 0}, Point{1, 1, 0}), 1, "m"});
    scene.contacts.push_back({"bond", {0, 1}, 1, 0, {}, true});
    add(std::make_unique<test::Grid>(Point{0, 0, 0}, 1, 1, 4, 4));
    add(std::make_unique<test::Grid>(Point{0, 1 + gap, 0}, 1, 1, 6, 6));
  }
  void add(std::unique_ptr<Discretization> d) {
    MovingBody body;
    body.index = bodies.size();
    body.discretization = std::move(d);
    const std::size_t n = body.discretization->layout().size;
    for (auto* v : {&body.u, &body.v, &body.f}) v->assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) body.inverse_mass.push_back(1 / body.discretization->mass()[i / 2]);
    bodies.push_back(std::move(body));
  }
  Point place(const MovingBody& body, std::size_t i) const {
    return body.discretization->position(i) + Point{body.u[2 * i], body.u[2 * i + 1], 0};
  }
  void turn(double angle) {
    for (MovingBody& body : bodies)
      for (std::size_t i = 0; i < body.discretization->layout().points; ++i) {
        const Point x = body.discretization->position(i);
        body.u[2 * i] = std::cos(angle) * x[0] - std::sin(angle) * x[1] - x[0];
        body.u[2 * i + 1] = std::sin(angle) * x[0] + std::cos(angle) * x[1] - x[1];
      }
  }
  Scene scene;
  std::vector<MovingBody> bodies;
};

TEST(Ties, TakeTheFinerBodysPointsOnTheInterface) {
  Tower tower;
  const Ties ties(tower.scene, tower.bodies);
  ASSERT_EQ(ties.bonds().size(), 1u);
  EXPECT_EQ(ties.bonds()[0].from, 1u);                         // 6 cells against 4
  EXPECT_EQ(ties.bonds()[0].end - ties.bonds()[0].begin, 7u);  // and none of the sides'
}

TEST(Ties, SolidMotionNeedsNoForce) {
  for (const double gap : {0.0, 0.1}) {
    Tower tower(gap);
    Ties ties(tower.scene, tower.bodies);
    tower.turn(1.1);
    ties.add_forces(tower.bodies, 1, 1e-3, 1e-3, 1e-3, true);
    for (const MovingBody& body : tower.bodies)
      for (const double f : body.f)
        EXPECT_NEAR(f, 0, 1e-9);  // round-off of g, 1e-16 m, times m / dt^2 of 0.01 / 1e-6
  }
}

// After a step with any forces and velocities, the tied points lie where their facets carry them: exactly
// without a gap; with one up to second order in what the step turns. Sums of forces and of their moments
// vanish in both.
TEST(Ties, HoldAtTheEndOfTheStepAndKeepMomentum) {
  for (const double gap : {0.0, 0.1}) {
    Tower tower(gap);
    Ties ties(tower.scene, tower.bodies);
    tower.turn(0.4);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-1, 1);
    for (MovingBody& body : tower.bodies)
      for (std::size_t i = 0; i < body.f.size(); ++i)
        body.f[i] = jitter(random), body.v[i] = 1e-3 * jitter(random);
    std::vector<AlignedVector<double>> before{tower.bodies[0].f, tower.bodies[1].f};
    const double dt = 1e-3;
    ties.add_forces(tower.bodies, 1, dt, dt, dt, false);
    Point sum{}, moment{};
    double size = 0;
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t i = 0; i < before[b].size() / 2; ++i) {
        const Point f{tower.bodies[b].f[2 * i] - before[b][2 * i],
                      tower.bodies[b].f[2 * i + 1] - before[b][2 * i + 1], 0};
        sum = sum + f;
        moment = moment + cross(tower.place(tower.bodies[b], i), f);
        size += norm(f);
      }
    EXPECT_GT(size, 0.1);
    EXPECT_LT(norm(sum), 1e-14 * size);
    EXPECT_LT(norm(moment), 1e-13 * size);
    for (MovingBody& body : tower.bodies)
      for (std::size_t i = 0; i < body.u.size(); ++i)
        body.u[i] += dt * (body.v[i] + dt * body.inverse_mass[i] * body.f[i]);
    // The upper grid's bottom point 1 stands over the lower grid's top segment from point 20 to 21 (x = 0 to
    // 1/4), at 2/3.
    const Point a = tower.place(tower.bodies[0], 20), b = tower.place(tower.bodies[0], 21),
                p = tower.place(tower.bodies[1], 1);
    const Point along = b - a, up{-along[1] / norm(along), along[0] / norm(along), 0};
    EXPECT_LT(norm(p - (a + (2.0 / 3) * along + gap * up)), gap == 0 ? 1e-15 : 1e-9);
  }
}

TEST(Ties, BodiesThatStartApartInSpeedKeepTheirMomentum) {
  Tower tower;
  const Ties ties(tower.scene, tower.bodies);
  for (std::size_t i = 0; i < tower.bodies[1].v.size(); i += 2) tower.bodies[1].v[i] = 1;
  const auto momentum = [&] {
    double p = 0;
    for (const MovingBody& body : tower.bodies)
      for (std::size_t i = 0; i < body.v.size(); i += 2) p += body.v[i] / body.inverse_mass[i];
    return p;
  };
  const double before = momentum();
  ties.match_velocities(tower.bodies);
  EXPECT_NEAR(momentum() / before, 1, 1e-14);
  const auto& lower = tower.bodies[0].v;
  EXPECT_NEAR(tower.bodies[1].v[2], (1 * lower[40] + 2 * lower[42]) / 3, 1e-14);
  EXPECT_GT(tower.bodies[1].v[2], 0.1);
  EXPECT_LT(tower.bodies[1].v[2], 0.9);
}

TEST(Ties, RefuseBodiesThatDoNotTouch) {
  Tower tower(0.3);
  try {
    const Ties ties(tower.scene, tower.bodies);
    FAIL();
  } catch (const MotionError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("contact \"bond\": the bodies touch nowhere at the start"));
  }
}

}  // namespace
}  // namespace femsph
