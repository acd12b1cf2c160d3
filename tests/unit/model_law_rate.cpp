// Johnson-Cook: the stress after a step against the formula in the library's own functions, and an adiabatic
// curve at a fixed rate against an independent integration of dT/dp = chi Y(p, T) / (rho c). Steel
// 42CrMo4-like numbers; pure shear, q = sqrt(3) tau.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/material/kinematics.hpp"
#include "model/material/laws/point_stress.hpp"
#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/reader.hpp"
#include "model_law_support.hpp"

namespace femsph::test {
namespace {

using testing::HasSubstr;

constexpr double A = 792e6, B = 510e6, exponent = 0.26, C = 0.014, rate = 1.0, softening = 1.03,
                 melting = 1793, room = 298, heat = 0.9 / (7850 * 477.0);

Plastic steel(Plane plane, bool with_rate, bool with_heat) {
  Plasticity p{A, 0};
  p.johnson_cook = JohnsonCook{
      B, exponent, with_rate ? C : 0, rate, softening, with_heat ? melting : 0, room, room, heat};
  return {LinearElastic::make(young, poisson, 7850, plane), p};
}

double formula(double p, double pdot, double T) {
  const double hot = std::min(1.0, std::max(0.0, (T - room) / (melting - room)));
  return (A + B * std::pow(p, exponent)) * (1 + C * std::log(std::max(pdot / rate, 1.0))) *
         (1 - std::pow(hot, softening));
}

template <int dim>
double equivalent(const Plastic& law, const Symmetric<double, dim>& s, const double* history) {
  return plastic::von_mises<double, dim>({s, law.stress_across<double, dim>(history)});
}

// Random steps of many sizes: after a plastic step the stress lies on the yield surface of the end of the
// step, to round-off.
template <int dim>
void expect_on_the_surface(Plane plane) {
  Plastic law = steel(plane, true, true);
  std::mt19937 engine(11);
  std::normal_distribution<double> normal(0, 1);
  Symmetric<double, dim> s{};
  double history[Plastic::history_size<dim>] = {};
  int flowed = 0;
  for (int n = 0; n < 3000; ++n) {
    law.set_step(std::pow(10.0, -8 + 3 * std::fmod(0.37 * n, 1.0)));
    const double size = 1e-2 * std::pow(10.0, -3 * std::fmod(0.61 * n, 1.0));
    Symmetric<double, dim> d;
    for (int k = 0; k < symmetric_size<dim>; ++k) d[k] = size * normal(engine);
    const double before = history[Plastic::equivalent_strain], work = history[Plastic::work];
    law.update(d, s, history);
    const double p = history[Plastic::equivalent_strain], dp = p - before,
                 q = equivalent<dim>(law, s, history);
    if (dp > 0) {
      ++flowed;
      ASSERT_NEAR(q, formula(p, dp / law.step, room + heat * (work + q * dp)), 1e-9 * A) << n;
    } else {
      ASSERT_LE(q, formula(p, 0, room + heat * work) * (1 + 1e-12)) << n;
    }
  }
  EXPECT_GT(flowed, 1000);
}

TEST(JohnsonCook, EndsOnTheYieldSurface) {
  expect_on_the_surface<3>(Plane::none);
  expect_on_the_surface<2>(Plane::strain);
}

// Pure shear at dp/dt = 1e4 / s to p = 1 in `steps` steps; returns q and T at the end.
std::pair<double, double> sheared(bool with_rate, bool with_heat, int steps) {
  Plastic law = steel(Plane::none, with_rate, with_heat);
  law.set_step(1e-4 / steps);
  Symmetric<double, 3> s{};
  double history[Plastic::history_size<3>] = {};
  for (int n = 0; n < steps; ++n)
    law.update(Symmetric<double, 3>{0, 0, 0, 0.5 * std::sqrt(3.0) / steps, 0, 0}, s, history);
  return {equivalent<3>(law, s, history), room + heat * history[Plastic::work]};
}

// p is 1 less the elastic part q / 3G, and so is the rate of p (its own rate of change is 1 % of it here at
// most).
TEST(JohnsonCook, IsothermalAtAFixedRate) {
  const auto [q, T] = sheared(true, false, 2000);
  EXPECT_NEAR(q, (A + B * std::pow(1 - q / (3 * shear), exponent)) * (1 + C * std::log(1e4)), 2e-5 * q);
  const auto [slow, warm] = sheared(false, false, 2000);
  EXPECT_NEAR(slow, A + B * std::pow(1 - slow / (3 * shear), exponent), 1e-9 * slow);
}

// The adiabatic curve: Runge-Kutta of fourth order in p over 20000 steps, against backward Euler in 250, 500,
// .. which converges to it.
TEST(JohnsonCook, AdiabaticCurve) {
  double T = room;
  const int fine = 20000;
  const double end = 1 - 1.2e9 / (3 * shear), h = end / fine, start = 1e-12;
  const auto slope = [](double p, double t) { return heat * formula(p, 1e4, t); };
  for (int n = 0; n < fine; ++n) {
    const double p = std::max(start, n * h);
    const double a = slope(p, T), b = slope(p + h / 2, T + h / 2 * a), c = slope(p + h / 2, T + h / 2 * b),
                 d = slope(p + h, T + h * c);
    T += h / 6 * (a + 2 * b + 2 * c + d);
  }
  double before = 0;
  for (int steps : {250, 500, 1000, 2000}) {
    const auto [q, warm] = sheared(true, true, steps);
    const double error = std::abs(warm - T) / (T - room);
    EXPECT_LT(error, 0.5 / steps + 1e-4) << steps;
    if (steps <= 1000 && before > 0) {
      EXPECT_LT(error, 0.7 * before);
    }
    before = error;
    EXPECT_NEAR(q, formula(end, 1e4, T), (1.0 / steps + 2e-4) * q) << steps;
  }
  EXPECT_GT(T - room, 200);  // a large effect
}

TEST(JohnsonCook, EightLanesAreEightPoints) {
  Plastic law = steel(Plane::none, true, true);
  law.set_step(1e-7);
  std::mt19937 engine(4);
  std::normal_distribution<double> normal(0, 2e-3);
  constexpr int n = point_state_size<Plastic, 3>;
  Pack pack[n] = {};
  double scalar[lanes][n] = {};
  for (int turn = 0; turn < 100; ++turn) {
    Symmetric<Pack, 3> strain;
    for (int k = 0; k < 6; ++k)
      for (int l = 0; l < lanes; ++l) strain[k][l] = l == 0 ? 0.0 : normal(engine);
    const auto together = advance_law<Plastic, Pack, 3, LargeStrain>(law, strain, pack);
    for (int l = 0; l < lanes; ++l) {
      Symmetric<double, 3> own;
      for (int k = 0; k < 6; ++k) own[k] = strain[k][l];
      const auto one = advance_law<Plastic, double, 3, LargeStrain>(law, own, scalar[l]);
      for (int k = 0; k < 6; ++k) ASSERT_NEAR(together[k][l], one[k], 1e-9 * A) << turn << " lane " << l;
    }
  }
}

TEST(JohnsonCook, MoltenMetalBearsNoShear) {
  Plastic law = steel(Plane::none, false, true);
  law.parameters.johnson_cook->start = 2000;
  Symmetric<double, 3> s{};
  double history[Plastic::history_size<3>] = {};
  law.update(Symmetric<double, 3>{0.01, 0.01, 0.01, 0.01, 0, 0}, s, history);
  EXPECT_NEAR(equivalent<3>(law, s, history), 0, 1e-6 * A);
  EXPECT_GT(s[0], 1e9);
}

// --- In a scene.

std::string scene_text(const std::string& table, const std::string& plane, const std::string& more = "") {
  return "[model]\nplane = \"" + plane +
         "\"\nmotion = \"large\"\n[materials.m]\nlaw = \"plastic\"\nyoung = \"210 GPa\"\npoisson = "
         "0.3\ndensity = \"7850 kg/m^3\"\n"
         "yield = \"792 MPa\"\n" +
         more + "johnson_cook = {" + table + "}\n[bodies.b]\nshape = \"box\"\nsize = [" +
         (plane == "none" ? "\"1 m\", \"1 m\", \"1 m\"]" : "\"1 m\", \"1 m\"]\nthickness = \"1 m\"") +
         "\nmaterial = \"m\"\n[time]\nduration = \"1 s\"\n";
}

std::string fault_of(const std::string& table, const std::string& plane = "none",
                     const std::string& more = "") {
  try {
    parse_scene(scene_text(table, plane, more), "jc.toml");
  } catch (const InputError& e) {
    return e.faults().at(0).text;
  }
  return "";
}

TEST(JohnsonCook, IsReadAsWritten) {
  const std::string all =
      "B = \"510 MPa\", n = 0.26, C = 0.014, reference_rate = \"1 1/s\", m = 1.03, melting = \"1793 K\", "
      "room = \"298.15 K\", heat_capacity = \"477 J/(kg K)\"";
  const Scene scene = parse_scene(scene_text(all, "none"), "jc.toml");
  const JohnsonCook jc = *std::get<Plastic>(scene.materials.at("m").law(Plane::none)).parameters.johnson_cook;
  EXPECT_DOUBLE_EQ(jc.B, 510e6);
  EXPECT_DOUBLE_EQ(jc.room, 298.15);
  EXPECT_DOUBLE_EQ(jc.start, 298.15);
  EXPECT_DOUBLE_EQ(jc.heating, 0.9 / (7850 * 477.0));
  EXPECT_THAT(effects_on(scene), testing::Contains("Johnson-Cook yield stress"));
}

TEST(JohnsonCook, FaultsSayWhatWasExpected) {
  const std::string base = "B = \"510 MPa\", n = 0.26";
  EXPECT_EQ(fault_of(base), "");
  EXPECT_THAT(fault_of("n = 0.26"), HasSubstr("missing \"B\""));
  EXPECT_EQ(fault_of("B = \"510 MPa\", n = 0"),
            "\"n\" is 0; expected a number above 0 and at most 1 (the exponent of the plastic strain)");
  EXPECT_THAT(fault_of(base + ", C = 0.1"), HasSubstr("missing \"reference_rate\""));
  EXPECT_EQ(fault_of(base + ", m = 1"), "\"m\" without \"melting\"; expected both, or no effect of heat");
  EXPECT_THAT(fault_of(base + ", melting = \"1800 K\", m = 1, room = \"298 K\""),
              HasSubstr("missing \"heat_capacity\""));
  EXPECT_EQ(
      fault_of(base + ", melting = \"200 K\", m = 1, room = \"298 K\", heat_capacity = \"477 J/(kg K)\""),
      "\"melting\" is 200 K, not above \"room\", 298 K; expected the higher of the two");
  EXPECT_EQ(fault_of(base, "stress"),
            "\"johnson_cook\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
  EXPECT_EQ(fault_of(base, "none", "hardening = \"1 GPa\"\n"),
            "\"hardening\" with \"johnson_cook\", which says how the metal hardens; expected one of them");
  EXPECT_EQ(fault_of(base, "none", "integration = \"no-return-1\"\n"),
            "\"integration\" with \"johnson_cook\"; expected \"return\"");
}

TEST(NeoHookeanMaterial, NeedsLargeMotion) {
  const std::string scene =
      "[materials.m]\nlaw = \"neo-hookean\"\nyoung = \"17 MPa\"\npoisson = 0.45\ndensity = \"1100 "
      "kg/m^3\"\n[bodies.b]\nshape = \"box\"\n"
      "size = [\"1 m\", \"1 m\"]\nthickness = \"1 m\"\nmaterial = \"m\"\n[time]\nduration = \"1 "
      "s\"\n[model]\nplane = \"strain\"\n";
  const Scene good = parse_scene(scene + "motion = \"large\"\n", "n.toml");
  EXPECT_TRUE(std::holds_alternative<NeoHookean>(good.materials.at("m").law(Plane::strain)));
  EXPECT_THAT(effects_on(good), testing::Contains("neo-Hookean law"));
  try {
    parse_scene(scene, "n.toml");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().at(0).text,
              "\"law\" is \"neo-hookean\" with small motion, where it is the elastic law; expected motion = "
              "\"large\" in [model], or law = \"elastic\"");
  }
}

}  // namespace
}  // namespace femsph::test
