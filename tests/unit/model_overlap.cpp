// Which bodies overlap at the start: points and edges of the one against the boundary of the other,
// as displaced.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/motion/bodies/overlap.hpp"
#include "model/motion/effects/contact_pair.hpp"
#include "model/motion/effects/ties.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/disc.hpp"
#include "model_grid.hpp"

namespace femsph {
namespace {

using test::Grid;
constexpr double tolerance = 1e-6;

/// n x m x l cells of a box in space.
struct Brick : test::FakeBody {
  Brick(Point origin, Point size, int n, int m, int l) {
    const std::size_t row = std::size_t(n) + 1, sheet = row * (std::size_t(m) + 1),
                      points = sheet * (std::size_t(l) + 1);
    layout_ = {points, 3, 3, 1, 0, 3 * points};
    mass_.assign(points, 1.0);
    topology_.kind = Topology::Kind::hexahedra;
    for (int k = 0; k <= l; ++k)
      for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i)
          points_.push_back(origin + Point{size[0] * i / n, size[1] * j / m, size[2] * k / l});
    for (int k = 0; k < l; ++k)
      for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
          const std::size_t a = std::size_t(k) * sheet + std::size_t(j) * row + std::size_t(i), b = a + row;
          topology_.cells.push_back({a, a + 1, b + 1, b, a + sheet, a + 1 + sheet, b + 1 + sheet, b + sheet});
        }
  }
  std::span<const double> mass() const override { return mass_; }
  std::vector<double> mass_;
};

MovingBody body_of(std::unique_ptr<Discretization> d) {
  MovingBody body;
  body.u.assign(d->layout().size, 0.0);
  body.discretization = std::move(d);
  return body;
}
Surface grid(Point origin, double width, double height, int n, int m) {
  return Surface(body_of(std::make_unique<Grid>(origin, width, height, n, m)), 1, 1);
}
Surface brick(Point origin, Point size, int n, int m, int l) {
  return Surface(body_of(std::make_unique<Brick>(origin, size, n, m, l)), 1, 1);
}
void shift(Surface& s, Point by) {
  for (Point& p : s.now) p = p + by;
}

// Every hundredth of a square that reaches beyond [0, 1]^2, on the rows of its points too: inside is inside,
// and the depth is the distance to the nearest side.
TEST(Overlap, KnowsInsideAndDepthInAPlane) {
  const Surface square = grid({0, 0, 0}, 1, 1, 4, 4);
  const Enclosure enclosure(square);
  for (int i = -50; i <= 150; ++i)
    for (int j = -50; j <= 150; ++j) {
      const Point p{0.01 * i, 0.01 * j, 0};
      const double exact = std::min({p[0], 1 - p[0], p[1], 1 - p[1]});
      EXPECT_NEAR(enclosure.depth(p, tolerance), std::max(0.0, exact), 1e-12) << p[0] << " " << p[1];
    }
}

// The same of a box in space whose middle layer is moved sideways: a slanted, non-convex body. |x - lean(z)|
// <= 1/2 with lean = 1 - |z - 1|.
TEST(Overlap, KnowsInsideInSpace) {
  Surface bent = brick({0, 0, 0}, {1, 1, 2}, 3, 3, 4);
  const auto lean = [](double z) { return 1 - std::abs(z - 1); };
  for (Point& p : bent.now) p[0] += lean(p[2]);
  const Enclosure enclosure(bent);
  int inside = 0;
  for (int i = -5; i <= 25; ++i)
    for (int j = -3; j <= 13; ++j)
      for (int k = -3; k <= 23; ++k) {
        const Point p{0.1 * i, 0.1 * j, 0.1 * k};
        const double exact = std::min(
            {(p[0] - lean(p[2])) / std::sqrt(2), (1 + lean(p[2]) - p[0]) / std::sqrt(2), p[1], 1 - p[1], p[2],
             2 - p[2]});
        const double depth = enclosure.depth(p, tolerance);
        EXPECT_EQ(depth > 0, exact > 1e-9) << p[0] << " " << p[1] << " " << p[2];
        inside += depth > 0;
      }
  EXPECT_GT(inside, 1000);
}

