// Equations of state, and the fluid.
//   copper: rho0 = 8930 kg/m^3, us = 3940 m/s + 1.489 up, gamma0 = 2.02 (Marsh, LASL Shock Hugoniot Data,
//   1980; the numbers as in Meyers, Dynamic Behavior of Materials, 1994, table 4.1).
// Water: us = 1480 m/s + 1.92 up.

#include <random>

#include "model/material/kinematics.hpp"
#include "model_law_support.hpp"

namespace femsph::test {
namespace {

using Form = EquationOfState::Form;

EquationOfState linear_water(double least) { return {Form::linear, 2.2e9, 1, 0, 0, least}; }
EquationOfState tait_water(double least) { return {Form::murnaghan, 2.2e9, 7, 0, 0, least}; }
EquationOfState copper(double least = -1e300) {
  return {Form::mie_grueneisen, 8930 * 3940.0 * 3940, 1, 1.489, 2.02, least};
}
Fluid fluid(const EquationOfState& eos, double density, Plane plane = Plane::none, double viscosity = 0) {
  return Fluid::of({eos, viscosity}, {0, 0.5, density}, plane);
}
double pressure_at(const EquationOfState& eos, double J) {
  return eos.advance<double>(0, std::log(J), {0, 0}, 0).pressure;
}

// K = 2.2 GPa: linear 2.2 GPa (1/0.9 - 1) = 244.444 MPa, at J = 1.25 -440 MPa; murnaghan with n = 7 2.2 GPa/7
// (0.9^-7 - 1) = 342.808 MPa.
TEST(EquationOfState, PointsOfTheCurves) {
  EXPECT_NEAR(pressure_at(linear_water(-1e300), 0.9), 2.2e9 / 9, 1);
  EXPECT_NEAR(pressure_at(linear_water(-1e300), 1.25), -440e6, 1);
  EXPECT_NEAR(pressure_at(tait_water(-1e300), 0.9), 342807639.833, 1);
  EXPECT_EQ(pressure_at(linear_water(-1e6), 1.25), -1e6);
  EXPECT_EQ(pressure_at(tait_water(0), 1.01), 0);
}

// One step from rest is the jump over a shock: the trapezoid of -p dJ is then the energy p (1 - J)/2 of the
// Hugoniot. Copper at up = 1000 m/s: us = 5429 m/s, p = rho0 us up = 48.481 GPa, rho = rho0 us/(us - up) =
// 10946.3 kg/m^3. Water at 116 m/s: us = 1702.72 m/s, p = 197.516 MPa.
TEST(EquationOfState, OneStepIsTheShock) {
  const auto metal = copper().advance<double>(0, std::log(8930 / 10946.256491307293), {0, 0}, 0);
  EXPECT_NEAR(metal.pressure, 48480970000.0, 1e-9 * metal.pressure);
  EXPECT_NEAR(metal.energy, 0.5 * 8930 * 1000 * 1000, 1e-9 * metal.energy);  // 1/2 rho0 up^2
  const EquationOfState water{Form::mie_grueneisen, 1000 * 1480.0 * 1480, 1, 1.92, 0.1, 0};
  EXPECT_NEAR(pressure_at(water, 1 - 116 / 1702.72), 197515520, 1);
}

/// Copper along the isentrope from J = 1 to 0.8, in `steps` steps.
EquationOfState::Point<double> compressed(int steps) {
  EquationOfState::Point<double> point{0, 0};
  for (int k = 0; k < steps; ++k)
    point = copper().advance<double>(
        std::log(1 - 0.2 * k / steps), std::log(1 - 0.2 * (k + 1) / steps), point, 0);
  return point;
}

// de/dJ = -p(J, e) by Runge-Kutta of fourth order; the error of the law falls by 4 where the steps are
// halved.
TEST(EquationOfState, IsentropeIsOfSecondOrder) {
  const double K = 8930 * 3940.0 * 3940;
  const auto p = [&](double J, double e) {
    const double x = 1 - J;
    return K * x / ((1 - 1.489 * x) * (1 - 1.489 * x)) * (1 - 1.01 * x) + 2.02 * e;
  };
  double e = 0;
  const int fine = 1000;
  const double h = -0.2 / fine;
  for (int k = 0; k < fine; ++k) {
    const double J = 1 + k * h, a = -p(J, e), b = -p(J + h / 2, e + h / 2 * a),
                 c = -p(J + h / 2, e + h / 2 * b), d = -p(J + h, e + h * c);
    e += h / 6 * (a + 2 * b + 2 * c + d);
  }
  const double coarse = compressed(20).energy - e, half = compressed(40).energy - e;
  EXPECT_NEAR(coarse / half, 4, 0.1);
  EXPECT_LT(std::abs(half), 1e-3 * e);
  EXPECT_NEAR(compressed(2000).pressure, p(0.8, e), 1e-6 * p(0.8, e));
}

// The stored energy of a barotropic law is the integral of -p dJ (Simpson), beyond the cut-off too; near J =
// 1 it is K (ln J)^2/2 to full accuracy.
TEST(EquationOfState, StoredEnergyIsTheIntegralOfThePressure) {
  for (const double least : {-1e300, -50e6, 0.0})
    for (const EquationOfState& eos : {linear_water(least), tait_water(least)})
      for (const double end : {0.7, 0.95, 1.02, 1.3}) {
        double sum = 0;
        // the kink at the cut-off is an end of a panel
        const double kink = eos.form == Form::linear ? 1 / (1 + least / 2.2e9)
                                                     : std::pow(1 + 7 * least / 2.2e9, -1.0 / 7);
        const bool split = kink > 1 && kink < end;
        for (const auto& [from, to] : split ? std::vector<std::pair<double, double>>{{1, kink}, {kink, end}}
                                            : std::vector<std::pair<double, double>>{{1, end}}) {
          const int n = 200;
          const double h = (to - from) / n;
          for (int k = 0; k <= n; ++k)
            sum -= h / 3 * (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * pressure_at(eos, from + k * h);
        }
        EXPECT_NEAR(eos.stored<double>(std::log(end), 0), sum, 1e-6 * 2.2e9 * 0.01) << least << " " << end;
      }
  for (const double x : {1e-8, -1e-8})
    EXPECT_NEAR(tait_water(-1e300).stored<double>(x, 0), 1.1e9 * x * x, 1e-6 * 1.1e9 * x * x);
}

// -J^2 dp/dJ over K, by small steps from the state behind a shock (for copper: at constant entropy).
TEST(EquationOfState, StiffnessIsTheSlope) {
  for (const EquationOfState& eos : {linear_water(-1e300), tait_water(-1e300), copper()})
    for (const double J : {0.75, 0.9, 1.0}) {
      const auto point = eos.advance<double>(0, std::log(J), {0, 0}, 0);
      const auto next = [&](double step) {
        return eos.advance<double>(std::log(J), std::log(J + step), point, 0).pressure;
      };
      const double small = 1e-5,
                   slope = (next(-small) - next(small * (J == 1 ? 0 : 1))) / (J == 1 ? 1 : 2) / small;
      EXPECT_NEAR(eos.stiffness(J), J * J * slope / eos.bulk, J == 1 ? 1e-3 : 1e-6) << J;
    }
  // e holds the dissipated work too: at J = 1 the pressure is gamma0 times it.
  EXPECT_NEAR(copper().advance<double>(0, 0, {0, 0}, 5e6).pressure, 2.02 * 5e6, 1e-6);
  EXPECT_EQ(copper().stiffness(0.3), std::numeric_limits<double>::infinity());  // 1 - 1.489 0.7 < 0
}

template <int dim>
Symmetric<double, dim> random_increment(std::mt19937& engine, double size) {
  std::normal_distribution<double> normal(0, size);
  Symmetric<double, dim> e;
  for (int k = 0; k < symmetric_size<dim>; ++k) e[k] = normal(engine);
  return e;
}

PlasticWithEos plastic_copper(Plane plane, bool johnson_cook = false) {
  Plasticity p{100e6, 300e6};
  if (johnson_cook)
    p = {90e6, 0, TensionRule::none, 0, Integration::return_mapping, JohnsonCook{292e6, 0.31}};
  p.eos = copper();
  return PlasticWithEos::of(p, {124e9, 0.34, 8930}, plane);
}

/// A path of large strains, in eight lanes at once and one by one.
template <class LawType, int dim>
void expect_lanes_to_be_points(LawType law) {
  law.set_step(1e-7);
  std::mt19937 engine(4);
  constexpr int n = point_state_size<LawType, dim>;
  Pack pack[n] = {};
  double scalar[lanes][n] = {};
  for (int turn = 0; turn < 60; ++turn) {
    Symmetric<Pack, dim> strain;
    Symmetric<double, dim> own[lanes];
    for (int l = 0; l < lanes; ++l) {
      own[l] = random_increment<dim>(engine, l == 0 ? 0.0 : 5e-3);
      for (int k = 0; k < symmetric_size<dim>; ++k) strain[k][l] = own[l][k];
    }
    const auto together = advance_law<LawType, Pack, dim, LargeStrain>(law, strain, pack);
    for (int l = 0; l < lanes; ++l) {
      const auto one = advance_law<LawType, double, dim, LargeStrain>(law, own[l], scalar[l]);
      for (int k = 0; k < symmetric_size<dim>; ++k)
        ASSERT_NEAR(together[k][l], one[k], 1e-11 * law.elastic().lambda * 5e-3) << turn << " " << l;
    }
  }
}

TEST(Fluid, EightLanesAreEightPoints) {
  for (const EquationOfState& eos : {linear_water(0), tait_water(-1e6), copper()}) {
    expect_lanes_to_be_points<Fluid, 2>(fluid(eos, 1000, Plane::strain, 10));
    expect_lanes_to_be_points<Fluid, 3>(fluid(eos, 1000, Plane::none, 10));
  }
  expect_lanes_to_be_points<PlasticWithEos, 2>(plastic_copper(Plane::strain));
  expect_lanes_to_be_points<PlasticWithEos, 3>(plastic_copper(Plane::none, true));
}

/// Along a smooth path: the work of the stress, and what the law says has become of it.
template <class LawType, int dim>
std::pair<double, double> work_and_account(LawType law, int steps) {
  law.set_step(1e-3 / steps);
  double state[point_state_size<LawType, dim>] = {}, work = 0;
  Symmetric<double, dim> before{}, last{}, strain{}, stress{};
  for (int k = 1; k <= steps; ++k) {
    const double t = double(k) / steps;
    strain[0] = -0.10 * std::sin(2 * t);
    strain[1] = -0.08 * std::sin(3 * t);
    strain[dim] = 0.05 * std::sin(2.5 * t);
    stress = advance_law<LawType, double, dim, LargeStrain>(law, strain, state);
    const auto d = LargeStrain::increment<double, dim>(before, strain);
    work += 0.5 * (contract(stress, d) + contract(last, d));
    before = strain, last = stress;
  }
  const double* history = history_of<LawType, dim>(state);
  return {work, law.template stored_energy<double, dim>(strain, stress, history) + law.plastic_work(history)};
}

// The difference is that of a trapezoid: of second order in the step.
template <class LawType, int dim>
void expect_energy(const LawType& law) {
  const auto coarse = work_and_account<LawType, dim>(law, 50),
             fine = work_and_account<LawType, dim>(law, 200);
  EXPECT_LT(std::abs(coarse.first - coarse.second), 5e-3 * coarse.first);
  EXPECT_LT(std::abs(fine.first - fine.second),
            std::max(0.1 * std::abs(coarse.first - coarse.second), 1e-12 * fine.first));
}

TEST(Fluid, WorkIsStoredOrDissipated) {
  for (const EquationOfState& eos : {linear_water(-1e300), tait_water(-1e300), copper()}) {
    expect_energy<Fluid, 2>(fluid(eos, 1000, Plane::strain, 1e3));
    expect_energy<Fluid, 3>(fluid(eos, 1000, Plane::none, 1e3));
  }
  expect_energy<PlasticWithEos, 2>(plastic_copper(Plane::strain));
  expect_energy<PlasticWithEos, 3>(plastic_copper(Plane::none));
}

// Shear at a rate g: sigma_xy = eta g, no pressure; after the first step the work is eta g^2 per time.
TEST(Fluid, ViscousShear) {
  Fluid law = fluid(linear_water(0), 1000, Plane::strain, 2.0);
  law.set_step(1e-3);
  const double rate = 50;
  Symmetric<double, 2> s{};
  double history[Fluid::history_size<2>] = {};
  law.update(Symmetric<double, 2>{0, 0, 0.5 * rate * 1e-3}, s, history);
  EXPECT_DOUBLE_EQ(s[2], 2.0 * rate);
  const double first = history[Fluid::work];
  law.update(Symmetric<double, 2>{0, 0, 0.5 * rate * 1e-3}, s, history);
  EXPECT_NEAR(history[Fluid::work] - first, 2.0 * rate * rate * 1e-3, 1e-12);
  law.update(Symmetric<double, 2>{}, s, history);  // read again
  EXPECT_DOUBLE_EQ(s[2], 2.0 * rate);
  // eta = 2 Pa s, dt = 1 ms, K = 2.2 GPa
  EXPECT_DOUBLE_EQ(law.stiffening(1.0, 1.0), 1 + 8.0 / 3 * 2 / 1e-3 / 2.2e9);
}

// A step of the midpoint rule from stretch 1 to a: d = 2 (a - 1)/(a + 1). ln J is ln a to fifth order in d.
TEST(Fluid, VolumeOfALargeStep) {
  for (const double stretch : {0.9, 0.97, 1.1}) {
    Symmetric<double, 3> s{};
    double history[Fluid::history_size<3>] = {};
    const double d = 2 * (stretch - 1) / (stretch + 1);
    fluid(linear_water(0), 1000).update(Symmetric<double, 3>{d, 0, 0, 0, 0, 0}, s, history);
    EXPECT_NEAR(history[Fluid::log_volume], std::log(stretch), std::pow(std::abs(d), 5) / 60);
  }
}

// The Kirchhoff stress is J times the Cauchy stress, and so are the energies.
TEST(Fluid, CauchyOrKirchhoff) {
  Fluid law = fluid(copper(), 8930, Plane::none), same = law;
  same.return_cauchy();
  Symmetric<double, 3> tau{}, sigma{};
  double a[Fluid::history_size<3>] = {}, b[Fluid::history_size<3>] = {};
  for (int k = 0; k < 10; ++k) {
    const Symmetric<double, 3> d{-0.01, -0.004, 0.001, 0.02, 0, 0};
    law.update(d, tau, a);
    same.update(d, sigma, b);
  }
  EXPECT_NEAR(a[Fluid::log_volume], -0.13, 1e-4);
  const double J = std::exp(a[Fluid::log_volume]);
  EXPECT_NEAR(tau[0], J * sigma[0], 1e-9 * std::abs(tau[0]));
  EXPECT_NEAR(law.stored(a), J * same.stored(b), 1e-9 * law.stored(a));
}

// The deviator is that of the plastic law, the mean stress that of the equation of state, whose energy holds
// the plastic work.
template <int dim>
void expect_deviator_of_plastic_law(Plane plane) {
  const PlasticWithEos law = plastic_copper(plane);
  const Plastic plain{law.base, law.parameters};
  Symmetric<double, dim> s{}, t{};
  double a[PlasticWithEos::history_size<dim>] = {}, b[Plastic::history_size<dim>] = {};
  std::mt19937 engine(3);
  for (int k = 0; k < 200; ++k) {
    const Symmetric<double, dim> d = random_increment<dim>(engine, 1e-3);
    law.template update<double, dim>(d, s, a);
    plain.template update<double, dim>(d, t, b);
    plastic::PointStress<double, dim> x{s, 0}, y{t, 0};
    if constexpr (dim == 2) x.across = a[PlasticWithEos::normal], y.across = b[Plastic::across];
    for (int c = 0; c < symmetric_size<dim>; ++c)
      ASSERT_NEAR(s[c] - (c < dim) * x.mean(), t[c] - (c < dim) * y.mean(), 1.0) << k;  // of 1e8 Pa
    const double J = std::exp(a[PlasticWithEos::log_volume]), eta = 1 - J, K = law.parameters.eos->bulk,
                 e = a[PlasticWithEos::energy] + a[PlasticWithEos::work];
    const double p = eta < 0 ? K * (1 / J - 1) + 2.02 * e
                             : K * eta / std::pow(1 - 1.489 * eta, 2) * (1 - 1.01 * eta) + 2.02 * e;
    ASSERT_NEAR(-x.mean(), J * p, 1e-9 * K * 1e-2) << k;
    ASSERT_NEAR(a[PlasticWithEos::work], b[Plastic::work], 1e-9 * b[Plastic::work] + 1e-3);
  }
  EXPECT_GT(a[PlasticWithEos::work], 1e6);
}

TEST(PlasticWithEos, DeviatorOfThePlasticLaw) {
  expect_deviator_of_plastic_law<2>(Plane::strain);
  expect_deviator_of_plastic_law<3>(Plane::none);
}

TEST(Fluid, ModuliAndSpeedOfSound) {
  const Fluid water = fluid({Form::mie_grueneisen, 1000 * 1480.0 * 1480, 1, 1.92, 0.1, 0}, 1000);
  EXPECT_EQ(water.elastic().mu, 0);
  EXPECT_DOUBLE_EQ(water.wave_speed(), 1480);
  const PlasticWithEos metal = plastic_copper(Plane::none);
  const double G = 124e9 / 2.68, K = 8930 * 3940.0 * 3940;
  EXPECT_NEAR(metal.elastic().lambda + 2.0 / 3 * metal.elastic().mu, K, 1);
  EXPECT_NEAR(metal.wave_speed(), std::sqrt((K + 4.0 / 3 * G) / 8930), 1e-6);
}

}  // namespace
}  // namespace femsph::test
