// Each watch of the march, on a mass and a spring with one fault; and archives, which save and restore a
// state.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/motion/march.hpp"
#include "model/numerics/array.hpp"
#include "model_masses.hpp"

namespace femsph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double watched_mass = 2.0, spring_rate = 800.0;  // the critical step is 2 sqrt(m / k) = 0.1 s

/// m u'' = -k u on one point, with something added.
class Mass : public test::OneMass {
 public:
  Mass() : OneMass(watched_mass) {}
  void stiffness(const double* x, double* y) const override { y[0] = spring_rate * x[0], y[1] = 0; }
  void internal_force(const double* u, const double* v, double dt, double* f, double*) override {
    if (!std::isfinite(u[0])) ++calls_after_nan;
    remembered += dt;
    f[0] = -spring_rate * u[0] + added(u[0], v[0]);
    f[1] = 0;
  }
  Energies energies(const double* u) const override {
    return {0.5 * spring_rate * u[0] * u[0] + added_energy(u[0])};
  }
  void state(Archive& archive) override { archive("remembered", remembered); }
  virtual double added(double, double) const { return 0; }
  virtual double added_energy(double) const { return 0; }
  double remembered = 0;
  int calls_after_nan = 0;
};

/// Half as stiff again beyond u = 0.01 m: the critical step there is 0.0816 s.
class Stiffens : public Mass {
  double beyond(double u) const { return std::max(0.0, std::abs(u) - 0.01); }
  double added(double u, double) const override { return -0.5 * spring_rate * std::copysign(beyond(u), u); }
  double added_energy(double u) const override { return 0.25 * spring_rate * beyond(u) * beyond(u); }
};

/// A force along the velocity, which is in no energy: amplitude grows as exp(c t / 2 m).
class Pushes : public Mass {
  double added(double, double v) const override { return 0.05 * watched_mass * v; }
};

class TurnsInsideOut : public Mass {
 public:
  std::optional<Trouble> trouble(const double* u) const override {
    if (std::abs(remembered) < 3000 || std::abs(u[0]) > 1) return std::nullopt;
    return Trouble{"cell 7 has turned inside out", "try a finer mesh", {0.5 + u[0], 0.25, 0}};
  }
};

Scene watched(double duration) { return test::flying_masses(duration, {1, 0, 0}); }

struct Watched : test::Stop {
  Watched(Scene s, std::unique_ptr<Discretization> body, MarchOptions options = {})
      : scene(std::move(s)), march(scene, test::bodies_of(std::move(body)), options) {
    march.keep_good_states();
    MarchEvents events;
    events.between = [&](March& m) { u.push_back(m.bodies()[0].u[0]); };
    static_cast<test::Stop&>(*this) = test::run_until_stopped(march, events);
  }
  Scene scene;
  March march;
  std::vector<double> u;  ///< after each step
};

TEST(Watch, LeavesASoundMarchAlone) {
  const Watched r(watched(2000), std::make_unique<Mass>());
  EXPECT_FALSE(r.watch) << r.message;
  EXPECT_GT(r.march.step(), 20000);
}

TEST(Watch, StepAboveTheCriticalOneIsToldByTheFrequencyOfWhatGrows) {
  const Watched r(watched(100), std::make_unique<Stiffens>());
  ASSERT_EQ(r.watch, Stopped::Watch::step) << r.message;
  EXPECT_LE(r.march.step(), 50);
  // omega = sqrt(1.5 k / m) = 24.5 / s; --safety 0.8 x 0.0816 / 0.1 = 0.65
  EXPECT_THAT(r.message, AllOf(HasSubstr("stopped at step"), HasSubstr("24.49 rad/s"),
                               HasSubstr("point 0 at (0.5, 0.25, 0) m"), HasSubstr("try --safety 0.65")));
  MarchOptions smaller;
  smaller.safety = 0.2;
  EXPECT_FALSE(Watched(watched(100), std::make_unique<Stiffens>(), smaller).watch);
}

TEST(Watch, EnergyFromNowhere) {
  const Watched r(watched(100), std::make_unique<Pushes>());
  ASSERT_EQ(r.watch, Stopped::Watch::energy) << r.message;
  EXPECT_THAT(r.message, AllOf(HasSubstr("have come from nowhere"), HasSubstr("--safety")));
  EXPECT_LT(r.march.time(), 20);  // exp(0.05 t) - 1 has passed 5 % at 1 s
}