TEST(Overlap, TouchingIsNone) {
  const Surface lower = grid({0, 0, 0}, 1, 1, 4, 4);
  Surface upper = grid({0.3, 1, 0}, 1, 1, 6, 6);
  EXPECT_FALSE(overlap_of(lower, upper, tolerance));
  shift(upper, {0, -0.5e-6, 0});
  EXPECT_FALSE(overlap_of(lower, upper, tolerance));
  shift(upper, {0, -1e-5, 0});
  const auto found = overlap_of(lower, upper, tolerance);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 1.05e-5, 1e-10);

  const Surface block = brick({0, 0, 0}, {1, 1, 1}, 2, 2, 2);
  Surface beside = brick({1, 0.25, -0.5}, {1, 1, 1}, 3, 3, 3);
  EXPECT_FALSE(overlap_of(block, beside, tolerance));
  shift(beside, {-1e-3, 0, 0});
  EXPECT_NEAR(overlap_of(block, beside, tolerance).value().depth, 1e-3, 1e-9);
}

TEST(Overlap, OfABodyThatIsWhollyInsideIsFoundFromEitherSide) {
  const Surface large = grid({0, 0, 0}, 4, 4, 2, 2), small = grid({0.7, 0.7, 0}, 0.2, 0.2, 1, 1);
  EXPECT_NEAR(overlap_of(large, small, tolerance).value().depth, 0.7, 1e-9);
  EXPECT_NEAR(overlap_of(small, large, tolerance).value().depth, 0.7, 1e-9);
  const Surface room = brick({0, 0, 0}, {4, 4, 4}, 1, 1, 1), thing = brick({1, 1, 1}, {1, 1, 1}, 1, 1, 1);
  EXPECT_NEAR(overlap_of(room, thing, tolerance).value().depth, 1, 1e-9);
  EXPECT_NEAR(overlap_of(thing, room, tolerance).value().depth, 1, 1e-9);
}

// Two bars of one cell that cross: no point of the one is in the other.
TEST(Overlap, OfCrossingBodiesIsFoundByTheirEdges) {
  EXPECT_TRUE(overlap_of(grid({-2, -0.5, 0}, 4, 1, 1, 1), grid({-0.5, -2, 0}, 1, 4, 1, 1), tolerance));
  EXPECT_TRUE(overlap_of(brick({-2, -0.5, -0.5}, {4, 1, 1}, 1, 1, 1),
                         brick({-0.4, -2, -0.4}, {0.8, 4, 0.8}, 1, 1, 1), tolerance));
  EXPECT_FALSE(overlap_of(brick({-2, -0.5, -0.5}, {4, 1, 1}, 1, 1, 1),
                          brick({-0.4, -2, 0.5}, {0.8, 4, 0.8}, 1, 1, 1), tolerance));
}

// Against a rigid box: a facet that it pokes through counts, whether or not a point is in it. Against a ball:
// points, and a ball that is wholly inside.
TEST(Overlap, WithARigidBody) {
  const Surface square = grid({0, 0, 0}, 1, 1, 2, 2);
  EXPECT_FALSE(overlap_of(square, Box(2, {0.1, 1, 0}, {0.2, 1, 0}), tolerance));
  EXPECT_NEAR(overlap_of(square, Box(2, {0.1, 0.9, 0}, {0.2, 1, 0}), tolerance).value().depth, 0.1, 1e-5);
  EXPECT_TRUE(overlap_of(square, Box(2, {0.6, 0.6, 0}, {0.1, 0.1, 0}), tolerance));
  EXPECT_FALSE(overlap_of(square, Ball(2, {0.5, 1.3, 0}, 0.3), tolerance));
  EXPECT_NEAR(overlap_of(square, Ball(2, {0.5, 1.2, 0}, 0.3), tolerance).value().depth, 0.1, 1e-9);
  EXPECT_NEAR(overlap_of(square, Ball(2, {0.3, 0.3, 0}, 0.05), tolerance).value().depth, 0.3, 1e-9);
  const Surface cube = brick({0, 0, 0}, {1, 1, 1}, 1, 1, 1);
  EXPECT_FALSE(overlap_of(cube, Box(3, {0.2, 0.2, 1}, {0.1, 0.1, 1}), tolerance));
  EXPECT_NEAR(overlap_of(cube, Box(3, {0.2, 0.2, 0.95}, {0.4, 0.4, 1}), tolerance).value().depth, 0.05, 1e-5);
}

