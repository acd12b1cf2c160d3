// What follows from the adjoint form, for every element, on distorted cells under a random displacement:
//   energy       force = -dE/du, with E the stored and the hourglass energy; in small strain f = -K u,
//                E = 1/2 u K u, K symmetric
//   momentum     sum f = 0 and sum x cross f = 0, with x the current position (in small strain, where only
//                infinitesimal rotations are rigid, the initial one)
//   objectivity  x -> R x turns the forces and keeps the energy; a rigid rotation by 90 degrees gives no
//   force

#include <gtest/gtest.h>

#include "fem_support.hpp"

namespace femsph::test {
namespace {

class Balance : public testing::TestWithParam<std::tuple<Element, int>> {
 protected:
  enum class Of { elastic, neo_hookean, plastic };
  std::unique_ptr<Discretization> make(bool large, Of law = Of::elastic) const {
    const bool solid = std::get<1>(GetParam()) == 3;
    Scene scene = box_scene(
        solid ? Plane::none : Plane::strain, {1.2, 0.8, solid ? 0.9 : 0.0}, 2.0, 0.3, solid ? 1.0 : 0.7);
    scene.large_motion = large;
    if (law == Of::neo_hookean) scene.materials.at("m").parameters = NeoHookean::Parameters{};
    if (law == Of::plastic) scene.materials.at("m").parameters = Plasticity{0.02, 0.05};
    fem::Options options;
    options.element = std::get<0>(GetParam());
    options.divisions = {4, 3, 2};
    options.distortion = 0.15;
    return fem::discretize(scene, 0, options);
  }
  static double energy(const Discretization& d, const std::vector<double>& u) {
    return d.energies(u.data()).strain + d.energies(u.data()).hourglass;
  }
  static void expect_momentum(const Discretization& d, const std::vector<double>& f,
                              const std::vector<double>& moved) {
    Point sum{}, moment{};
    const Layout& l = d.layout();
    for (std::size_t i = 0; i < l.points; ++i) {
      Point x = d.position(i), F{};
      for (int c = 0; c < l.dim; ++c) {
        x[c] += moved[l.at(i, c)];
        F[c] = f[l.at(i, c)];
      }
      for (int c = 0; c < 3; ++c) {
        sum[c] += F[c];
        moment[c] += x[(c + 1) % 3] * F[(c + 2) % 3] - x[(c + 2) % 3] * F[(c + 1) % 3];
      }
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(sum[c], 0, 1e-13 * largest(f));
      EXPECT_NEAR(moment[c], 0, 1e-13 * largest(f));
    }
  }
};

TEST_P(Balance, SmallStrainForceIsMinusKu) {
  const auto d = make(false);
  const auto u = random_field(*d, 0.01, 1), w = random_field(*d, 0.01, 2);
  const auto Ku = stiffness(*d, u), Kw = stiffness(*d, w), f = force(*d, u);
  EXPECT_NEAR(dot(w, Ku), dot(u, Kw), 1e-13 * dot(u, Ku));
  EXPECT_NEAR(energy(*d, u), 0.5 * dot(u, Ku), 1e-13 * dot(u, Ku));
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f[i], -Ku[i], 1e-13 * largest(f));
  expect_momentum(*d, f, std::vector<double>(f.size(), 0.0));
}

TEST_P(Balance, OnlyRigidMotionsAreFree) {
  // u K u > 0 for whatever is not rigid: smallest over random fields and over the 2 dx wave that full
  // reduction would not see.
  const auto d = make(false);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto u = random_field(*d, 0.01, seed);
    EXPECT_GT(dot(u, stiffness(*d, u)), 1e-3 * dot(u, u));
  }
}

