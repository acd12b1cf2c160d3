// A step that follows the deformation, on one mass and one spring: changes of the step disturb neither the
// energy balance nor the motion, and the limits hold.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/motion/march.hpp"
#include "model_masses.hpp"

namespace femsph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double stepped_mass = 2.0, slow = 20.0,
                 fast = 400.0;  // 1/s; the critical step is 2 / fast = 0.005 s

/// One point with a slow spring along x and a fast one along y, which stiffens with the square of x if it is
/// coupled:
///   U = k/2 x^2 + K/2 y^2 (1 + 3 (x / reach)^2).    stiffening() says so, coupled or not; it says nothing if
///   reach = 0.
class Springs : public test::OneMass {
 public:
  Springs(double reach, bool coupled, double viscosity = 0)
      : OneMass(stepped_mass), reach_(reach), viscosity_(viscosity), coupled_(coupled) {}
  void stiffness(const double* x, double* y) const override { y[0] = k * x[0], y[1] = K * x[1]; }
  bool has_viscosity() const override { return viscosity_ > 0; }
  void damping_matrix(const double* x, double* y) const override {
    y[0] = viscosity_ * x[0], y[1] = viscosity_ * x[1];
  }
  void internal_force(const double* u, const double* v, double dt, double* f, double* viscous) override {
    passed += dt;
    f[0] = -k * u[0] - (coupled_ ? 3 * K * u[1] * u[1] * u[0] / (reach_ * reach_) : 0.0);
    f[1] = -K * u[1] * ratio(u);
    if (viscous) viscous[0] = -viscosity_ * v[0], viscous[1] = -viscosity_ * v[1];
  }
  Energies energies(const double* u) const override {
    return {0.5 * (k * u[0] * u[0] + K * u[1] * u[1] * ratio(u))};
  }
  void state(Archive& archive) override { archive("passed", passed); }
  std::optional<Stiffening> stiffening(const double* u) const override {
    ++asked;
    if (reach_ == 0) return std::nullopt;
    return Stiffening{1 + 3 * u[0] * u[0] / (reach_ * reach_), "spring 3", {0.5 + u[0], 0.25, 0}};
  }
  double passed = 0;
  mutable long asked = 0;

 private:
  static constexpr double k = stepped_mass * slow * slow, K = stepped_mass * fast * fast;
  double ratio(const double* u) const { return coupled_ ? 1 + 3 * u[0] * u[0] / (reach_ * reach_) : 1.0; }
  double reach_, viscosity_;
  bool coupled_;
};

/// Starts at 1 m/s along x, and a little along y: x swings to 1 / slow.
Scene swinging(double duration) { return test::flying_masses(duration, {1, 0.01, 0}); }

struct Stepped : test::Stop {
  Stepped(Scene s, std::unique_ptr<Springs> body, MarchOptions options = {})
      : scene(std::move(s)), spring(body.get()), march(scene, test::bodies_of(std::move(body)), options) {}
  void run() {
    MarchEvents events;
    events.sample = [&](const March& m) {
      const Ledger l = m.ledger();
      time.push_back(m.time());
      u.push_back(m.bodies()[0].u[0]);
      imbalance = std::max(imbalance, std::abs(l.imbalance()));
    };
    static_cast<test::Stop&>(*this) = test::run_until_stopped(march, events);
  }
  Scene scene;
  const Springs* spring;
  March march;
  std::vector<double> time, u;
  double imbalance = 0;
};

constexpr double amplitude = 1 / slow;

// The leap-frog's ledger of linear springs closes to round-off whatever the step; so it must when the step
// changes on the way, damped or not.
TEST(Step, LedgerClosesToRoundOffThroughEveryChange) {
  for (const double rate : {0.0, 0.3})
    for (const double viscosity : {0.0, 0.8}) {
      Scene s = swinging(10);
      if (rate > 0) s.damping = rate;
      s.samples = 500;
      Load load;
      load.force = {30, 0, 0};
      load.history.time = {0, 7};
      load.history.factor = {0, 1};
      s.loads.push_back(load);
      Stepped r(s, std::make_unique<Springs>(amplitude, false, viscosity));
      r.run();
      EXPECT_FALSE(r.watch) << r.message;
      EXPECT_GT(r.march.step_changes(), 10) << rate << " " << viscosity;
      EXPECT_LT(r.imbalance, 1e-11) << rate << " "
                                    << viscosity;  // J, of more than 1 J that come and go a hundred times
      EXPECT_NEAR(r.march.time(), 10, r.march.dt());
      EXPECT_NEAR(r.spring->passed, r.march.time(), 1e-9);  // laws get the length of every step
    }
}

