// Return mapping against closed forms, the flow rule solved again, and the three-dimensional law.

#include <random>

#include "model/material/laws/return_mapping.hpp"
#include "model_law_support.hpp"

namespace femsph::test {
namespace {

using plastic::PointStress, plastic::von_mises;

constexpr double near = 1e-8;

// Uniaxial stress is a straight line of slope Et = E H/(E + H) = E/100 beyond yield:
// sigma = (sigma_y + H eps)/(1 + H/E) = 318 MPa at eps = 0.01, p = eps - sigma/E.
TEST(Return, UniaxialStress) {
  for (Plane plane : {Plane::stress, Plane::none}) {
    const auto at = [&](double lateral) {
      return MaterialPoint(plastic_law(plane))
          .advance({0.01, lateral, plane == Plane::none ? lateral : 0, 0, 0, 0});
    };
    const PointState s = at(root(-0.003, -0.005, [&](double e) { return at(e).stress[1]; }));
    EXPECT_NEAR(s.stress[0], 318e6, near * 318e6);
    EXPECT_NEAR(s.plastic_strain, 0.01 - 318e6 / young, near * 0.0085);
    EXPECT_NEAR(s.equivalent, 318e6, near * 318e6);
    EXPECT_NEAR(s.strain_across, -poisson * 318e6 / young - 0.5 * s.plastic_strain, near * 0.005);
  }
}

// Uniaxial strain eps = 0.005: q_trial = 2G eps, p = (q_trial - sigma_y)/(3G + H), pressure K eps, sx = K eps
// + 2/3 q, sy = K eps - q/3.
TEST(Return, UniaxialStrain) {
  const double p = (2 * shear * 0.005 - yield_stress) / (3 * shear + hardening),
               q = yield_stress + hardening * p, pressure = young / 1.2 * 0.005;
  EXPECT_NEAR(pressure + 2 * q / 3, 1077.93725e6, 5);
  EXPECT_NEAR(pressure - q / 3, 773.53138e6, 5);
  for (Plane plane : {Plane::strain, Plane::none}) {
    const PointState s = MaterialPoint(plastic_law(plane)).advance({0.005, 0, 0, 0, 0, 0});
    EXPECT_NEAR(s.stress[0], pressure + 2 * q / 3, near * 1e9);
    EXPECT_NEAR(s.stress[1], pressure - q / 3, near * 1e9);
    EXPECT_NEAR(s.stress[2], pressure - q / 3, near * 1e9) << "carried by the history in plane strain";
    EXPECT_NEAR(s.plastic_strain, p, near * p);
  }
}

// Equal biaxial plane stress: sx = sy = q, eps = q (1 - nu)/E + p/2, q = sigma_y + H p.
TEST(Return, EqualBiaxialPlaneStress) {
  const double q = (0.005 + 0.5 * yield_stress / hardening) / ((1 - poisson) / young + 0.5 / hardening);
  EXPECT_NEAR(q, 316.73307e6, 5);
  const PointState s = MaterialPoint(plastic_law(Plane::stress)).advance({0.005, 0.005, 0, 0, 0, 0});
  for (int c : {0, 1}) EXPECT_NEAR(s.stress[c], q, near * q);
}

// One backward Euler step in plane stress solves eps = C^-1 sigma + dp ds/dsigma; here the flow rule is
// solved by bisection on m = dp/q: exx = (sx - nu sy)/E + m (sx - sy/2), eyy alike, gxy = sxy/G + 3 m sxy,
// until q = sigma_y + H m q.
TEST(Return, PlaneStressSolvesTheFlowRule) {
  const auto solved = [](const Strain& e, double m) {
    const double d = 1 / young + m, o = -poisson / young - 0.5 * m, det = d * d - o * o;
    return std::array{(d * e[0] - o * e[1]) / det, (d * e[1] - o * e[0]) / det, e[3] / (1 / shear + 3 * m)};
  };
  for (const Strain& e : {Strain{0.01, -0.003, 0, 0, 0, 0}, Strain{0.01, 0.002, 0, -0.02, 0, 0},
                          Strain{-0.3, 0.1, 0, 0.5, 0, 0}}) {
    double low = 0, high = 1 / hardening;
    std::array<double, 3> s{};
    double q = 0;
    for (int turn = 0; turn < 200; ++turn) {
      const double m = 0.5 * (low + high);
      s = solved(e, m);
      q = std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * s[2] * s[2]);
      (q > yield_stress + hardening * m * q ? low : high) = m;
    }
    const PointState now = MaterialPoint(plastic_law(Plane::stress)).advance(e);
    EXPECT_NEAR(now.stress[0], s[0], near * q);
    EXPECT_NEAR(now.stress[1], s[1], near * q);
    EXPECT_NEAR(now.stress[3], s[2], near * q);
    EXPECT_NEAR(now.equivalent, yield_stress + hardening * now.plastic_strain, 1e-12 * q);
    if (e[0] != 0.01 || e[1] != -0.003) continue;
    EXPECT_NEAR(now.stress[0], 346.96898e6, 5);
    EXPECT_NEAR(now.stress[1], 68.67947e6, 5);
    EXPECT_NEAR(now.equivalent, 318.23685e6, 5);
  }
}

// The projected return's steps end at the root to round-off, whatever the lateral strain, the hardening, the
// direction and the size of the trial stress. The root by bisection in long double: x of a / (1 + c x)^2 + b
// / (1 + x)^2 = (Y / (1 - k x))^2, k = H/3G, and then p = x q / 3G.
TEST(Return, PlaneStressEndsAtTheRoot) {
  for (const double nu : {-0.9, -0.5, 0.0, 0.3, 0.49})
    for (const double k : {0.0, 0.003, 0.5, 3.0})
      for (const double size : {1.0 + 1e-9, 1.001, 1.1, 3.0, 40.0, 1000.0})
        for (int direction = 0; direction < 16; ++direction) {
          const LinearElastic elastic = LinearElastic::make(young, nu, 7850, Plane::stress);
          const double angle = 0.2 * direction, ratio = std::cos(angle),
                       shear = 0.5 * std::sin(1.3 * direction);
          PointStress<double, 2> trial{{std::sin(angle), ratio, shear}, 0.0};
          const double scale = size * yield_stress / von_mises(trial);
          for (double& x : trial.in.a) x *= scale;
          const auto [sx, sy, sxy] = std::array<long double, 3>{trial.in[0], trial.in[1], trial.in[2]};
          const long double c = (1 + (long double)(nu)) / (3 * (1 - (long double)(nu))),
                            H = (long double)(k)*3 * (long double)(elastic.mu);
          const long double a = 0.25L * (sx + sy) * (sx + sy),
                            b = 0.75L * (sy - sx) * (sy - sx) + 3 * sxy * sxy,
                            kk = H / (3 * (long double)(elastic.mu));
          const auto q = [&](long double x) {
            return std::sqrt(a / ((1 + c * x) * (1 + c * x)) + b / ((1 + x) * (1 + x)));
          };
          long double low = 0, high = k > 0 ? std::min(1e6L, 1 / kk) : 1e6L;
          for (int turn = 0; turn < 200; ++turn) {
            const long double x = 0.5L * (low + high);
            (q(x) * (1 - kk * x) > (long double)(yield_stress) ? low : high) = x;
          }
          const plastic::Flow<double> flow = plastic::projected_return(
              elastic, double(H), yield_stress, trial);
          const double p = double(low * q(low)) / (3 * elastic.mu);
          // p = x q / 3G with q = Y / (1 - k x): a rounding of x counts 1 / (1 - k x) times in p. The last
          // step leaves up to 1.5e-14 (return_mapping.hpp), and near the surface the error is that of q_trial
          // - Y.
          const double left = 2e-14 + 4 * 2.2e-16 / double(1 - kk * low);
          EXPECT_NEAR(flow.equivalent, p, left * p + 3e-15 * yield_stress / elastic.mu)
              << "nu " << nu << " k " << k << " size " << size << " direction " << direction;
          EXPECT_NEAR(von_mises(trial), double(q(low)), 1e-13 * double(q(low)));
        }
}

// Eight lanes with overshoots from 0 to 1000 Y: lanes that converge at once are beside lanes that take many
// iterations. Each one ends at its root (by bisection in long double), and lanes that do not yield keep their
// state.
TEST(Return, PlaneStressLanesEndAtTheirOwnRoots) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1), direction(-1, 1);
  for (int turn = 0; turn < 4000; ++turn) {
    const LinearElastic elastic = LinearElastic::make(young, -0.9 + 1.39 * unit(random), 7850, Plane::stress);
    const double k = turn % 4 == 0 ? 0 : std::pow(10, -4 + 4.5 * unit(random)), H = k * 3 * elastic.mu;
    const double reach = turn % 3 == 0 ? 1e-3
                         : turn % 3 == 1
                             ? 0.3
                             : 1e3;  // the first two: every lane by the series, some by Newton's steps
    PointStress<Pack, 2> trial{};
    Pack yield{};
    for (int l = 0; l < lanes; ++l) {
      yield[l] = yield_stress * (0.5 + unit(random));
      PointStress<double, 2> s{{direction(random), direction(random), direction(random)}, 0.0};
      const double overshoot = l == 7 && turn % 2 ? -0.1 : reach * std::pow(10, -8 * unit(random)),
                   scale = (1 + overshoot) * yield[l] / von_mises(s);
      for (int c = 0; c < 3; ++c) trial.in[c][l] = scale * s.in[c];
    }
    PointStress<Pack, 2> now = trial;
    const plastic::Flow<Pack> flow = plastic::projected_return(elastic, H, yield, now);
    for (int l = 0; l < lanes; ++l) {
      const long double sx = trial.in[0][l], sy = trial.in[1][l], sxy = trial.in[2][l], Y = yield[l],
                        nu = elastic.poisson, kk = (long double)(H) / (3 * (long double)(elastic.mu));
      const long double c = (1 + nu) / (3 * (1 - nu)), a = 0.25L * (sx + sy) * (sx + sy),
                        b = 0.75L * (sy - sx) * (sy - sx) + 3 * sxy * sxy;
      if (a + b <= Y * Y) {
        EXPECT_EQ(flow.equivalent[l], 0);
        EXPECT_EQ(flow.across[l], 0);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(now.in[i][l], trial.in[i][l]);
        continue;
      }
      const auto q = [&](long double x) {
        return std::sqrt(a / ((1 + c * x) * (1 + c * x)) + b / ((1 + x) * (1 + x)));
      };
      long double low = 0, high = kk > 0 ? std::min(1e9L, 1 / kk) : 1e9L;
      for (int halving = 0; halving < 120; ++halving) {
        const long double x = 0.5L * (low + high);
        (q(x) * (1 - kk * x) > Y ? low : high) = x;
      }
      const double p = double(low * q(low)) / (3 * elastic.mu), size = double(q(low));
      ASSERT_NEAR(flow.equivalent[l], p, 1e-12 * p + 1e-14 * size / elastic.mu)
          << "turn " << turn << " lane " << l;
      const double u = double(0.5L * (sx + sy) / (1 + c * low)), half = double(0.5L * (sy - sx) / (1 + low));
      ASSERT_NEAR(now.in[0][l], u - half, 1e-12 * size);
      ASSERT_NEAR(now.in[1][l], u + half, 1e-12 * size);
      ASSERT_NEAR(now.in[2][l], double(sxy / (1 + low)), 1e-12 * size);
      ASSERT_NEAR(flow.across[l], -double(low) * u / (3 * elastic.mu), 1e-12 * p + 1e-14 * size / elastic.mu);
    }
  }
}

