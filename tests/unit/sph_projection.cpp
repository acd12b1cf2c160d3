// Corrected SPH on scattered particles: a uniform stress is in balance with the tractions on the sides, to
// round-off; linear fields, momenta and energy stay exact.

#include <gtest/gtest.h>

#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/ball.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/quadrilateral.hpp"
#include "model/scene/shapes/round.hpp"
#include "sph_projection_support.hpp"

namespace femsph::test {
namespace {

// Stress of `slope`: sigma = 2 mu e + lambda tr(e) I, the law's own numbers.
constexpr double slope[3][3] = {{3e-4, 1e-4, -2e-4}, {-2e-5, 5e-4, 6e-5}, {1e-4, -7e-5, -4e-4}};

std::vector<ScatteredBody> bodies() {
  using Part = Round::Part;
  const auto round = [](int dim, double inner, Part part) {
    return std::make_shared<Round>(dim, Round::Size{{}, inner, 0.1, dim == 3 ? 0.1 : 0, 2, part});
  };
  const std::array<Point, 4> corners{Point{0, 0, 0}, {0.48, 0.44, 0}, {0.48, 0.6, 0}, {0, 0.44, 0}};
  return {
      {"jittered bar", std::make_shared<Box>(2, Point{}, Point{0.4, 0.1, 0}), 0.0125, 1, 0.2},
      {"jittered bar, h = 1.4 d", std::make_shared<Box>(2, Point{}, Point{0.4, 0.1, 0}), 0.0125, 1.4, 0.2},
      {"jittered block", std::make_shared<Box>(3, Point{}, Point{0.1, 0.06, 0.08}), 0.02, 1, 0.2},
      {"disc of blocks", round(2, 0, Part::whole), 0.0125},
      {"disc of blocks, h = 1.4 d", round(2, 0, Part::whole), 0.0125, 1.4},
      {"ring, h = 1.4 d", round(2, 0.05, Part::whole), 0.0125, 1.4},
      {"quadrilateral", std::make_shared<Quadrilateral>(corners), 0.04},
      {"cylinder", round(3, 0, Part::whole), 0.033},
      {"ball", std::make_shared<OwnBall>(OwnBall::Size{{}, 0.1, 2, Part::whole, 1}), 0.033},
      {"ball, h = 1.4 d", std::make_shared<OwnBall>(OwnBall::Size{{}, 0.1, 2, Part::whole, 1}), 0.033, 1.4},
      {"quarter of a disc", round(2, 0, Part::quarter), 0.0125, 1, 0, {"x-", "y-"}},
      {"quarter of a cylinder", round(3, 0, Part::quarter), 0.025, 1, 0, {"x-", "y-", "z-"}}};
}

std::unique_ptr<Discretization> particles_of(const ScatteredBody& b, bool projection, bool large = false) {
  sph::Options o = corrected(b.spacing, b.smoothing);
  o.jitter = b.jitter, o.projection = projection;
  return sph::discretize(scene_of(b, large), 0, o);
}

/// Largest |f + t sigma a| over the largest |t sigma a|, without what symmetry planes hold: a are the
/// corners' shares of the sides.
double imbalance(const ScatteredBody& b, const Discretization& d, const AlignedVector<double>& f,
                 const double (&sigma)[3][3], double thickness) {
  std::vector<Point> area(d.layout().points, Point{});
  const bool named_all = dynamic_cast<const Quadrilateral*>(
      b.shape.get());  // those of the bounding box are the same again
  for (const std::string& side : b.shape->sides()) {
    if (named_all && side.size() == 2) continue;
    if (side == "x-" || side == "x+" || side == "y-" || side == "y+" || side == "z-" || side == "z+")
      if (std::find_if(b.planes.begin(), b.planes.end(), [&](const char* p) { return side == p; }) !=
          b.planes.end())
        continue;
    for (const PointArea& part : d.outward_areas({0, {side}, {}, {}, {}}))
      area[part.point] = area[part.point] + part.area;
  }
  double most = 0, off = 0;
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (int r = 0; r < d.layout().dim; ++r) {
      if (std::any_of(b.planes.begin(), b.planes.end(), [&](const char* p) {
            return p[0] - 'x' == r && std::abs(d.position(i)[std::size_t(r)]) < 1e-9;
          }))
        continue;
      double traction = 0;
      for (int c = 0; c < d.layout().dim; ++c) traction += sigma[r][c] * area[i][std::size_t(c)];
      most = std::max(most, std::abs(traction) * thickness);
      off = std::max(off, std::abs(f[d.layout().at(i, r)] + traction * thickness));
    }
  return off / most;
}

/// A linear field that symmetry planes allow, and its stress.
double imbalance_of(const ScatteredBody& b, bool projection) {
  const auto d = particles_of(b, projection);
  const int dim = d->layout().dim;
  double A[3][3] = {}, sigma[3][3] = {}, trace = 0;
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c)
      if (b.planes.empty() || r == c) A[r][c] = slope[r][c];
  for (int r = 0; r < dim; ++r) trace += A[r][r];
  const Scene scene = scene_of(b);
  const auto law = std::get<LinearElastic>(scene.material_of(scene.bodies[0]).law(scene.plane));
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c)
      sigma[r][c] = law.mu * (A[r][c] + A[c][r]) + (r == c ? law.lambda * trace : 0);
  return imbalance(b, *d, force(*d, linear_vector(*d, A)), sigma, scene.bodies[0].thickness);
}

