// The SPH operator: exact on linear fields where it is corrected, the adjoint of its own strain in every
// formulation, and the same in both packings, for any number of threads.

#include <gtest/gtest.h>

#include "sph_support.hpp"

namespace femsph::test {
namespace {

constexpr double gradient_of_field[3][3] = {{1e-4, 3e-5, -2e-5}, {-5e-5, 2e-4, 4e-5}, {6e-5, -1e-5, -3e-4}};

struct Variant {
  const char* name;
  Plane plane;
  sph::Options options;
};

std::vector<Variant> variants() {
  using sph::Boundary, sph::MassRule;
  std::vector<Variant> out{
      {"classic share", Plane::stress, classic(0.01, MassRule::share)},
      {"classic full", Plane::strain, classic(0.01, MassRule::full)},
      {"classic trapezoid", Plane::stress, classic(0.01, MassRule::trapezoid)},
      {"virtual", Plane::stress, classic(0.01, MassRule::trapezoid, Boundary::virtual_particles)},
      {"virtual share", Plane::stress, classic(0.01, MassRule::share, Boundary::virtual_particles)},
      {"weight", Plane::stress, classic(0.01, MassRule::share, Boundary::weight)},
      {"corrected", Plane::stress, corrected(0.01)},
      {"corrected 1.2", Plane::strain, corrected(0.01, 1.2)},
      {"classic 3D", Plane::none, classic(0.01, MassRule::full)},
      {"virtual 3D", Plane::none, classic(0.01, MassRule::trapezoid, Boundary::virtual_particles)},
      {"corrected 3D", Plane::none, corrected(0.01)},
      {"corrected 3D 1.2", Plane::none, corrected(0.01, 1.2)},
  };
  Variant wendland{"corrected Wendland", Plane::stress, corrected(0.01, 1.5)};
  wendland.options.kernel = sph::KernelKind::wendland_c2;
  out.push_back(wendland);
  for (std::size_t k : {0u, 6u, 10u}) {
    Variant irregular = out[k];
    irregular.name = "irregular";
    irregular.options.jitter = 0.2;
    out.push_back(irregular);
  }
  return out;
}

Point size_for(Plane plane) { return plane == Plane::none ? Point{0.09, 0.06, 0.05} : Point{0.21, 0.13, 0}; }

// Sums of the numbers below are over some hundred terms, so round-off is a few hundred units in the last
// place.
constexpr double round_off = 1e-12;

TEST(SphOperator, CorrectedGradientOfALinearFieldIsExact) {
  for (const Variant& v : variants()) {
    if (v.options.formulation != "corrected") continue;
    const Scene scene = box_scene(v.plane, size_for(v.plane));
    const auto d = sph::discretize(scene, 0, v.options);
    const auto u = linear_vector(*d, gradient_of_field);
    std::vector<std::size_t> all(d->material_points());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    MaterialState state;
    d->material_state(u.data(), all, state);
    for (const auto& strain : state.strain) {
      EXPECT_NEAR(strain[0], 1e-4, 1e-16) << v.name;
      EXPECT_NEAR(strain[1], 2e-4, 1e-16) << v.name;
      EXPECT_NEAR(strain[3], 0.5 * (3e-5 - 5e-5), 1e-16) << v.name;
      if (v.plane != Plane::none) continue;
      EXPECT_NEAR(strain[5], 0.5 * (6e-5 - 2e-5), 1e-16) << v.name;
    }
    EXPECT_LT(d->energies(u.data()).hourglass, round_off * d->energies(u.data()).strain) << v.name;
  }
}

// In a uniform stress the force on a particle far from the surface (4 h and more: its neighbours' corrections
// are the lattice's own) is the lattice sum of odd terms: zero.
TEST(SphOperator, UniformStressGivesNoForceInside) {
  const Scene scene = box_scene(Plane::stress, {0.21, 0.13, 0});
  for (const Variant& v : variants()) {
    if (v.plane == Plane::none || v.options.jitter > 0 || v.options.smoothing > 1.2) continue;
    Scene s = scene;
    s.plane = v.plane;
    const auto d = sph::discretize(s, 0, v.options);
    const auto u = linear_vector(*d, gradient_of_field);
    const auto f = force(*d, u);
    double inside = 0;
    for (std::size_t i = 0; i < d->layout().points; ++i) {
      const Point x = d->position(i);
      if (std::min({x[0] - 0.01, 0.22 - x[0], x[1] + 0.02, 0.11 - x[1]}) < 0.0499) continue;
      for (int c = 0; c < 2; ++c) inside = std::max(inside, std::abs(f[d->layout().at(i, c)]));
    }
    EXPECT_LT(inside, 1e-11 * largest(f)) << v.name;
  }
}

// f = -K u with K symmetric is the adjoint property; and u.K u / 2 is the energy that the law and the
// hourglass control report.
TEST(SphOperator, ForceIsTheAdjointOfTheStrain) {
  for (const Variant& v : variants()) {
    const Scene scene = box_scene(v.plane, size_for(v.plane));
    const auto d = sph::discretize(scene, 0, v.options);
    const auto x = random_vector(*d, 1), y = random_vector(*d, 2);
    const auto fx = force(*d, x), fy = force(*d, y);
    const double scale = std::abs(dot(x, fx));
    EXPECT_NEAR(dot(x, fy), dot(y, fx), round_off * scale) << v.name;
    EXPECT_NEAR(
        -0.5 * dot(x, fx), d->energies(x.data()).strain + d->energies(x.data()).hourglass, round_off * scale)
        << v.name;
    AlignedVector<double> kx(x.size());
    d->stiffness(x.data(), kx.data());
    for (std::size_t i = 0; i < kx.size(); ++i) ASSERT_NEAR(kx[i], -fx[i], round_off * largest(fx)) << v.name;
  }
}

// Linear momentum: always. Angular momentum: the strain of a small turn must vanish, which it does only with
// a corrected gradient.
TEST(SphOperator, MomentumIsKeptToRoundOff) {
  for (const Variant& v : variants()) {
    const Scene scene = box_scene(v.plane, size_for(v.plane));
    const auto d = sph::discretize(scene, 0, v.options);
    const auto f = force(*d, random_vector(*d, 3));
    double sum[3] = {}, moment[3] = {}, size = 0;
    for (std::size_t i = 0; i < d->layout().points; ++i) {
      double fi[3] = {};
      for (int c = 0; c < d->layout().dim; ++c)
        fi[c] = f[d->layout().at(i, c)], sum[c] += fi[c], size += std::abs(fi[c]);
      const Point x = d->position(i);
      for (int c = 0; c < 3; ++c)
        moment[c] += x[(c + 1) % 3] * fi[(c + 2) % 3] - x[(c + 2) % 3] * fi[(c + 1) % 3];
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(std::abs(sum[c]), 1e-13 * size) << v.name;
      if (v.options.formulation != "corrected") continue;
      EXPECT_LT(std::abs(moment[c]), 1e-13 * size) << v.name;
    }
  }
}

TEST(SphOperator, LatticeAndListsAgreeWithAllPairs) {
  for (Variant v : variants()) {
    if (v.options.boundary != sph::Boundary::none) continue;
    v.options.hourglass = 0, v.options.projection = false;
    const Scene scene = box_scene(v.plane, size_for(v.plane));
    const auto packed = sph::discretize(scene, 0, v.options);
    v.options.force_lists = true;
    const auto lists = sph::discretize(scene, 0, v.options);
    const auto u = random_vector(*packed, 4);
    const auto plain = plain_force(scene, v.options, *packed, u), f = force(*packed, u), g = force(*lists, u);
    for (std::size_t i = 0; i < f.size(); ++i) {
      ASSERT_NEAR(f[i], plain[i], 1e-12 * largest(plain)) << v.name;
      ASSERT_NEAR(g[i], plain[i], 1e-12 * largest(plain)) << v.name;
    }
  }
}

TEST(SphOperator, ThreadsDoNotChangeABit) {
  const Scene scene = box_scene(Plane::stress, {0.8, 0.4, 0});
  for (sph::Options options : {corrected(0.005), classic(0.005, sph::MassRule::share)}) {
    if (options.formulation == "classic") options.viscosity = {3, 3, 1};
    const auto d = sph::discretize(scene, 0, options);
    ASSERT_GT(d->layout().points, serial_below);
    const auto u = random_vector(*d, 5), v = random_vector(*d, 6, 1.0);
    AlignedVector<double> f[2], g[2];
    double energy[2];
    for (int t = 0; t < 2; ++t) {
      set_threads(t + 1);
      f[t].assign(u.size(), 0.0), g[t].assign(u.size(), 0.0);
      d->internal_force(u.data(), v.data(), 0, f[t].data(), d->has_viscosity() ? g[t].data() : nullptr);
      energy[t] = d->energies(u.data()).strain;
    }
    set_threads(1);
    EXPECT_EQ(f[0], f[1]);
    EXPECT_EQ(g[0], g[1]);
    EXPECT_EQ(energy[0], energy[1]);
  }
}

TEST(SphOperator, ATurnGivesNoStressWithFiniteRotation) {
  const double angle = 0.5 * std::acos(-1.0);
  double A[3][3] = {
      {std::cos(angle) - 1, -std::sin(angle), 0}, {std::sin(angle), std::cos(angle) - 1, 0}, {0, 0, 0}};
  for (Plane plane : {Plane::stress, Plane::none}) {
    const Scene scene = box_scene(plane, size_for(plane), true);
    const auto d = sph::discretize(scene, 0, corrected(0.01));
    const auto u = linear_vector(*d, A);
    const auto f = force(*d, u);
    EXPECT_LT(largest(f), 1e-12 * 2.1e11 * 0.01 * 0.1);  // E d t: the force of unit strain on one particle
    EXPECT_LT(d->energies(u.data()).hourglass + d->energies(u.data()).strain, 1e-20 * 2.1e11);
  }
}

}  // namespace
}  // namespace femsph::test