// Perfect plasticity, a strain path e perpendicular to s: with z = 2G|e|/R, R = sqrt(2/3) sigma_y, the angle
// psi between s and e obeys d psi/dz = -sin psi from pi/2, so psi = 2 atan(exp(-z)) (Krieg & Krieg 1977).
// Radial return is first order in the step.
TEST(Return, NonProportionalPathConverges) {
  const double z = 2, radius = std::sqrt(2.0 / 3) * yield_stress;
  const auto error = [&](int steps) {
    MaterialPoint point(plastic_law(Plane::none, with(Integration::return_mapping, 0)));
    const double g = yield_stress / std::sqrt(3.0) / shear;  // pure shear at yield
    point.advance({0, 0, 0, g, 0, 0});
    PointState s;
    for (int k = 1; k <= steps; ++k) {
      const double e = z * radius / (2 * shear) / std::sqrt(2.0) * k / steps;
      s = point.advance({e, -e, 0, g, 0, 0});
    }
    return std::abs(std::atan2(std::sqrt(2.0) * s.stress[3], std::sqrt(0.5) * (s.stress[0] - s.stress[1])) -
                    2 * std::atan(std::exp(-z)));
  };
  for (int steps : {50, 100, 200}) EXPECT_GT(error(steps) / error(2 * steps), std::pow(2, 0.95));
  EXPECT_LT(std::abs(2 * error(2000) - error(1000)), 1e-6);
}

