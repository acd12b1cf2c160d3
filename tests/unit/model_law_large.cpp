// Plasticity at large strain, driven through LargeStrain along paths of the displacement gradient.
//   Uniaxial stress, Kirchhoff J2 with logarithmic strain: tau = E ln l below yield, then tau = Y + Et-line
//   in ln l; sigma = tau / J. Simple shear F = [[1, g], [0, 1]], elastic, Green-Naghdi rate, tan b = g/2
//   (Dienes, Acta Mechanica 32, 1979):
//     tau_xx = -tau_yy = 4 mu (cos 2b ln cos b + b sin 2b - sin^2 b),  tau_xy = 2 mu cos 2b (2b - 2 tan 2b ln
//     cos b - tan b).

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/material/laws/point_stress.hpp"
#include "model/material/spatial_state.hpp"
#include "model_law_support.hpp"

namespace femsph::test {
namespace {

/// A point driven along a path of displacement gradients.
template <int dim>
struct Driven {
  explicit Driven(const Plastic& law) : law(law) {}
  void to(const Tensor<double, dim>& H) {
    R = LargeStrain::strain<double, dim>(H, strain);
    tau = advance_law<Plastic, double, dim, LargeStrain>(law, strain, state);
    now = H;
  }
  Tensor<double, dim> piola() const {
    Tensor<double, dim> P;
    LargeStrain::piola<double, dim>(R, strain, tau, P);
    return P;
  }
  std::array<double, 6> cauchy() const {
    std::array<double, 6> s, e;
    spatial_state<LargeStrain>(law, now, tau, strain, history_of<Plastic, dim>(state), s, e);
    return s;
  }
  Plastic law;
  double state[point_state_size<Plastic, dim>] = {};
  Symmetric<double, dim> strain{}, tau{};
  LargeStrain::Frame<double, dim> R{};
  Tensor<double, dim> now{};
};

// Bar pulled to four times its length under uniaxial stress: the cross stretch is found in each step so that
// tau_yy = tau_zz = 0.
TEST(LargePlasticity, UniaxialStressFollowsTheLogarithm) {
  const double H = 1e9, final_stretch = 4;
  const int steps = 2000;
  Driven<3> bar(plastic_law(Plane::none, {yield_stress, H}));
  double cross = 1;
  for (int n = 1; n <= steps; ++n) {
    const double l = std::exp(std::log(final_stretch) * n / steps);
    const auto at = [&](double c) {
      return Tensor<double, 3>{{{l - 1, 0, 0}, {0, c - 1, 0}, {0, 0, c - 1}}};
    };
    const Driven<3> before = bar;
    cross = root(cross * 0.9999, cross, [&](double c) {
      Driven<3> trial = before;
      trial.to(at(c));
      return trial.tau[1];
    });
    bar.to(at(cross));
  }
  const double p = history_of<Plastic, 3>(bar.state)[Plastic::equivalent_strain];
  // ln l = tau/E + p, tau = Y + H p
  const double ln = std::log(final_stretch), tau = (yield_stress + H * ln) / (1 + H / young);
  EXPECT_NEAR(bar.tau[0], tau, 1e-6 * tau);
  EXPECT_NEAR(p, ln - tau / young, 1e-6);
  EXPECT_NEAR(std::log(final_stretch * cross * cross), (1 - 2 * poisson) * tau / young,
              1e-7);  // volume: elastic only
  const double J = final_stretch * cross * cross;
  EXPECT_NEAR(bar.cauchy()[0], tau / J, 1e-6 * tau);
  // The force on the undeformed section: P_xx = tau / l
  EXPECT_NEAR(bar.piola()[0][0], bar.tau[0] / final_stretch, 1e-12 * tau);
}

TEST(LargePlasticity, ElasticSimpleShearIsThatOfTheGreenNaghdiRate) {
  const int steps = 4000;
  Driven<2> point(plastic_law(Plane::strain, {1e6 * yield_stress, 0}));
  for (int n = 1; n <= steps; ++n) point.to(Tensor<double, 2>{{{0, 3.0 * n / steps}, {0, 0}}});
  const double b = std::atan(1.5), c = std::log(std::cos(b));
  const double xx = 4 * shear * (std::cos(2 * b) * c + b * std::sin(2 * b) - std::sin(b) * std::sin(b));
  const double xy = 2 * shear * std::cos(2 * b) * (2 * b - 2 * std::tan(2 * b) * c - std::tan(b));
  const auto s = point.cauchy();  // J = 1
  EXPECT_NEAR(s[0], xx, 1e-6 * shear);
  EXPECT_NEAR(s[1], -xx, 1e-6 * shear);
  EXPECT_NEAR(s[3], xy, 1e-6 * shear);
}

// Perfect plasticity in simple shear: the stress stays on the surface, and the work is Y p.
TEST(LargePlasticity, SimpleShearFlowsAtTheYieldStress) {
  const int steps = 4000;
  Driven<3> point(plastic_law(Plane::none, {yield_stress, 0}));
  for (int n = 1; n <= steps; ++n)
    point.to(Tensor<double, 3>{{{0, 4.0 * n / steps, 0}, {0, 0, 0}, {0, 0, 0}}});
  EXPECT_NEAR((plastic::von_mises<double, 3>({point.tau, 0.0})), yield_stress, 1e-12 * yield_stress);
  const double* history = history_of<Plastic, 3>(point.state);
  const double p = history[Plastic::equivalent_strain];
  // The work is at most that of a stress along the rate of deformation, whose equivalent is dg/sqrt(3).
  EXPECT_LE(p, 4 / std::sqrt(3.0));
  EXPECT_GT(p, 0.9 * 4 / std::sqrt(3.0));
  EXPECT_NEAR(history[Plastic::work], yield_stress * p, 1e-3 * yield_stress * p);
}

// After any deformation: turning by 90 degrees or by ten turns and a bit changes neither the co-rotated
// stress nor the history.
TEST(LargePlasticity, RotationChangesNothing) {
  Driven<2> point(plastic_law(Plane::strain));
  for (int n = 1; n <= 100; ++n)
    point.to(Tensor<double, 2>{{{0.004 * n, 0.003 * n}, {-0.001 * n, -0.002 * n}}});
  const auto tau = point.tau;
  const double p = point.state[6];
  Tensor<double, 2> F = point.now;
  for (int i = 0; i < 2; ++i) F[i][i] += 1;
  const double turns = 10.37 * 2 * std::acos(-1.0);
  for (int n = 1; n <= 5000; ++n) {
    const double c = std::cos(turns * n / 5000), s = std::sin(turns * n / 5000);
    Tensor<double, 2> H;
    for (int j = 0; j < 2; ++j) {
      H[0][j] = c * F[0][j] - s * F[1][j] - (j == 0);
      H[1][j] = s * F[0][j] + c * F[1][j] - (j == 1);
    }
    point.to(H);
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(point.tau[k], tau[k], 1e-10 * yield_stress);
  EXPECT_NEAR(point.state[6], p, 1e-12 * p);
  EXPECT_GT(p, 0.1);
}

// P F^T is symmetric and P : dF is the work tau : d, whatever the stress: random paths, with stress not
// coaxial with U.
TEST(LargePlasticity, AngularMomentumAndWork) {
  std::mt19937 engine(21);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  for (int turn = 0; turn < 20; ++turn) {
    Driven<3> point(plastic_law(Plane::none));
    Tensor<double, 3> H{};
    for (int corner = 0; corner < 3; ++corner) {
      for (auto& row : H.a)
        for (double& h : row) h = uniform(engine);
      point.to(H);
    }
    const auto P = point.piola();
    Tensor<double, 3> F = H, small = H;
    for (int i = 0; i < 3; ++i) F[i][i] += 1;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) {
        double skew = 0;
        for (int k = 0; k < 3; ++k) skew += P[i][k] * F[j][k] - P[j][k] * F[i][k];
        EXPECT_NEAR(skew, 0, 1e-13 * yield_stress);
      }
    double work = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double d = 1e-6 * uniform(engine);
        small[i][j] += d;
        work += P[i][j] * d;
      }
    Symmetric<double, 3> after;
    LargeStrain::strain<double, 3>(small, after);
    const auto d = LargeStrain::increment<double, 3>(point.strain, after);
    EXPECT_NEAR(contract(point.tau, d), work, 1e-5 * std::abs(work) + 1e-10 * yield_stress);
    Symmetric<double, 3> dU;
    for (int k = 0; k < 6; ++k) dU[k] = after[k] - point.strain[k];
    EXPECT_NEAR(contract(LargeStrain::conjugate<double, 3>(point.strain, point.tau), dU), work,
                1e-5 * std::abs(work) + 1e-10 * yield_stress);
  }
}

// Strains of 1e-4 with small turns: what SmallStrain gives, to a few of those strains.
TEST(LargePlasticity, SmallStrainIsTheSmallStrainLaw) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Plastic law = plastic_law(plane, {1e-4 * young * 0.5, hardening});
    Driven<2> large(law);
    double small[point_state_size<Plastic, 2>] = {};
    for (int n = 1; n <= 50; ++n) {
      const double t = 0.1 * n;
      const Tensor<double, 2> H{
          {{1e-4 * std::sin(t), 4e-5 * std::sin(2 * t)}, {2e-5 * std::sin(t), -8e-5 * std::sin(0.7 * t)}}};
      large.to(H);
      Symmetric<double, 2> e;
      SmallStrain::strain<double, 2>(H, e);
      const auto s = advance_law<Plastic, double, 2>(law, e, small);
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(large.tau[k], s[k], 1e-3 * 1e-4 * young);
    }
  }
}

}  // namespace
}  // namespace femsph::test