TEST(Projection, UniformStressBalancesItsTractions) {
  for (const ScatteredBody& b : bodies()) {
    EXPECT_LT(imbalance_of(b, true), 1e-11) << b.name;
    EXPECT_GT(imbalance_of(b, false), 0.01) << b.name;
  }
}

// A ring of one smooth block is near balance without projection, and its displacements are more accurate
// without it: it is not projected.
TEST(Projection, NotWhereTheRowsAreNearBalance) {
  const ScatteredBody ring{
      "ring", std::make_shared<Round>(2, Round::Size{{}, 0.05, 0.1, 0, 2, Round::Part::whole}), 0.0125};
  const double as_it_comes = imbalance_of(ring, false);
  EXPECT_LT(as_it_comes, 0.05);
  EXPECT_EQ(imbalance_of(ring, true), as_it_comes);
}

// f = -K u, K symmetric, and u . K u / 2 is the energy: of strain and of hourglass control.
TEST(Projection, ForceIsTheSlopeOfTheEnergy) {
  for (const ScatteredBody& b : bodies()) {
    const auto d = particles_of(b, true);
    auto x = random_vector(*d, 1), y = random_vector(*d, 2);
    for (std::size_t i = 0; i < d->layout().points; ++i)  // symmetry planes hold what is across them
      for (const char* plane : b.planes)
        if (const int c = plane[0] - 'x'; std::abs(d->position(i)[std::size_t(c)]) < 1e-9)
          x[d->layout().at(i, c)] = y[d->layout().at(i, c)] = 0;
    const auto fx = force(*d, x), fy = force(*d, y);
    const double scale = std::abs(dot(x, fx));
    EXPECT_NEAR(dot(x, fy), dot(y, fx), 1e-12 * scale) << b.name;
    const Energies e = d->energies(x.data());
    EXPECT_NEAR(-0.5 * dot(x, fx), e.strain + e.hourglass, 1e-12 * scale) << b.name;
    EXPECT_GT(e.hourglass, 0) << b.name;
  }
}

