// A plastic body stretched uniformly has the law's own stress at every particle, whatever the motion is
// superposed.

#include <gtest/gtest.h>

#include <numbers>

#include "model/material/point.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

Scene plastic_scene(Plane plane, bool large) {
  Scene s = box_scene(plane, plane == Plane::none ? Point{0.06, 0.05, 0.04} : Point{0.08, 0.06, 0}, large);
  s.materials.at("steel").parameters = Plasticity{300e6, 2.1e11 / 99};
  return s;
}

/// Stretch diag(1 + a, 1 + b, 1 + c), then a turn by `angle` about z.
AlignedVector<double> motion(const Discretization& d, double a, double b, double c, double angle) {
  const double k = std::cos(angle), s = std::sin(angle);
  const double A[3][3] = {{k * (1 + a) - 1, -s * (1 + b), 0}, {s * (1 + a), k * (1 + b) - 1, 0}, {0, 0, c}};
  return linear_vector(d, A);
}

MaterialState all_of(const Discretization& d, const AlignedVector<double>& u) {
  std::vector<std::size_t> all(d.material_points());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  MaterialState state;
  d.material_state(u.data(), all, state);
  return state;
}

// Small strain: Cauchy stress is the law's. In large motion the law sees the steps dU / Umid, which add up to
// ln U, and gives the Kirchhoff stress tau = J sigma.
TEST(Plastic, UniformStretchGivesTheLawsOwnStress) {
  const double a = 0.008, b = -0.002, c = -0.001;
  for (Plane plane : {Plane::stress, Plane::strain, Plane::none})
    for (bool large : {false, true}) {
      const Scene scene = plastic_scene(plane, large);
      const auto d = sph::discretize(scene, 0, corrected(0.01));
      MaterialPoint point(scene.materials.at("steel").law(plane));
      PointState law;
      std::array<double, 6> seen{};
      for (int k = 1; k <= 10; ++k) {
        force(*d, motion(*d, a * k / 10, b * k / 10, c * k / 10, 0));
        const std::array<double, 3> full{a, b, plane == Plane::none ? c : 0};
        for (std::size_t i = 0; i < 3; ++i)
          seen[i] += full[i] / 10 / (large ? 1 + full[i] * (k - 0.5) / 10 : 1);
        law = point.advance(seen);
      }
      const double across = plane == Plane::none ? c
                            : large              ? std::expm1(law.strain_across)
                                                 : law.strain_across;
      const std::array<double, 3> U{1 + a, 1 + b, 1 + across};
      const auto u = motion(*d, a, b, c, 0);
      const MaterialState state = all_of(*d, u);
      ASSERT_GT(law.plastic_strain, 0.004);
      for (std::size_t i = 0; i < state.stress.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_NEAR(
              state.stress[i][k], law.stress[k] / (large ? U[0] * U[1] * U[2] : 1), 1e-10 * law.equivalent);
          ASSERT_NEAR(state.strain[i][k], U[k] - 1, 1e-12);
        }
        ASSERT_NEAR(state.plastic[i], law.plastic_strain, 1e-12);
      }
      double volume = 0;
      for (std::size_t i = 0; i < d->material_points(); ++i) volume += d->material_volume(i);
      EXPECT_NEAR(
          d->energies(u.data()).strain, law.stored_energy * volume, 1e-9 * law.stored_energy * volume);
      EXPECT_NEAR(d->energies(u.data()).plastic, law.plastic_work * volume, 1e-9 * law.plastic_work * volume);
    }
}

// Shared stencils and neighbour lists, forth and back: some lanes yield, some do not.
TEST(Plastic, LatticeEqualsLists) {
  for (Plane plane : {Plane::stress, Plane::strain, Plane::none})
    for (bool large : {false, true}) {
      const Scene scene = plastic_scene(plane, large);
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
  const double a = 0.008, b = -0.002, c = -0.001, turn = 2 * std::numbers::pi;
  for (Plane plane : {Plane::stress, Plane::none}) {
    const auto d = sph::discretize(plastic_scene(plane, true), 0, corrected(0.01));
    force(*d, motion(*d, a, b, c, 0));
    const MaterialState start = all_of(*d, motion(*d, a, b, c, 0));
    force(*d, motion(*d, a, b, c, 0.25 * turn));
    const MaterialState quarter = all_of(*d, motion(*d, a, b, c, 0.25 * turn));
    for (int k = 1; k <= 73; ++k) force(*d, motion(*d, a, b, c, 10 * turn * k / 73));
    const MaterialState end = all_of(*d, motion(*d, a, b, c, 10 * turn));
    const double scale = start.stress[0][0];
    for (std::size_t i = 0; i < start.stress.size(); ++i) {
      ASSERT_NEAR(quarter.stress[i][0], start.stress[i][1], 1e-10 * scale);
      ASSERT_NEAR(quarter.stress[i][1], start.stress[i][0], 1e-10 * scale);
      for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(end.stress[i][k], start.stress[i][k], 1e-10 * scale);
      ASSERT_NEAR(end.plastic[i], start.plastic[i], 1e-12);
    }
  }
}

// Classic SPH with updated neighbours, inside the body: the law sees the same strain, to the size of the
// strain. What the stress does is stored or taken.
TEST(Plastic, UpdatedNeighboursSeeThePlasticLaw) {
  Scene scene = plastic_scene(Plane::stress, true);
  const auto d = sph::discretize(scene, 0, classic(0.005, sph::MassRule::full));
  const int steps = 100;
  const double a = 0.004, dt = 1e-7;
  AlignedVector<double> f(d->layout().size, 0.0), v = motion(*d, a / (steps * dt), 0, 0, 0);
  d->internal_force(motion(*d, 0, 0, 0, 0).data(), v.data(), 0, f.data(), nullptr);
  double work = 0;
  AlignedVector<double> before = f;
  for (int k = 1; k <= steps; ++k) {
    d->internal_force(motion(*d, a * k / steps, 0, 0, 0).data(), v.data(), dt, f.data(), nullptr);
    for (std::size_t i = 0; i < f.size(); ++i) work -= 0.5 * dt * v[i] * (before[i] + f[i]);
    before = f;
  }
  MaterialPoint point(scene.materials.at("steel").law(Plane::stress));
  PointState law;
  for (int k = 1; k <= steps; ++k) law = point.advance({a * k / steps, 0, 0, 0, 0, 0});
  const std::size_t middle = 6 * 17 + 8;
  const MaterialState state = all_of(*d, f);
  EXPECT_NEAR(state.stress[middle][0], law.stress[0], 0.02 * law.stress[0]);
  EXPECT_NEAR(state.plastic[middle], law.plastic_strain, 0.03 * law.plastic_strain);
  const double taken = d->energies(nullptr).plastic;
  EXPECT_GT(taken, 0.3 * work);
  EXPECT_NEAR(d->energies(nullptr).strain + taken, work, 0.02 * work);
}

}  // namespace
}  // namespace femsph::test
