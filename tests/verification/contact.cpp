// Contact and rigid bodies against exact solutions, with both solvers and between the two.

#include "model/motion/effects/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "contact_support.hpp"

namespace femsph::test {
namespace {

constexpr double c_bar = 5172.194, rho = 7850;  // sqrt(2.1e11 / 7850)

/// Bars of length L that meet end to end at +-v behave as against a rigid wall: force rho c v A while waves
/// run to the free ends and back, 2 L / c, and then each has turned its velocity round: the impulse is 2 m v.
/// The contact is as compliant as four spacings (its penalty is a quarter of rho c^2 / d) of 200: about 1 %
/// of the time.
void expect_impact(const compare::RunResult& r, double v, const char* method) {
  const double L = 0.1, area = 1e-4, last = 2 * L / c_bar, F = rho * c_bar * v * area;
  EXPECT_NEAR(std::abs(mean(r, "contact_impact_force_x", 0.2 * last, 0.8 * last)) / F, 1, 0.01) << method;
  const auto &t = r.history["time"].values, &f = r.history["contact_impact_force_x"].values;
  double end = 0, impulse = 0;
  for (std::size_t k = 1; k < t.size(); ++k) {
    impulse += 0.5 * (t[k] - t[k - 1]) * std::abs(f[k] + f[k - 1]);
    if (std::abs(f[k]) > 0.5 * F) end = t[k];
  }
  EXPECT_NEAR(end / last, 1, 0.03) << method;
  EXPECT_NEAR(impulse / (2 * rho * L * area * v), 1, 0.02) << method;
  EXPECT_EQ(f.front(), 0) << method;  // they touch at the start: no force
  EXPECT_EQ(f.back(), 0) << method;   // and are apart at the end
  EXPECT_LT(std::abs(r.ledger.imbalance()), 0.005 * r.ledger.initial) << method;
  for (const auto& [key, value] : r.derived)
    if (key == "impact depth" || key == "contact shortens the step")
      fmt::print("{}: {} {}\n", method, key, value);
  fmt::print("{}: force {:.4f}, time {:.4f}, impulse {:.4f}, imbalance {:.2e}\n", method,
             std::abs(mean(r, "contact_impact_force_x", 0.2 * last, 0.8 * last)) / F, end / last,
             impulse / (2 * rho * L * area * v), r.ledger.imbalance() / r.ledger.initial);
}

TEST(Contact, TwoBarsExchangeTheirVelocities) {
  const Scene scene = steel_bodies(
      block("left", "-100 0 mm", "100 10 mm") + block("right", "0 0 mm", "100 10 mm") +
      moving("left", "1 0 m/s") + moving("right", "-1 0 m/s") + touching("left", "right") +
      lasting(60e-6, 1000));
  for (const char* method : both) expect_impact(run(scene, method, 1), 1, method);
  for (const char* methods : {"left=fem-full,right=sph-corrected", "left=sph-corrected,right=fem-full"})
    expect_impact(run(scene, methods, 1), 1, methods);
}

TEST(Contact, BarAgainstARigidWall) {
  const Scene scene = steel_bodies(
      rigid_block("wall", "-20 -20 mm", "20 50 mm", "1 kg") + block("bar", "0 0 mm", "100 10 mm") +
      held("wall") + moving("bar", "-1 0 m/s") + touching("wall", "bar") + lasting(60e-6, 1000));
  for (const char* method : both) expect_impact(run(scene, method, 1), 1, method);
}

// A mass M at speed V strikes the free end of a fixed bar of mass m = mu M (St Venant). With xi = c t / L the
// stress at the fixed end is
//   s / (rho c V) = 2 e^(-mu (xi - 1)) for 1 < xi < 3, and that + 2 e^(-mu (xi - 3)) (1 - 2 mu (xi - 3)) for
//   3 < xi < 5:
// greatest at xi = 3, 2 (1 + e^(-2 mu)) = 2.270, 2.736 for mu = 1, 0.5. The wave front rings where it is
// discretized, so the peak is read from the ratio of the means of both histories over 0.05 to 0.25 L/c behind
// it, 20 spacings off the root (a boundary particle shows its own stress). The contact delays the front by
// about three times the spacings it yields by, and behind the front the stress falls by 4.3 a L/c: hence a
// stiffness of 4, one spacing of 800. (Stiffer contacts open and close more often: energy within 1 % instead
// of 0.5 %.)
TEST(Contact, RigidMassOnAFixedBar) {
  const double L = 0.2, m = rho * L * 1e-5;
  for (const double mu : {1.0, 0.5}) {
    const Scene scene = steel_bodies(
        rigid_block("mass", "200 -5 mm", "20 12 mm", fmt::format("{:.9f} kg", m / mu)) +
        block("bar", "0 0 mm", "200 1 mm") + moving("mass", "-1 0 m/s") + touching("mass", "bar") +
        "stiffness = 4.0\n" + scene_text::support("x-", "x", scene_text::of_body("bar")) +
        scene_text::probe("root", "stress", "5 0.5 mm", scene_text::of_body("bar")) +
        lasting(5 * L / c_bar, 2000));
    for (const char* method : both) {
      const auto r = run(scene, method, 0.25);
      double found = 0, exact = 0;
      for (std::size_t k = 0; k < r.history.rows(); ++k) {
        const double xi = c_bar * r.history["time"].values[k] / L;
        if (xi < 3.05 || xi > 3.25) continue;
        found -= r.history["root_xx"].values[k] / (rho * c_bar);
        exact += 2 * std::exp(-mu * (xi - 1)) + 2 * std::exp(-mu * (xi - 3)) * (1 - 2 * mu * (xi - 3));
      }
      const double peak = found / exact * 2 * (1 + std::exp(-2 * mu));
      EXPECT_NEAR(error(peak, mu == 1 ? 2.270 : 2.736), 0, 3) << method << " " << mu;
      EXPECT_LT(std::abs(r.ledger.imbalance()), 0.01 * r.ledger.initial) << method;
      EXPECT_EQ(r.history["mass_turn"].values.size(), r.history.rows());
      fmt::print("{} mu {}: peak {:.4f}, imbalance {:.2e}\n", method, mu, peak,
                 r.ledger.imbalance() / r.ledger.initial);
    }
  }
}

// A block at rest on a wall: the contact carries its weight, 7850 x 0.02 x 0.02 x 0.01 x 9.81 = 0.30803 N.
TEST(Contact, RestingBlockPressesWithItsWeight) {
  const Scene scene = steel_bodies(
      rigid_block("wall", "-50 -20 mm", "200 20 mm", "1 kg") + block("block", "0 0 mm", "20 20 mm") +
          held("wall") + "[gravity]\nacceleration = " + scene_text::list("0 -9.81 m/s^2") + "\n" +
          touching("wall", "block") + scene_text::settling("damping") + lasting(20e-3, 10),
      "0.3");
  for (const char* method : both) {
    const auto r = run(scene, method, 2);
    EXPECT_TRUE(r.settled) << method;
    EXPECT_NEAR(last(r, "contact_impact_force_y") / 0.30803, 1, 1e-3) << method;
    EXPECT_NEAR(last(r, "contact_impact_force_x"), 0, 1e-9) << method;
  }
}

// A block pressed on a wall by N = 0.2668 N (its weight times cos 30) and pulled along it by N tan 30, both
// growing over 0.5 ms, slowly against the 10 us in which it swings on the penalty. It sticks for mu = 0.7
// (the spring gives by about 1e-11 m), and for mu = 0.2 slides with a = N (tan 30 - 0.2) / m = 3.2059 m/s^2:
// a (t_r^2 / 6 + t_r (t - t_r) / 2 + (t - t_r)^2 / 2) by the time t.
TEST(Contact, FrictionHoldsOrLetsSlide) {
  const double t = 2e-3, ramp = 5e-4, N = 7850 * 4e-6 * 9.81 * std::cos(std::acos(-1.0) / 6);
  const double exact = 3.2059 * (ramp * ramp / 6 + ramp * (t - ramp) / 2 + (t - ramp) * (t - ramp) / 2);
  for (const double mu : {0.7, 0.2}) {
    const Scene scene = steel_bodies(
        rigid_block("slope", "-50 -20 mm", "200 20 mm", "1 kg") + block("block", "0 0 mm", "20 20 mm") +
            held("slope") + touching("slope", "block", mu) +
            scene_text::load("all", fmt::format("{:.9f} {:.9f} N", N / std::sqrt(3.0), -N),
                             scene_text::of_body("block") + "history = {ramp = \"0.5 ms\"}\n") +
            scene_text::probe("middle", "displacement", "10 10 mm", scene_text::of_body("block")) +
            lasting(t, 50),
        "0.3");
    for (const char* method : both) {
      const auto r = run(scene, method, 2);
      const double slid = last(r, "middle_x");
      fmt::print("{} mu {}: slid {:.4g} m ({:.4f}), work {:.3e} J, friction {:.3e} J, imbalance {:.2e} J\n",
                 method, mu, slid, slid / exact, r.ledger.external, r.ledger.friction, r.ledger.imbalance());
      if (mu > 0.577) {
        EXPECT_LT(std::abs(slid), 1e-9) << method;
        continue;
      }
      EXPECT_NEAR(slid / exact, 1, 0.02) << method;
      EXPECT_LT(std::abs(r.ledger.imbalance()), 0.005 * r.ledger.external) << method;
      EXPECT_NEAR(r.ledger.friction / r.ledger.external, 0.2 * std::sqrt(3.0), 0.01) << method;
    }
  }
}

}  // namespace
}  // namespace femsph::test