TEST(Watch, NotANumber) {
  Scene s = watched(1000);
  Load load;
  load.force = {std::nan(""), 0, 0};
  load.history.time = {0, 500};
  load.history.factor = {1, 1};
  s.loads.push_back(load);
  const Watched r(s, std::make_unique<Mass>());
  ASSERT_EQ(r.watch, Stopped::Watch::not_a_number) << r.message;
  EXPECT_THAT(r.message, AllOf(HasSubstr("not a finite number"), HasSubstr("point 0 at")));
}

TEST(Watch, UnitsAreAskedInLargeMotionAndTheLastGoodStateComesBack) {
  Watched r(watched(6000), std::make_unique<TurnsInsideOut>());
  ASSERT_EQ(r.watch, Stopped::Watch::unit) << r.message;
  EXPECT_THAT(r.message, AllOf(HasSubstr("cell 7 has turned inside out"), HasSubstr("try a finer mesh"),
                               HasSubstr("body \"body\", at (0.")));
  const long failed = r.march.step();
  ASSERT_TRUE(r.march.return_to_good_state());
  const long good = r.march.step();
  EXPECT_LT(good, failed);
  EXPECT_GT(good, 0);
  EXPECT_EQ(r.march.bodies()[0].u[0], r.u[std::size_t(good - 1)]);
  EXPECT_NEAR(
      dynamic_cast<const Mass&>(*r.march.bodies()[0].discretization).remembered, r.march.time(), 1e-6);
  Scene small = watched(6000);
  small.large_motion = false;
  const Watched unasked(small, std::make_unique<TurnsInsideOut>());
  EXPECT_FALSE(unasked.watch);
}

TEST(Watch, MoreStepsThanAnyMachineMarchesAreRefused) {
  EXPECT_THAT([] { Watched r(watched(1e12), std::make_unique<Mass>()); },
              testing::ThrowsMessage<MotionError>(HasSubstr("which no machine marches")));
}

struct Everything {
  struct Part {
    int number = 0;
    bool yes = false;
    Point point{};
  };
  double real = 0;
  long whole = 0;
  bool flag = false;
  Point point{};
  std::vector<double> reals;
  AlignedVector<double> aligned;
  std::vector<Point> points;
  std::vector<std::size_t> numbers;
  std::vector<Part> parts;
  void state(Archive& a) {
    a("real", real), a("whole", whole), a("flag", flag), a("point", point), a("reals", reals);
    a.below("deep", [&] { a("aligned", aligned), a("points", points), a("numbers", numbers); });
    a.each("n", parts, &Part::number), a.each("y", parts, &Part::yes), a.each("p", parts, &Part::point);
  }
};

TEST(Archive, PutsBackEveryKindOfValueAndVectorsWithTheirLengths) {
  Everything before{
      -0.0,
      -7,
      true,
      {1, 2, 3},
      {4, std::nan(""), 5},
      {6},
      {{7, 8, 9}, {10, 11, 12}},
      {13, std::size_t(1) << 40},
      {{1, true, {1, 2, 3}}, {-2, false, {4, 5, 6}}}};
  MemoryArchive archive;
  EXPECT_TRUE(archive.empty());
  archive.save(before);
  Everything after;
  after.reals.assign(100, 1.0);
  after.parts.resize(2);
  archive.restore(after);
  EXPECT_TRUE(std::signbit(after.real));
  EXPECT_EQ(after.whole, -7);
  EXPECT_TRUE(after.flag);
  EXPECT_EQ(after.point, before.point);
  ASSERT_EQ(after.reals.size(), 3u);
  EXPECT_TRUE(std::isnan(after.reals[1]));
  EXPECT_EQ(after.aligned, before.aligned);
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.numbers, before.numbers);
  EXPECT_EQ(after.parts[1].number, -2);
  EXPECT_TRUE(after.parts[0].yes);
  EXPECT_FALSE(after.parts[1].yes);
  EXPECT_EQ(after.parts[1].point, before.parts[1].point);
  Everything other;
  other.parts.resize(3);
  EXPECT_THROW(archive.restore(other), std::runtime_error);
}

}  // namespace
}  // namespace femsph
