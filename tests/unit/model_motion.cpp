// The march on one mass and one spring (m u'' = F - k u, omega = sqrt(k/m)), whose solution is known.
//   critical step              2 / omega
//   discrete frequency         sin(omega_d dt / 2) = omega dt / 2, exact for the leap-frog
//   energy                     1/2 v- m v+ + 1/2 k u^2 is constant to round-off

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "model/motion/march.hpp"
#include "model/results/recorder.hpp"
#include "model_masses.hpp"

namespace femsph {
namespace {

constexpr double mass_of_it = 2.0, spring = 800.0, omega = 20.0;

/// Held by the spring in x, free in y; beyond `explode_at` its force is no number.
class Spring : public test::OneMass {
 public:
  explicit Spring(double k = spring, double explode_at = 1e300)
      : OneMass(mass_of_it), k_(k), explode_at_(explode_at) {}
  void internal_force(const double* u, const double*, double, double* f, double*) override {
    f[0] = -k_ * u[0];
    f[1] = std::abs(u[0]) > explode_at_ ? std::nan("") : 0.0;
  }
  void stiffness(const double* x, double* y) const override { y[0] = k_ * x[0], y[1] = 0; }
  Energies energies(const double* u) const override { return {0.5 * k_ * u[0] * u[0]}; }
  std::vector<Weight> points_of(const Place& place) const override {
    if (!place.sides.empty() && place.sides[0] == "nowhere") return {};
    return OneMass::points_of(place);
  }

