// Boundaries, nearest points, and contact forces between two grids of points, masses and cells.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/motion/effects/contact_pair.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/disc.hpp"
#include "model_grid.hpp"
#include "model_results_fake.hpp"

namespace femsph {
namespace {

using test::Grid;
constexpr double rho = Grid::rho, speed = Grid::speed;

/// Two grids, `upper` on `lower` with facets of 1/4 and 1/6, both one wide.
struct Pile {
  explicit Pile(double friction = 0) {
    scene.materials["m"] = Material{"m", 1, 0, rho};
    scene.bodies.push_back({"lower", std::make_shared<Box>(2, Point{0, 0, 0}, Point{1, 1, 0}), 1, "m"});
    scene.bodies.push_back({"upper", std::make_shared<Box>(2, Point{0, 1, 0}, Point{1, 1, 0}), 1, "m"});
    scene.contacts.push_back({"pile", {0, 1}, 1.0, friction, {}});
    add(std::make_unique<Grid>(Point{0, 0, 0}, 1, 1, 4, 4));
    add(std::make_unique<Grid>(Point{0, 1, 0}, 1, 1, 6, 6));
    pair = std::make_unique<ContactPair>(
        scene, scene.contacts[0], std::array{ContactPair::Party{false, 0}, ContactPair::Party{false, 1}},
        bodies);
  }
  void add(std::unique_ptr<Discretization> d) {
    MovingBody body;
    body.index = bodies.size();
    body.discretization = std::move(d);
    for (auto* v : {&body.u, &body.v, &body.f}) v->assign(body.discretization->layout().size, 0.0);
    bodies.push_back(std::move(body));
  }
  void move(std::size_t body, Point by) {
    for (std::size_t i = 0; i < bodies[body].u.size(); ++i) bodies[body].u[i] = by[i % 2];
  }
  void press(long step, double dt) { pair->add_forces(bodies, none, step, dt); }
  /// Sum of the forces and of their moments over both bodies, and of the sizes of the forces.
  std::array<double, 4> sums() const {
    std::array<double, 4> s{};
    for (const MovingBody& body : bodies)
      for (std::size_t i = 0; i < body.discretization->layout().points; ++i) {
        const double fx = body.f[2 * i], fy = body.f[2 * i + 1];
        const Point x = body.discretization->position(i) + Point{body.u[2 * i], body.u[2 * i + 1], 0};
        s = {s[0] + fx, s[1] + fy, s[2] + x[0] * fy - x[1] * fx, s[3] + std::abs(fx) + std::abs(fy)};
      }
    return s;
  }
  Scene scene;
  std::vector<MovingBody> bodies;
  std::vector<RigidBody> none;
  std::unique_ptr<ContactPair> pair;
};

// 2 x 1 cells have 6 outer edges, two cubes side by side 10 outer faces; the outward areas of a closed
// surface add up to zero, and area times position (per dimension) to the volume (Gauss).
TEST(Boundary, IsClosedAndFacesOutward) {
  const test::FakeMesh plane;
  double area = 0;
  Point sum{};
  for (const Facet& f : plane.boundary()) {
    const Point a = plane.position(f.points[0]), b = plane.position(f.points[1]),
                n{b[1] - a[1], a[0] - b[0], 0};
    area += dot(n, a + b) / 4;
    sum = sum + n;
  }
  EXPECT_EQ(plane.boundary().size(), 6u);
  EXPECT_DOUBLE_EQ(area, 2);
  EXPECT_DOUBLE_EQ(norm(sum), 0);

  const test::FakeBlock block;
  double volume = 0;
  sum = {};
  for (const Facet& f : block.boundary()) {
    const Point a = block.position(f.points[0]), b = block.position(f.points[1]),
                c = block.position(f.points[2]), d = block.position(f.points[3]);
    const Point n = 0.5 * cross(c - a, d - b);
    volume += dot(n, a + b + c + d) / 12;
    sum = sum + n;
  }
  EXPECT_EQ(block.boundary().size(), 10u);
  EXPECT_DOUBLE_EQ(volume, 2);
  EXPECT_DOUBLE_EQ(norm(sum), 0);
}

// On a warped patch p - foot is along the normal there; shape functions give the foot.
TEST(NearestPoint, OfAWarpedPatch) {
  const std::array<Point, 4> patch{
      Point{0, 0, 0}, Point{1, 0, 0.1}, Point{1.1, 1, -0.1}, Point{0, 0.9, 0.15}};
  const Point p{0.4, 0.6, -0.05};
  const Projection s = project_onto_facet(3, patch, p);
  const Point off = p - s.foot;
  EXPECT_LT(s.gap, 0);
  EXPECT_NEAR(std::abs(s.gap), norm(off), 1e-12);
  EXPECT_NEAR(norm(cross(off, s.normal)), 0, 1e-12);
  EXPECT_NEAR(s.share[0] + s.share[1] + s.share[2] + s.share[3], 1, 1e-14);
  EXPECT_EQ(s.beyond, 0);
}

TEST(NearestPoint, SaysHowFarBeyondASegmentThePointLies) {
  const Projection s = project_onto_facet(2, {Point{2, 0, 0}, Point{0, 0, 0}}, Point{-0.5, -0.25, 0});
  EXPECT_DOUBLE_EQ(s.gap, -0.25);  // the body lies to the left of 2 -> 0: below
  EXPECT_DOUBLE_EQ(s.beyond, 0.5);
}

TEST(Contact, TouchingBodiesFeelNothing) {
  Pile pile;
  pile.press(0, 0);
  EXPECT_EQ(pile.sums()[3], 0);
  EXPECT_EQ(pile.pair->stored(), 0);
}

TEST(Contact, RefusesAnOverlapAtTheStartWithItsPlace) {
  Pile pile;
  pile.move(1, {0, -0.01, 0});
  try {
    pile.press(0, 0);
    FAIL();
  } catch (const MotionError& e) {
    EXPECT_THAT(
        e.what(), testing::AllOf(testing::HasSubstr("contact \"pile\""), testing::HasSubstr("overlap"),
                                 testing::HasSubstr("at (0.25, 1, 0) m")));
  }
}

// kappa = 0.25 rho c^2 / d is the smaller of the two: d = 1/4. An even depth g over a unit face: force kappa
// g, energy kappa g^2 / 2, whatever the facets.
TEST(Contact, AnEvenDepthIsAnEvenPressure) {
  Pile pile;
  const double kappa = 0.25 * rho * speed * speed / 0.25, g = 0.003;
  EXPECT_DOUBLE_EQ(pile.pair->stiffness(), kappa);
  pile.move(1, {0, -g, 0});
  pile.press(1, 1e-3);
  EXPECT_NEAR(pile.pair->force()[1] / (kappa * g), 1, 1e-6);  // of the lower body on the upper
  EXPECT_NEAR(pile.pair->stored() / (0.5 * kappa * g * g), 1, 1e-6);
  EXPECT_NEAR(pile.pair->deepest() / g, 1, 1e-6);
  EXPECT_NEAR(pile.sums()[1], 0, 1e-15);
}

// Whatever the shape and the friction, forces and moments on both bodies cancel to round-off.
TEST(Contact, ForcesAndMomentsCancel) {
  for (const double friction : {0.0, 0.4}) {
    Pile pile(friction);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(-1e-3, 1e-3);
    pile.move(1, {0.013, -0.004, 0});
    for (MovingBody& body : pile.bodies)
      for (std::size_t i = 0; i < body.u.size(); ++i)
        body.u[i] += jitter(random), body.v[i] = 10 * jitter(random);
    for (std::size_t i = 0; i < pile.bodies[1].v.size(); i += 2) pile.bodies[1].v[i] += 0.5;
    pile.press(1, 1e-3);
    const auto s = pile.sums();
    EXPECT_GT(pile.pair->touching(), 8u);
    EXPECT_LT(std::abs(s[0]), 1e-14 * s[3]);
    EXPECT_LT(std::abs(s[1]), 1e-14 * s[3]);
    EXPECT_LT(std::abs(s[2]), 1e-14 * s[3]);
    if (friction > 0) {
      EXPECT_LT(pile.pair->force()[0], 0);  // the lower body holds the upper back
    }
  }
}

// Sliding by 1e-5 a step: the friction grows with the tangential stretch up to mu times the pressure; then
// the bodies slip, with the work mu f per metre.
TEST(Contact, FrictionSticksThenSlips) {
  const double mu = 0.3, g = 0.003, dt = 1e-3;
  Pile pile(mu);
  pile.move(1, {0, -g, 0});
  for (std::size_t i = 0; i < pile.bodies[1].v.size(); i += 2) pile.bodies[1].v[i] = 0.01;
  const double pressing = pile.pair->stiffness() * g;
  std::vector<double> pull;
  double loss_before = 0;
  for (int step = 1; step <= 200; ++step) {
    loss_before = pile.pair->friction_loss();
    pile.press(step, dt);
    pull.push_back(-pile.pair->force()[0] / pressing);
  }
  EXPECT_NEAR(pull[9], 10 * 0.01 * dt / g, 1e-6);  // kappa A s / (kappa A g)
  EXPECT_NEAR(pull.back(), mu, 1e-6);
  EXPECT_NEAR((pile.pair->friction_loss() - loss_before) / (mu * pressing * 0.01 * dt), 1, 1e-6);
}

/// A rigid box of sides 1, 2, 3 m that spins about an axis between its own.
TEST(RigidBody, KeepsItsMomentumAndEnergyWhileItTumbles) {
  Scene scene;
  scene.plane = Plane::none;
  Body body{"brick", std::make_shared<Box>(3, Point{0, 0, 0}, Point{1, 2, 3}), 1, ""};
  body.rigid = true;
  body.mass = 12;
  scene.bodies.push_back(body);
  RigidBody brick(scene, 0);
  EXPECT_EQ(brick.inertia, (Point{13, 10, 5}));  // m (b^2 + c^2) / 12
  brick.spin = {1, 20, 3};
  const double energy = brick.product(1, 0, 1, 0);
  for (int step = 0; step < 20000; ++step) {
    brick.kick(1, 1e-3);
    brick.drift(1e-3);
  }
  EXPECT_EQ(brick.spin, (Point{1, 20, 3}));
  EXPECT_NEAR(brick.product(1, 0, 1, 0) / energy, 1, 1e-5);
  EXPECT_NEAR(norm(brick.axes[0]), 1, 1e-10);
  EXPECT_NEAR(dot(brick.axes[0], brick.axes[2]), 0, 1e-10);
}

TEST(RigidBody, FallsAndFliesExactly) {
  Scene scene;
  scene.plane = Plane::stress;
  scene.gravity = Point{0, -10, 0};
  Body body{"disc", std::make_shared<Ball>(2, Point{1, 2, 0}, 0.5), 1, ""};
  body.rigid = true;
  body.mass = 3;
  scene.bodies.push_back(body);
  RigidBody disc(scene, 0);
  disc.gravity = *scene.gravity;
  disc.velocity = {2, 0, 0};
  disc.begin_forces();
  disc.start_from(1, 0.01);
  for (int step = 0; step < 100; ++step) {
    disc.begin_forces();
    disc.kick(1, 0.01);
    disc.drift(0.01);
  }
  EXPECT_NEAR(disc.centre()[0], 3, 1e-12);
  EXPECT_NEAR(disc.centre()[1], 2 - 5, 1e-12);  // 10 t^2 / 2 at t = 1 s: the leap-frog is exact for it
  const Projection s = disc.project(0, disc.centre() + Point{0.3, 0.4 - 0.1, 0});
  EXPECT_NEAR(s.gap, std::hypot(0.3, 0.3) - 0.5, 1e-12);
}

}  // namespace
}  // namespace femsph
