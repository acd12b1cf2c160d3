// Classic SPH on updated neighbours: the packed passes against loops over all pairs, and what must hold for
// any motion of the particles.

#include <gtest/gtest.h>

#include <limits>

#include "sph_updated_support.hpp"

namespace femsph::test {
namespace {

template <int dim, class LawType>
void compare_with_plain(Plane plane, bool plastic, sph::KernelKind kind, double smoothing) {
  Scene scene = box_scene(plane, dim == 3 ? Point{0.06, 0.05, 0.04} : Point{0.13, 0.1, 0}, true);
  if (plastic) scene.materials.at("steel").parameters = Plasticity{300e6, 2.1e9};
  sph::Options options = classic(0.01, sph::MassRule::trapezoid);
  options.kernel = kind;
  options.smoothing = smoothing;
  options.jitter = 0.2;
  options.viscosity = {1.5, 2, 0.01};
  const auto moving = sph::discretize(scene, 0, options);
  const double thickness = scene.bodies[0].thickness;
  PlainUpdated<dim, LawType> plain{
      *moving,
      std::get<LawType>(scene.materials.at("steel").law(plane)),
      sph::Kernel(kind, dim, smoothing * moving->spacing()),
      options.viscosity,
      thickness,
      7850,
      {}};
  for (double m : moving->mass()) plain.volume.push_back(m / 7850 / thickness);
  plain.stress.resize(plain.volume.size());
  plain.history.resize(plain.volume.size());
  AlignedVector<double> f(moving->layout().size, 0.0), g = f, F = f, G = f, before = swirl(*moving, 0);
  const int steps = 12;
  const double dt = 1e-6;
  for (int k = 0; k <= steps; ++k) {
    const AlignedVector<double> u = swirl(*moving, double(k) / steps);
    const AlignedVector<double> v = velocity_to(u, before, dt);
    moving->internal_force(u.data(), v.data(), k == 0 ? 0 : dt, f.data(), g.data());
    plain.step(u, v, k == 0 ? 0 : dt, F, G);
    ASSERT_LE(apart(f, F), 1e-12 * largest(F)) << "step " << k;
    ASSERT_LE(apart(g, G), 1e-12 * largest(G)) << "step " << k;
  }
  EXPECT_GT(largest(F), 0);
  EXPECT_GT(largest(G), 0);
  EXPECT_NE(plain.work, 0);
  EXPECT_NEAR(plastic ? moving->energies(nullptr).plastic : moving->energies(nullptr).strain, plain.work,
              1e-12 * std::abs(plain.work));
  double sum = 0, size = 0;
  for (double x : f) sum += x, size += std::abs(x);
  EXPECT_LT(std::abs(sum), 1e-14 * size);  // pairs are equal and opposite
}

TEST(UpdatedLagrangianSlow, IsThePlainSumOverAllPairs) {
  compare_with_plain<2, LinearElastic>(Plane::stress, false, sph::KernelKind::cubic_spline, 1.2);
  compare_with_plain<2, LinearElastic>(Plane::strain, false, sph::KernelKind::wendland_c2, 1.6);
  compare_with_plain<3, LinearElastic>(Plane::none, false, sph::KernelKind::cubic_spline, 1.2);
}

TEST(UpdatedLagrangianSlow, IsThePlainSumOverAllPairsBeyondYield) {
  compare_with_plain<2, Plastic>(Plane::stress, true, sph::KernelKind::cubic_spline, 1.0);
  compare_with_plain<2, Plastic>(Plane::strain, true, sph::KernelKind::cubic_spline, 1.2);
  compare_with_plain<3, Plastic>(Plane::none, true, sph::KernelKind::wendland_c2, 1.3);
}

TEST(UpdatedLagrangian, DoesNotDependOnTheThreads) {
  const Scene scene = box_scene(Plane::stress, {2.0, 0.5, 0}, true);  // 201 x 51: enough for two threads
  sph::Options options = classic(0.01, sph::MassRule::share);
  options.viscosity = {1, 1, 1};
  AlignedVector<double> force_of[2];
  for (int threads : {1, 2}) {
    set_threads(threads);
    const auto d = sph::discretize(scene, 0, options);
    ASSERT_GT(d->layout().points, serial_below);  // else one thread does it all
    AlignedVector<double> f(d->layout().size, 0.0), g = f, before = swirl(*d, 0);
    for (int k = 0; k <= 5; ++k) {
      const AlignedVector<double> u = swirl(*d, 0.1 * k);
      const AlignedVector<double> v = velocity_to(u, before, 1e-6);
      d->internal_force(u.data(), v.data(), k == 0 ? 0 : 1e-6, f.data(), g.data());
    }
    set_threads(1);
    force_of[threads - 1] = f;
  }
  EXPECT_GT(largest(force_of[0]), 0);
  EXPECT_EQ(force_of[0], force_of[1]);
}

// A restored run goes on to the same bits, wherever its last neighbour search was.
TEST(UpdatedLagrangian, GoesOnFromASavedState) {
  Scene scene = box_scene(Plane::strain, {0.3, 0.2, 0}, true);
  scene.materials.at("steel").parameters = Plasticity{300e6, 2.1e9};
  sph::Options options = classic(0.01, sph::MassRule::share);
  options.viscosity = {1, 1, 1};
  const auto whole = sph::discretize(scene, 0, options), later = sph::discretize(scene, 0, options);
  AlignedVector<double> f(whole->layout().size, 0.0), g = f, F = f, G = f, before = swirl(*whole, 0);
  for (int k = 0; k <= 60; ++k) {
    const AlignedVector<double> u = swirl(*whole, 0.02 * k);
    const AlignedVector<double> v = velocity_to(u, before, 1e-6);
    whole->internal_force(u.data(), v.data(), k == 0 ? 0 : 1e-6, f.data(), g.data());
    if (k > 23) later->internal_force(u.data(), v.data(), 1e-6, F.data(), G.data());
    if (k == 23) {
      MemoryArchive saved;
      saved.save(*whole);
      saved.restore(*later);
    }
  }
  EXPECT_GT(whole->energies(nullptr).plastic, 0);
  EXPECT_EQ(whole->energies(nullptr).plastic, later->energies(nullptr).plastic);
  EXPECT_EQ(f, F);
  EXPECT_EQ(g, G);
}

// With positions of a march that diverges, a call still ends soon and takes no more memory.
TEST(UpdatedLagrangian, SurvivesPositionsThatAreNoNumbers) {
  const Scene scene = box_scene(Plane::stress, {0.4, 0.3, 0}, true);
  for (double wild : {nan, infinite, 1e300, 1e9, 40.0}) {
    const auto d = sph::discretize(scene, 0, classic(0.01, sph::MassRule::share));
    AlignedVector<double> u(d->layout().size, 0.0), f = u;
    d->internal_force(u.data(), u.data(), 0, f.data(), nullptr);
    const std::size_t bytes = d->bytes();
    for (int k = 1; k <= 20; ++k) {
      for (std::size_t i = 0; i < d->layout().points; ++i)
        if (i % std::size_t(k) == 0) u[d->layout().at(i, int(i % 2))] = wild * std::sin(double(i * k));
      d->internal_force(u.data(), u.data(), 1e-6, f.data(), nullptr);
    }
    EXPECT_LT(d->bytes(), 3 * bytes) << wild;
  }
}

TEST(UpdatedLagrangian, ReportsParticlesWithoutNeighboursAndHeaps) {
  const Scene scene = box_scene(Plane::stress, {0.4, 0.3, 0}, true);
  const auto d = sph::discretize(scene, 0, classic(0.01, sph::MassRule::share));
  AlignedVector<double> u(d->layout().size, 0.0), f = u;
  const auto go = [&] {
    d->internal_force(u.data(), f.data(), 0, f.data(), nullptr);
    return d->trouble(u.data());
  };
  EXPECT_FALSE(go());
  u[d->layout().at(40, 0)] = 0.5;  // the corner flies off
  const auto loss = go();
  ASSERT_TRUE(loss);
  EXPECT_NE(loss->what.find("particle 40 has lost its neighbours: 0 of 3 are left"), std::string::npos)
      << loss->what;
  EXPECT_NEAR(loss->position[0], 0.91, 1e-12);
  for (std::size_t i = 0; i < d->layout().points; ++i)
    for (int c = 0; c < 2; ++c) u[d->layout().at(i, c)] = -d->position(i)[std::size_t(c)];
  const auto heap = go();
  ASSERT_TRUE(heap);
  EXPECT_NE(heap->what.find("one heap"), std::string::npos);
}

}  // namespace
}  // namespace femsph::test
