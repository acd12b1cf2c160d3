// The neo-Hookean law against its energy and against closed forms, in space, plane strain and plane stress.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/material/spatial_state.hpp"
#include "model_law_support.hpp"

namespace femsph::test {
namespace {

constexpr double E = 17e6, nu = 0.45;

template <int dim>
Symmetric<double, dim> random_strain(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Symmetric<double, dim> e;
  for (int k = 0; k < symmetric_size<dim>; ++k) e[k] = uniform(engine);
  return e;
}

template <int dim>
double energy(const NeoHookean& law, const Symmetric<double, dim>& e) {
  return law.stored_energy<double, dim>(e, {}, nullptr);
}

/// T_ij = d psi / d U_ij; of a shear both components move together.
template <int dim>
void expect_gradient(Plane plane) {
  const NeoHookean law = NeoHookean::make(E, nu, 1100, plane);
  std::mt19937 engine(3);
  for (int turn = 0; turn < 50; ++turn) {
    const auto e = random_strain<dim>(engine, 0.25);
    const auto T = law.stress(e);
    for (int k = 0; k < symmetric_size<dim>; ++k) {
      auto up = e, down = e;
      const double h = 1e-5;
      up[k] += h, down[k] -= h;
      const double slope = (energy<dim>(law, up) - energy<dim>(law, down)) / (2 * h);
      EXPECT_NEAR(k < dim ? T[k] : 2 * T[k], slope, 2e-8 * E) << k;
    }
  }
}

TEST(NeoHookean, StressIsTheGradientOfItsEnergy) {
  expect_gradient<3>(Plane::none);
  expect_gradient<2>(Plane::strain);
  expect_gradient<2>(Plane::stress);
}

// psi of a diagonal stretch, written out by hand with the library's logarithm; plane stress by bisection on
// dpsi/dt.
TEST(NeoHookean, EnergyOfADiagonalStretch) {
  const double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const auto psi = [&](double a, double b, double c) {
    const double l = std::log(a * b * c);
    return mu / 2 * (a * a + b * b + c * c - 3) - mu * l + lambda / 2 * l * l;
  };
  for (const double a : {0.3, 0.8, 1.0, 1.3, 4.0})
    for (const double b : {0.5, 1.1, 2.0}) {
      EXPECT_NEAR(energy<3>(NeoHookean::make(E, nu, 1, Plane::none), {a - 1, b - 1, 0.2, 0, 0, 0}),
                  psi(a, b, 1.2), 1e-13 * E * (1 + a * a));
      EXPECT_NEAR(energy<2>(NeoHookean::make(E, nu, 1, Plane::strain), {a - 1, b - 1, 0}), psi(a, b, 1),
                  1e-13 * E * (1 + a * a));
      double low = 1e-3, high = 1e3;
      for (int turn = 0; turn < 200; ++turn) {
        const double t = std::sqrt(low * high);
        (mu * (t - 1 / t) + lambda * std::log(a * b * t) / t > 0 ? high : low) = t;
      }
      const NeoHookean law = NeoHookean::make(E, nu, 1, Plane::stress);
      EXPECT_NEAR(law.thickness_strain({a - 1, b - 1, 0}, {}, nullptr), low - 1, 1e-13 * (1 + low))
          << a << " " << b;
      EXPECT_NEAR(energy<2>(law, {a - 1, b - 1, 0}), psi(a, b, low), 1e-12 * E * (1 + a * a));
    }
}

TEST(NeoHookean, SmallStrainIsLinearElasticity) {
  std::mt19937 engine(5);
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const auto e = random_strain<2>(engine, 1e-8);
    const auto linear = LinearElastic::make(E, nu, 1, plane).stress(e),
               T = NeoHookean::make(E, nu, 1, plane).stress(e);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(T[k], linear[k], 1e-7 * std::abs(linear[0]) + 1e-7 * std::abs(linear[1]));
  }
  const auto e = random_strain<3>(engine, 1e-8);
  const auto linear = LinearElastic::make(E, nu, 1, Plane::none).stress(e),
             T = NeoHookean::make(E, nu, 1, Plane::none).stress(e);
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(T[k], linear[k], 1e-7 * std::abs(linear[0]) + 1e-7 * std::abs(linear[1]));
}

TEST(NeoHookean, EightLanesAreEightPoints) {
  std::mt19937 engine(9);
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const NeoHookean law = NeoHookean::make(E, nu, 1, plane);
    Symmetric<Pack, 2> pack;
    Symmetric<double, 2> one[lanes];
    for (int l = 0; l < lanes; ++l) {
      one[l] = random_strain<2>(engine, l < 4 ? 0.4 : 1e-4);
      for (int k = 0; k < 3; ++k) pack[k][l] = one[l][k];
    }
    const auto T = law.stress(pack);
    for (int l = 0; l < lanes; ++l)
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(T[k][l], law.stress(one[l])[k], 1e-14 * E);
  }
}

TEST(NeoHookean, NoVolumeIsNotANumber) {
  const NeoHookean law = NeoHookean::make(E, nu, 1, Plane::strain);
  EXPECT_TRUE(std::isnan(law.stress(Symmetric<double, 2>{-1.0, 0, 0})[0]));
  EXPECT_TRUE(std::isnan(law.stress(Symmetric<double, 2>{-1.2, 0, 0})[0]));
}

// sigma_xx of uniaxial strain l: (mu (l^2 - 1) + lambda ln l) / l; the same point turned by 90 degrees shows
// it along y.
TEST(NeoHookean, CauchyStressInSpace) {
  const double l = 1.5, mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const NeoHookean law = NeoHookean::make(E, nu, 1, Plane::strain);
  const Tensor<double, 2> H{{{-1, -1}, {l, -1}}};  // F = R diag(l, 1), R by 90 degrees
  Symmetric<double, 2> e;
  FiniteRotation::strain<double, 2>(H, e);
  std::array<double, 6> s, strain;
  spatial_state<FiniteRotation>(law, H, law.stress(e), e, nullptr, s, strain);
  EXPECT_NEAR(s[1], (mu * (l * l - 1) + lambda * std::log(l)) / l, 1e-13 * E);
  EXPECT_NEAR(s[0], lambda * std::log(l) / l, 1e-13 * E);
  EXPECT_NEAR(s[2], lambda * std::log(l) / l, 1e-13 * E);
  EXPECT_NEAR(s[3], 0, 1e-13 * E);
  EXPECT_NEAR(strain[1], l - 1, 1e-14);
}

}  // namespace
}  // namespace femsph::test