// x = sin(slow t) / slow. Steps that fall to half keep the order of the leap-frog: a tenth of the step, a
// hundredth of the error.
TEST(Step, MotionIsOfSecondOrder) {
  double error[2];
  for (int k = 0; k < 2; ++k) {
    MarchOptions options;
    options.safety = k == 0 ? 0.9 : 0.09;
    Scene s = swinging(3);
    s.samples = 50;
    Stepped r(s, std::make_unique<Springs>(amplitude, false), options);
    r.run();
    EXPECT_GT(r.march.step_changes(), 10);
    error[k] = 0;
    for (std::size_t i = 0; i < r.u.size(); ++i)
      error[k] = std::max(error[k], slow * std::abs(r.u[i] - amplitude * std::sin(slow * r.time[i])));
  }
  EXPECT_LT(error[0], 0.03);
  EXPECT_GT(error[0] / error[1], 70);
}

// At x = amplitude the fast spring is 4 times as stiff: no step above 0.0025 s there. The march follows; a
// fixed one is stopped on the way there.
TEST(Step, HoldsTheLimitWhereAFixedStepIsStopped) {
  Stepped follows(swinging(20), std::make_unique<Springs>(amplitude, true));
  follows.run();
  EXPECT_FALSE(follows.watch) << follows.message;
  EXPECT_LT(follows.march.smallest_step(), 0.9 * 0.0025 * 1.05);
  EXPECT_GE(follows.march.smallest_step(), 0.9 * 0.0025 * 0.98 * 0.95);
  EXPECT_LT(follows.imbalance, 0.05);

  MarchOptions fixed;
  fixed.step = 0.0045;
  Stepped stopped(swinging(20), std::make_unique<Springs>(amplitude, true), fixed);
  stopped.run();
  ASSERT_EQ(stopped.watch, Stopped::Watch::step) << stopped.message;
  EXPECT_THAT(stopped.message,
              AllOf(HasSubstr("body \"body\", spring 3 at (0.5"),
                    HasSubstr("the step of 0.0045 s is over the limit"), HasSubstr("march without --step")));
  EXPECT_LT(stopped.march.time(), 0.25 * 2 * 3.1416 / slow);  // before x is largest for the first time
  fixed.step = 0.0022;
  Stepped small(swinging(20), std::make_unique<Springs>(amplitude, true), fixed);
  small.run();
  EXPECT_FALSE(small.watch) << small.message;
  EXPECT_EQ(small.march.step_changes(), 0);
}

TEST(Step, AVanishingOneIsStopped) {
  Stepped r(swinging(10), std::make_unique<Springs>(amplitude / 200, false));
  r.run();
  ASSERT_EQ(r.watch, Stopped::Watch::step) << r.message;
  EXPECT_THAT(r.message, AllOf(HasSubstr("crushed so far that the largest stable step has fallen to"),
                               HasSubstr("gentler load")));
}

TEST(Step, IsNotAskedForWhereNothingStiffens) {
  Stepped stays(swinging(50), std::make_unique<Springs>(0, false));
  stays.run();
  EXPECT_EQ(stays.spring->asked, 1);  // once, before the first step
  EXPECT_FALSE(stays.march.follows_deformation());
  EXPECT_EQ(stays.march.smallest_step(), stays.march.dt());
  Scene small = swinging(50);
  small.large_motion = false;
  Stepped unasked(small, std::make_unique<Springs>(amplitude, false));
  unasked.run();
  EXPECT_EQ(unasked.spring->asked, 0);
}

// Samples come at the pace that was asked for, however the step shrinks.
TEST(Step, SamplesKeepTheirPace) {
  Scene s = swinging(10);
  s.samples = 20;
  Stepped r(s, std::make_unique<Springs>(amplitude / 3, false));
  r.run();
  EXPECT_LT(r.march.smallest_step(), 0.001);
  EXPECT_GE(r.time.size(), 20u);
  EXPECT_LE(r.time.size(), 22u);
  for (std::size_t i = 1; i + 1 < r.time.size(); ++i) EXPECT_NEAR(r.time[i] - r.time[i - 1], 0.5, 0.01);
}

// A march restored between two changes of the step goes on to the same bits.
TEST(Step, IsPartOfTheState) {
  const auto scene = [] {
    Scene s = swinging(3);
    s.samples = 100;
    return s;
  };
  Stepped whole(scene(), std::make_unique<Springs>(amplitude, true));
  whole.run();
  ASSERT_GT(whole.march.step_changes(), 10);
  Stepped first(scene(), std::make_unique<Springs>(amplitude, true)),
      second(scene(), std::make_unique<Springs>(amplitude, true));
  MemoryArchive archive;
  struct Enough {};
  MarchEvents events;
  events.sample = [](const March&) {};
  events.between = [&](March& m) {
    if (m.step() < 8) return;
    archive.save(m);
    throw Enough{};
  };
  EXPECT_THROW(first.march.run(events), Enough);
  ASSERT_GT(first.march.step_changes(), 0);
  archive.restore(second.march);
  second.run();
  EXPECT_EQ(second.march.step(), whole.march.step());
  EXPECT_EQ(second.march.time(), whole.march.time());
  EXPECT_EQ(second.march.bodies()[0].u[0], whole.march.bodies()[0].u[0]);
  EXPECT_EQ(second.march.step_changes(), whole.march.step_changes());
  ASSERT_FALSE(second.u.empty());
  EXPECT_EQ(second.u.back(), whole.u.back());
}

}  // namespace
}  // namespace femsph