 private:
  double k_, explode_at_;
};

Scene scene_for(double duration) {
  Scene s = test::scene_of_masses(duration);
  s.probes.push_back({"mass", 0, quantity_named("displacement"), {}});
  s.samples = 1000000;
  return s;
}

Load push(Point force, TimeHistory history = {}) {
  Load l;
  l.force = force;
  l.history = history;
  return l;
}

struct Marched {
  explicit Marched(const Scene& scene, MarchOptions options = {},
                   std::unique_ptr<Discretization> body = std::make_unique<Spring>())
      : march(scene, test::bodies_of(std::move(body)), options), recorder(march) {
    MarchEvents events;
    events.sample = [&](const March& m) {
      recorder.sample(m);
      worst = std::max(worst, std::abs(m.ledger().imbalance()));
    };
    march.run(events);
  }
  const std::vector<double>& x() const { return recorder.history()["mass_x"].values; }
  const std::vector<double>& y() const { return recorder.history()["mass_y"].values; }
  March march;
  Recorder recorder;
  double worst = 0;
};

TEST(March, StepIsTheSafetyTimesTheCriticalStep) {
  const Scene s = scene_for(0.01);
  MarchOptions o;
  o.safety = 0.5;
  Marched r(s, o);
  EXPECT_NEAR(r.march.critical_step(), 2 / omega, 1e-12);
  EXPECT_DOUBLE_EQ(r.march.dt(), 0.5 * r.march.critical_step());
}

TEST(March, StepOverTheLimitIsRefusedWithTheLimit) {
  const Scene s = scene_for(0.01);
  MarchOptions o;
  o.step = 1.1 * 2 / omega;
  EXPECT_THAT([&] { Marched r(s, o); }, testing::ThrowsMessage<MotionError>(testing::HasSubstr(
                                            "over the limit: the largest stable step is 0.1 s")));
}

// A step load F: u(n) = F/k (1 - cos(omega_d t)) exactly, with omega_d of the leap-frog (start at rest is a
// symmetric start).
TEST(March, StepLoadMovesWithTheDiscreteFrequency) {
  Scene s = scene_for(2.0);
  s.loads.push_back(push({40, 0, 0}));
  Marched r(s);
  const double dt = r.march.dt(), discrete = 2 / dt * std::asin(omega * dt / 2);
  for (std::size_t n = 0; n < r.x().size(); ++n)
    ASSERT_NEAR(r.x()[n], 0.05 * (1 - std::cos(discrete * double(n) * dt)), 1e-12) << n;
  EXPECT_LT(r.worst, 1e-14 * 40 * 0.1);
}

// Free flight: u = v t + a t^2/2, which the leap-frog meets exactly; the ledger counts gravity's work.
TEST(March, GravityAndInitialVelocity) {
  Scene s = scene_for(1.0);
  s.gravity = Point{0, -10, 0};
  s.initial_velocities.push_back({0, {0, 3, 0}});
  Marched r(s);
  const double t = r.march.time();
  EXPECT_NEAR(r.y().back(), 3 * t - 5 * t * t, 1e-12);
  EXPECT_LT(r.worst, 1e-12);
  EXPECT_NEAR(r.march.ledger().external, mass_of_it * 10 * (5 * t * t - 3 * t), 1e-11);
}

TEST(March, RampBalancesItsEnergyToo) {
  Scene s = scene_for(2.0);
  TimeHistory ramp;
  ramp.time = {0, 0.7};
  ramp.factor = {0, 1};
  s.loads.push_back(push({40, 0, 0}, ramp));
  EXPECT_LT(Marched(s).worst, 1e-13);
}

// Amplitude of damped free vibration after time t: exp(-c t / 2); the energy balance closes.
TEST(March, DampingIsInTheEnergyBalance) {
  Scene s = scene_for(1.0);
  s.damping = 4.0;
  s.initial_velocities.push_back({0, {1, 0, 0}});
  MarchOptions o;
  o.safety = 0.02;
  Marched r(s, o);
  double last_peak = 0;
  for (std::size_t n = 1; n + 1 < r.x().size(); ++n)
    if (r.x()[n] > r.x()[n - 1] && r.x()[n] >= r.x()[n + 1]) {
      last_peak = double(n) * r.march.dt();
      EXPECT_NEAR(r.x()[n], std::exp(-2 * last_peak) / omega, 2e-3 / omega);
    }
  EXPECT_GT(last_peak, 0.7);
  EXPECT_LT(r.worst, 1e-14);
  EXPECT_NEAR(r.march.ledger().damping, 0.5 * mass_of_it * (1 - std::exp(-4.0)), 2e-2 * mass_of_it);
}

TEST(March, SettlesToTheStaticStateByEitherMethod) {
  for (SettlingMethod method : {SettlingMethod::damping, SettlingMethod::kinetic}) {
    Scene s = scene_for(100.0);
    s.loads.push_back(push({40, 0, 0}));
    Support hold;
    hold.fixed = {false, true, true};
    s.supports.push_back(hold);
    s.settling = Settling{method, 1e-6, {}};
    MarchOptions o;
    o.safety = 0.1;
    Marched r(s, o);
    EXPECT_TRUE(r.march.settled());
    EXPECT_NEAR(r.x().back(), 0.05, 0.05 * 2e-6);
    EXPECT_LT(std::abs(r.march.ledger().imbalance()), 1e-13);
    EXPECT_NEAR(r.march.ledger().damping + r.march.ledger().discrete, 40 * 0.05 / 2, 1e-5);
    EXPECT_NEAR(r.march.ledger().discrete, 0.125 * std::pow(r.march.dt() * 40, 2) / mass_of_it,
                1e-8);  // at the start, -dt^2/8 f^2/m
  }
}

TEST(March, SupportsHoldAndUnsupportedScenesAreNamed) {
  Scene s = scene_for(1.0);
  Support hold;
  hold.fixed = {true, true, true};
  s.supports.push_back(hold);
  EXPECT_THAT([&] { Marched r(s); },
              testing::ThrowsMessage<MotionError>(testing::HasSubstr("nothing in this scene can move")));
  s.supports[0].place.sides = {"nowhere"};
  s.supports[0].place.source = {7, 3};
  s.file = "scene.toml";
  EXPECT_THAT([&] { Marched r(s); }, testing::ThrowsMessage<MotionError>(testing::HasSubstr(
                                         "scene.toml:7:3: this support finds no point of body \"body\"")));
}

TEST(March, StopsAtNotANumberWithStepPlaceAndAdvice) {
  Scene s = scene_for(10.0);
  s.loads.push_back(push({40, 0, 0}));
  EXPECT_THAT([&] { Marched r(s, {}, std::make_unique<Spring>(spring, 0.09)); },
              testing::ThrowsMessage<MotionError>(testing::AllOf(
                  testing::HasSubstr("stopped at step"), testing::HasSubstr("point 0 at (0.5, 0.25, 0) m"),
                  testing::HasSubstr("not a finite number"), testing::HasSubstr("--safety"))));
}

}  // namespace
}  // namespace femsph