// Of a linear field the strain is exact, and hourglass control stores no energy.
TEST(ProjectionSlow, LinearFieldsStayExact) {
  for (const ScatteredBody& b : bodies()) {
    if (!b.planes.empty()) continue;
    const auto d = particles_of(b, true);
    const auto u = linear_vector(*d, slope);
    force(*d, u);
    for (const auto& strain : state_of(*d, u).strain) {
      EXPECT_NEAR(strain[0], slope[0][0], 1e-15) << b.name;
      EXPECT_NEAR(strain[1], slope[1][1], 1e-15) << b.name;
      EXPECT_NEAR(strain[3], 0.5 * (slope[0][1] + slope[1][0]), 1e-15) << b.name;
    }
    EXPECT_LT(std::abs(d->energies(u.data()).hourglass), 1e-20 * d->energies(u.data()).strain) << b.name;
  }
}

TEST(ProjectionSlow, MomentaAreKept) {
  for (const bool large : {false, true})
    for (const ScatteredBody& b : bodies()) {
      if (!b.planes.empty()) continue;
      const auto d = particles_of(b, true, large);
      const auto u = random_vector(*d, 3);
      const auto f = force(*d, u);
      double sum[3] = {}, moment[3] = {}, size = 0;
      for (std::size_t i = 0; i < d->layout().points; ++i) {
        double fi[3] = {};
        Point x = d->position(i);
        for (int c = 0; c < d->layout().dim; ++c)
          fi[c] = f[d->layout().at(i, c)], sum[c] += fi[c], size += std::abs(fi[c]),
          x[std::size_t(c)] += large * u[d->layout().at(i, c)];
        for (int c = 0; c < 3; ++c)
          moment[c] += x[std::size_t((c + 1) % 3)] * fi[(c + 2) % 3] -
                       x[std::size_t((c + 2) % 3)] * fi[(c + 1) % 3];
      }
      for (int c = 0; c < 3; ++c) EXPECT_LT(std::abs(sum[c]), 1e-13 * size) << b.name;
      // Of the hourglass control's moment, in the deformed body, only the strain's part vanishes by itself.
      for (int c = 0; c < 3 && !large; ++c) EXPECT_LT(std::abs(moment[c]), 1e-13 * size) << b.name;
    }
}

// The quarter and the whole, each iterated by itself: forces agree to what the residual (1e-12) leaves of the
// scales, which is more by the condition of the equations; without projection they agree to round-off
// (Fitted.AQuarterIsTheWhole).
TEST(Projection, AQuarterIsTheWhole) {
  const auto disc = [](Round::Part part) {
    return std::make_shared<Round>(2, Round::Size{{}, 0, 0.1, 0, 2, part});
  };
  const ScatteredBody part{"quarter", disc(Round::Part::quarter), 0.0125, 1, 0, {"x-", "y-"}},
      all{"whole", disc(Round::Part::whole), 0.0125};
  const auto p = particles_of(part, true), w = particles_of(all, true);
  expect_same_accelerations(*p, *w, 1e-6);
}

TEST(ProjectionSlow, ThreadsDoNotChangeABit) {
  const ScatteredBody b{
      "disc", std::make_shared<Round>(2, Round::Size{{}, 0, 0.1, 0, 2, Round::Part::whole}), 0.0021};
  AlignedVector<double> f[2];
  for (int t = 0; t < 2; ++t) {
    set_threads(t + 1);
    const auto d = particles_of(b, true);
    ASSERT_GT(d->layout().points, serial_below);
    f[t] = force(*d, random_vector(*d, 5));
  }
  set_threads(1);
  EXPECT_EQ(f[0], f[1]);
}

// A lattice is not projected: with the option and without it the forces are the same.
TEST(Projection, OnlyScatteredParticlesAreProjected) {
  const ScatteredBody box{"box", std::make_shared<Box>(2, Point{}, Point{0.4, 0.1, 0}), 0.0125};
  const auto on = particles_of(box, true), off = particles_of(box, false);
  const auto u = random_vector(*on, 7);
  EXPECT_EQ(force(*on, u), force(*off, u));
  EXPECT_EQ(on->bytes(), off->bytes());
}

}  // namespace
}  // namespace femsph::test
