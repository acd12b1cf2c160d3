// A plastic body under a uniform stretch has the stress of its law at every particle, however it is turned;
// by shared stencils, by neighbour lists and on updated neighbours.

#include <gtest/gtest.h>

#include "plastic_cases.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

Scene yielding_block(Plane plane, bool large) {
  Scene s = box_scene(plane, plane == Plane::none ? Point{0.06, 0.05, 0.04} : Point{0.08, 0.06, 0}, large);
  s.materials.at("steel").parameters = Plasticity{300e6, 2.1e11 / 99};
  return s;
}

TEST(Plastic, UniformStretchGivesTheStressOfTheLaw) {
  for (Plane plane : {Plane::stress, Plane::strain, Plane::none})
    for (bool large : {false, true}) {
      const Scene scene = yielding_block(plane, large);
      const auto d = sph::discretize(scene, 0, corrected(0.01));
      double volume = 0;
      for (std::size_t i = 0; i < d->material_points(); ++i) volume += d->material_volume(i);
      expect_stress_of_law(*d, scene.materials.at("steel").law(plane), plane, large, volume);
    }
}

// Shared stencils and neighbour lists, forth and back: some lanes yield, some do not.
TEST(Plastic, LatticeEqualsLists) {
  for (Plane plane : {Plane::stress, Plane::strain, Plane::none})
    for (bool large : {false, true}) {
      const Scene scene = yielding_block(plane, large);
      sph::Options options = corrected(0.005);
      const auto lattice = sph::discretize(scene, 0, options);
      options.force_lists = true;
      const auto lists = sph::discretize(scene, 0, options);
      AlignedVector<double> u = random_vector(*lattice, 3, 2e-5), w(lists->layout().size, 0.0);
      for (int turn = 0; turn < 6; ++turn) {
        for (std::size_t i = 0; i < lattice->layout().points; ++i)
          for (int c = 0; c < lattice->layout().dim; ++c)
            w[lists->layout().at(i, c)] = u[lattice->layout().at(i, c)];
        const AlignedVector<double> a = force(*lattice, u), b = force(*lists, w);
        const double scale = largest(b);
        for (std::size_t i = 0; i < lattice->layout().points; ++i)
          for (int c = 0; c < lattice->layout().dim; ++c)
            ASSERT_NEAR(a[lattice->layout().at(i, c)], b[lists->layout().at(i, c)], 1e-12 * scale);
        for (double& x : u) x *= -1.3;
      }
      const double taken = lists->energies(w.data()).plastic;
      EXPECT_GT(taken, 0);
      EXPECT_NEAR(lattice->energies(u.data()).plastic, taken, 1e-12 * taken);
    }
}

TEST(Plastic, TurningTheBodyChangesNothing) {
  for (Plane plane : {Plane::stress, Plane::none})
    expect_turning_changes_nothing(*sph::discretize(yielding_block(plane, true), 0, corrected(0.01)));
}

// Classic SPH with updated neighbours, inside the body: the law gets the same strain, to the size of the
// strain. The work of the stress is stored energy and plastic work.
TEST(Plastic, UpdatedNeighboursSeeThePlasticLaw) {
  Scene scene = yielding_block(Plane::stress, true);
  const auto d = sph::discretize(scene, 0, classic(0.005, sph::MassRule::full));
  const int steps = 100;
  const double a = 0.004, dt = 1e-7;
  AlignedVector<double> f(d->layout().size, 0.0), v = stretched(*d, a / (steps * dt), 0, 0, 0);
  d->internal_force(stretched(*d, 0, 0, 0, 0).data(), v.data(), 0, f.data(), nullptr);
  double work = 0;
  AlignedVector<double> before = f;
  for (int k = 1; k <= steps; ++k) {
    d->internal_force(stretched(*d, a * k / steps, 0, 0, 0).data(), v.data(), dt, f.data(), nullptr);
    for (std::size_t i = 0; i < f.size(); ++i) work -= 0.5 * dt * v[i] * (before[i] + f[i]);
    before = f;
  }
  MaterialPoint point(scene.materials.at("steel").law(Plane::stress));
  PointState law;
  for (int k = 1; k <= steps; ++k) law = point.advance({a * k / steps, 0, 0, 0, 0, 0});
  const std::size_t middle = 6 * 17 + 8;
  const MaterialState state = state_of(*d, f);
  EXPECT_NEAR(state.stress[middle][0], law.stress[0], 0.02 * law.stress[0]);
  EXPECT_NEAR(state.plastic[middle], law.plastic_strain, 0.03 * law.plastic_strain);
  const double taken = d->energies(nullptr).plastic;
  EXPECT_GT(taken, 0.3 * work);
  EXPECT_NEAR(d->energies(nullptr).strain + taken, work, 0.02 * work);
}

}  // namespace
}  // namespace femsph::test
