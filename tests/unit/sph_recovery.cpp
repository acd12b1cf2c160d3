// The one rule for reading stress (model/motion/recovery.hpp), on particles.

#include <gtest/gtest.h>

#include "sph/sph.hpp"
#include "tests/unit/recovery_cases.hpp"

namespace femsph::test {
namespace {

std::unique_ptr<Discretization> particles_of(const Scene& scene, double spacing, double jitter = 0, double hourglass = 0.1) {
  sph::Options options;
  options.spacing = spacing;
  options.jitter = jitter;
  options.hourglass = hourglass;
  return sph::discretize(scene, 0, options);
}

void expect_linear_exact(const Discretization& d, const std::vector<Point>& places) {
  const MaterialUnits units = d.material_units();
  const Recovery rule(units);
  const auto linear = [](const Point& x) { return 1 + 2 * x[0] - 3 * x[1] + 1.5 * x[2]; };
  for (const Point& p : places) {
    double sum = 0, value = 0, size = 0;
    for (const Weight& w : rule.weights(p)) sum += w.weight, size += std::abs(w.weight), value += w.weight * linear(units.place[w.point]);
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(value, linear(p), 1e-12);
    std::printf("%g ", size);
  }
  std::printf("\n");
}

TEST(SphRecovery, LinearFieldsAreExactOnAnyParticles) {
  const std::vector<Point> plane{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.53, 0.47, 0}, {1, 0.6, 0}}, space{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0.7}, {0.53, 0.47, 0.1}, {0, 0.6, 0.7}};
  for (const double jitter : {0.0, 0.25}) {
    expect_linear_exact(*particles_of(recovery_scene(std::make_shared<Box>(2, Point{}, Point{1, 0.6, 0}), Plane::stress), 0.1, jitter), plane);
    expect_linear_exact(*particles_of(recovery_scene(std::make_shared<Box>(3, Point{}, Point{1, 0.6, 0.7}), Plane::none), 0.1, jitter), space);
  }
  expect_linear_exact(*particles_of(recovery_scene(quarter_ring(2, 8), Plane::strain), 0.125), {{1, 0, 0}, {std::sqrt(2.0), std::sqrt(2.0), 0}, {0, 1.4, 0}});
}

TEST(SphRecovery, SectionOfACantilever) {
  for (const double hourglass : {0.1, 0.02})
  for (const int ny : {2, 4, 8, 16}) {
    const SectionErrors e = section_of(*particles_of(cantilever_scene(), 1.0 / ny, 0, hourglass));
    std::printf("section ny %d sxx raw %.3f rule %.3f %%, sxy raw %.3f rule %.3f %%\n", ny, e.raw_xx, e.xx, e.raw_xy, e.xy);
  }
}

TEST(SphRecovery, WallOfAThickRing) {
  for (const int n : {4, 8, 16, 32}) {
    const WallErrors e = wall_of(*particles_of(recovery_scene(quarter_ring(2, n), Plane::strain), 1.0 / n));
    std::printf("ring n %d wall %.2f %% (mid-arc %.2f), L2 %.2f %%\n", n, e.wall, e.mid_arc, e.l2);
  }
}

TEST(SphRecovery, PlasticBending) {
  for (const int ny : {2, 4, 8, 16}) {
    const auto d = particles_of(plastic_scene(), 1.0 / ny);
    const PlasticErrors e = plastic_section_of(*d);
    std::printf("plastic ny %d q/Y raw %.3f rule 1%+.1e, L2 raw %.2f rule %.2f %%\n", ny, e.raw_most, e.most - 1, e.raw_l2, e.l2);
  }
}

}  // namespace
}  // namespace femsph::test