TEST_P(Balance, LargeMotionForceIsMinusTheGradientOfTheEnergy) {
  // Central difference along a random direction: error O(step^2) + round-off / step, both below 1e-7 of the
  // largest term.
  for (const Of law : {Of::elastic, Of::neo_hookean}) {
    const auto d = make(true, law);
    const auto u = random_field(*d, 0.04, 1), direction = random_field(*d, 1.0, 2);
    const double step = 1e-5;
    std::vector<double> up = u, down = u;
    for (std::size_t i = 0; i < u.size(); ++i) {
      up[i] += step * direction[i];
      down[i] -= step * direction[i];
    }
    const auto f = force(*d, u);
    const double scale = std::sqrt(dot(f, f) * dot(direction, direction));
    EXPECT_NEAR((energy(*d, up) - energy(*d, down)) / (2 * step), -dot(f, direction), 1e-7 * scale);
    expect_momentum(*d, f, u);
  }
}

// Plastic flow leaves a stress that is not coaxial with the stretch: the forces keep momentum and angular
// momentum all the same, and turn with the body: a turn by 97 degrees keeps the co-rotated state.
TEST_P(Balance, PlasticForcesKeepMomentumAndTurn) {
  const auto d = make(true, Of::plastic);
  std::vector<double> u, f;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    u = random_field(*d, 0.05, seed);
    f = force(*d, u);
  }
  EXPECT_GT(d->energies(u.data()).plastic, 0.2 * d->energies(u.data()).strain);
  expect_momentum(*d, f, u);
  const double c = std::cos(1.7), s = std::sin(1.7);
  std::vector<double> turned = u, expected = f;
  for (std::size_t i = 0; i < d->layout().points; ++i) {
    const std::size_t x = d->layout().at(i, 0), y = d->layout().at(i, 1);
    const Point X = d->position(i);
    const double now[2] = {X[0] + u[x], X[1] + u[y]};
    turned[x] = c * now[0] - s * now[1] - X[0], turned[y] = s * now[0] + c * now[1] - X[1];
    expected[x] = c * f[x] - s * f[y], expected[y] = s * f[x] + c * f[y];
  }
  const auto g = force(*d, turned);
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(g[i], expected[i], 1e-12 * largest(f));
}

TEST_P(Balance, ForcesTurnWithTheBody) {
  const auto d = make(true);
  const Layout& l = d->layout();
  const auto u = random_field(*d, 0.03, 3);
  const double c = std::cos(2.0), s = std::sin(2.0);
  const auto turned = [&](const Point& x) { return Point{c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]}; };
  std::size_t i = 0;
  const auto w = field(*d, [&](const Point& X) {
    Point x = X;
    for (int k = 0; k < l.dim; ++k) x[k] += u[l.at(i, k)];
    ++i;
    const Point y = turned(x);
    return Point{y[0] - X[0], y[1] - X[1], y[2] - X[2]};
  });
  const auto f = force(*d, u), g = force(*d, w);
  EXPECT_NEAR(energy(*d, u), energy(*d, w), 1e-12 * energy(*d, u));
  for (std::size_t p = 0; p < l.points; ++p) {
    Point F{};
    for (int k = 0; k < l.dim; ++k) F[k] = f[l.at(p, k)];
    F = turned(F);
    for (int k = 0; k < l.dim; ++k) EXPECT_NEAR(g[l.at(p, k)], F[k], 1e-12 * largest(f));
  }
}

TEST_P(Balance, RigidRotationBy90DegreesGivesNoStress) {
  const auto d = make(true);
  const auto u = field(*d, [](const Point& x) { return Point{-x[1] - x[0], x[0] - x[1], 0}; });
  const MaterialState state = state_of(*d, u);
  for (const auto& s : state.stress)
    for (const double x : s) EXPECT_NEAR(x, 0, 1e-14);  // E = 2
  EXPECT_LT(largest(force(*d, u)), 1e-14);
  EXPECT_LT(energy(*d, u), 1e-27);
}

INSTANTIATE_TEST_SUITE_P(Fem, Balance,
                         testing::Combine(testing::ValuesIn(all_elements), testing::Values(2, 3)));

}  // namespace
}  // namespace femsph::test