/// Two grids in contact, `upper` on `lower`; both move as displaced.
struct Pair {
  explicit Pair(bool tied, double overlap) {
    scene.plane = Plane::stress;
    scene.file = "pair.toml";
    scene.materials["m"] = Material{"m", 1, 0, Grid::rho};
    scene.bodies.push_back({"lower", std::make_shared<Box>(2, Point{0, 0, 0}, Point{1, 1, 0}), 1, "m"});
    scene.bodies.push_back(
        {"upper", std::make_shared<Box>(2, Point{0, 1 - overlap, 0}, Point{1, 1, 0}), 1, "m"});
    scene.contacts.push_back({"fit", {0, 1}, 1, 0, {7, 1}, tied});
    for (int b = 0; b < 2; ++b) {
      MovingBody body = body_of(
          std::make_unique<Grid>(Point{0, b == 0 ? 0 : 1 - overlap, 0}, 1, 1, 4 + 2 * b, 4 + 2 * b));
      body.index = std::size_t(b);
      body.v = body.f = body.u;
      for (std::size_t i = 0; i < body.u.size(); ++i)
        body.inverse_mass.push_back(1 / body.discretization->mass()[i / 2]);
      bodies.push_back(std::move(body));
    }
  }
  std::string press() {
    ContactPair pair(
        scene, scene.contacts[0], {ContactPair::Party{false, 0}, ContactPair::Party{false, 1}}, bodies);
    try {
      pair.add_forces(bodies, none, 0, 0);
    } catch (const MotionError& e) {
      return e.what();
    }
    return "";
  }
  std::string tie() {
    try {
      Ties(scene, bodies);
    } catch (const MotionError& e) {
      return e.what();
    }
    return "";
  }
  Scene scene;
  std::vector<MovingBody> bodies;
  std::vector<RigidBody> none;
};

// What counts is where the bodies are: an interference that the displacements at the start take away is none,
// and one that they make is one.
TEST(Overlap, IsThatOfTheDisplacedBodies) {
  Pair fit(false, 0.01);
  EXPECT_EQ(fit.press(),
            "pair.toml:7:1: contact \"fit\": the bodies overlap by 10 mm at the start; expected them apart "
            "or touching, at (0.25, 1, 0) m");
  for (std::size_t i = 1; i < fit.bodies[1].u.size(); i += 2) fit.bodies[1].u[i] = 0.02;
  EXPECT_EQ(fit.press(), "");
  Pair apart(false, -0.01);
  EXPECT_EQ(apart.press(), "");
  for (std::size_t i = 1; i < apart.bodies[1].u.size(); i += 2) apart.bodies[1].u[i] = -0.5;
  EXPECT_THAT(apart.press(), testing::HasSubstr("the bodies overlap by"));
}

TEST(Overlap, OfTiedBodiesCountsMassTwice) {
  EXPECT_EQ(Pair(true, 0).tie(), "");
  EXPECT_THAT(Pair(true, 0.4).tie(),
              testing::AllOf(testing::HasSubstr("contact \"fit\": the bodies overlap by"),
                             testing::HasSubstr("mass twice; expected them to touch")));
}

}  // namespace
}  // namespace femsph
