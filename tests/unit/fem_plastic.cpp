// A plastic body stretched uniformly has the law's own stress at every quadrature point of every element,
// whatever turn is superposed.

#include <gtest/gtest.h>

#include <numbers>

#include "fem_scalar_loop.hpp"
#include "fem_support.hpp"
#include "model/material/point.hpp"

namespace femsph::test {
namespace {

std::unique_ptr<Discretization> plastic_body(Plane plane, bool large, Element element, bool scalar = false) {
  Scene s = box_scene(plane, {0.08, 0.06, 0.05});
  s.large_motion = large;
  s.materials.at("m").parameters = Plasticity{300e6, 210e9 / 99};
  fem::Options o;
  o.element = element;
  o.divisions = {3, 3, 3};
  o.distortion = 0.2;
  if (scalar) o.loop = make_scalar_loop;
  return fem::discretize(s, 0, o);
}

Law law_of(Plane plane) { return Plastic{LinearElastic::make(210e9, 0.3, 7850, plane), {300e6, 210e9 / 99}}; }

/// Stretch diag(1 + a, 1 + b, 1 + c), then a turn by `angle` about z.
std::vector<double> motion(const Discretization& d, double a, double b, double c, double angle) {
  const double k = std::cos(angle), s = std::sin(angle);
  return field(d, [=](const Point& X) {
    const double x = (1 + a) * X[0], y = (1 + b) * X[1];
    return Point{k * x - s * y - X[0], s * x + k * y - X[1], c * X[2]};
  });
}

// Small strain: Cauchy stress is the law's. In large motion the law sees the steps dU / Umid, which add up to
// ln U, and gives the Kirchhoff stress tau = J sigma.
TEST(FemPlastic, UniformStretchGivesTheLawsOwnStress) {
  const double a = 0.008, b = -0.002, c = -0.001;
  for (Element element : all_elements)
    for (Plane plane : {Plane::stress, Plane::strain, Plane::none})
      for (bool large : {false, true})
        for (bool scalar : {false, true}) {
          const auto d = plastic_body(plane, large, element, scalar);
          MaterialPoint point(law_of(plane));
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
          const MaterialState state = state_of(*d, u);
          ASSERT_GT(law.plastic_strain, 0.004);
          for (std::size_t i = 0; i < state.stress.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
              ASSERT_NEAR(state.stress[i][k], law.stress[k] / (large ? U[0] * U[1] * U[2] : 1),
                          1e-10 * law.equivalent);
              ASSERT_NEAR(state.strain[i][k], U[k] - 1, 1e-12);
            }
            ASSERT_NEAR(state.plastic[i], law.plastic_strain, 1e-12);
          }
          const double volume = 0.08 * 0.06 * (plane == Plane::none ? 0.05 : 1);
          EXPECT_NEAR(
              d->energies(u.data()).strain, law.stored_energy * volume, 1e-9 * law.stored_energy * volume);
          EXPECT_NEAR(
              d->energies(u.data()).plastic, law.plastic_work * volume, 1e-9 * law.plastic_work * volume);
        }
}

TEST(FemPlastic, TurningTheBodyChangesNothing) {
  const double a = 0.008, b = -0.002, c = -0.001, turn = 2 * std::numbers::pi;
  for (Element element : all_elements)
    for (Plane plane : {Plane::stress, Plane::none}) {
      const auto d = plastic_body(plane, true, element);
      force(*d, motion(*d, a, b, c, 0));
      const MaterialState start = state_of(*d, motion(*d, a, b, c, 0));
      force(*d, motion(*d, a, b, c, 0.25 * turn));
      const MaterialState quarter = state_of(*d, motion(*d, a, b, c, 0.25 * turn));
      for (int k = 1; k <= 73; ++k) force(*d, motion(*d, a, b, c, 10 * turn * k / 73));
      const MaterialState end = state_of(*d, motion(*d, a, b, c, 10 * turn));
      const double scale = start.stress[0][0];
      for (std::size_t i = 0; i < start.stress.size(); ++i) {
        ASSERT_NEAR(quarter.stress[i][0], start.stress[i][1], 1e-10 * scale);
        ASSERT_NEAR(quarter.stress[i][1], start.stress[i][0], 1e-10 * scale);
        for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(end.stress[i][k], start.stress[i][k], 1e-10 * scale);
        ASSERT_NEAR(end.plastic[i], start.plastic[i], 1e-12);
      }
    }
}

}  // namespace
}  // namespace femsph::test