// Plane stress is the law in space whose exz, eyz are 0 and whose ezz makes szz vanish.
TEST(Return, PlaneStressIsTheLawInSpaceWithoutThicknessStress) {
  MaterialPoint plane(plastic_law(Plane::stress)), space(plastic_law(Plane::none));
  double ezz = 0;
  for (const Strain& e : crooked_path(Plane::stress, 60)) {
    const auto trial = [&](double z) { return MaterialPoint(space).advance({e[0], e[1], z, e[3], 0, 0}); };
    ezz = root(ezz, ezz + 1e-4, [&](double z) { return trial(z).stress[2]; });
    const PointState a = plane.advance(e), b = space.advance({e[0], e[1], ezz, e[3], 0, 0});
    for (int c : {0, 1, 3}) ASSERT_NEAR(a.stress[c], b.stress[c], near * yield_stress);
    ASSERT_NEAR(a.strain_across, ezz, near * 0.01);
    ASSERT_NEAR(a.plastic_strain, b.plastic_strain, near * 0.01);
    ASSERT_NEAR(a.plastic_work, b.plastic_work, near * yield_stress * 0.01);
    ASSERT_NEAR(a.stored_energy, b.stored_energy, near * yield_stress * 0.01);
  }
  EXPECT_GT(plane.advance({}).plastic_strain, 0.01);
}

TEST(Return, UnloadingIsElastic) {
  for (Plane plane : planes) {
    MaterialPoint point(plastic_law(plane)), elastic(LinearElastic::make(young, poisson, 7850, plane));
    const PointState loaded = point.advance({0.01, -0.002, 0, 0.004, 0, 0}),
                     back = point.advance({0.0095, -0.0018, 0, 0.0038, 0, 0});
    const PointState change = elastic.advance({-0.0005, 0.0002, 0, -0.0002, 0, 0});
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(back.stress[c] - loaded.stress[c], change.stress[c], 1e-12 * young);
    EXPECT_GT(loaded.plastic_strain, 0);
    EXPECT_EQ(back.plastic_strain, loaded.plastic_strain);
    EXPECT_EQ(back.plastic_work, loaded.plastic_work);
  }
}

}  // namespace
}  // namespace femsph::test
