// How bodies start and how supports move: the fields of [[initial]] and [[initial_displacements]], and the
// work of a moved support.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/motion/march.hpp"
#include "model/scene/reader/reader.hpp"
#include "model_faults.hpp"
#include "model_masses.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

using testing::HasSubstr;

/// A column 1 m x 6 m (x 1 m), and tables after it.
std::string text_of(const std::string& addition, bool space) {
  using namespace scene_text;
  return model(space ? "none" : "strain") + material("m", "elastic", "17 MPa", "0.45", "1100 kg/m^3") +
         box("b", space ? "1 6 1 m" : "1 6 m", space ? "" : thick("1 m"), "m") + scene_text::time("1 s") +
         addition;
}

Scene scene_with(const std::string& addition, bool space = false) {
  return parse_scene(text_of(addition, space), "start.toml");
}

std::string faults_of(const std::string& addition, bool space = false) {
  return test::faults_of(text_of(addition, space), "\n");
}

void expect_point(const Point& got, const Point& want) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 1e-14) << "xyz"[c];
}

// A plate that spins about its middle, a column whose top runs ahead, a column that twists.
TEST(Start, FieldsOfVelocity) {
  const Scene plate = scene_with(
      "[[initial]]\nspin = \"50 rad/s\"\ncentre = [\"0.5 m\", \"0.5 m\"]\nvelocity = [\"1 m/s\", \"0 "
      "m/s\"]\n");
  expect_point(plate.initial_velocities.at(0).at({0.5, 0.7, 0}), {1 - 50 * 0.2, 0, 0});
  expect_point(plate.initial_velocities[0].at({0.6, 0.5, 0}), {1, 5, 0});
  const Scene column = scene_with(
      "[[initial]]\ngradient = [[\"0 1/s\", \"2 1/s\"], [\"0 1/s\", \"0 1/s\"]]\n");
  expect_point(column.initial_velocities.at(0).at({0.3, 6, 0}), {12, 0, 0});
  const Scene twist = scene_with(
      "[[initial]]\nspin = [\"0 rad/s\", \"105 rad/s\", \"0 rad/s\"]\ncentre = [\"0.5 m\", \"0 m\", \"0.5 "
      "m\"]\nprofile = {axis = \"y\", wavelength = \"24 m\"}\n",
      true);
  const double half = std::sin(std::acos(-1.0) * 3 / 12);  // omega x r = 105 (z, 0, -x)
  expect_point(
      twist.initial_velocities.at(0).at({1.0, 3.0, 0.75}), {105 * 0.25 * half, 0, -105 * 0.5 * half});
  expect_point(twist.initial_velocities[0].at({1.0, 0.0, 0.75}), {0, 0, 0});
}

TEST(Start, FaultsOfInitialVelocities) {
  EXPECT_EQ(faults_of("[[initial]]\nbody = \"b\"\n"),
            "no motion in [[initial]]; expected \"velocity\", \"spin\" or \"gradient\"");
  EXPECT_EQ(faults_of("[[initial]]\nspin = [\"1 rad/s\"]\n"),
            "\"spin\" is a list; expected a rate of rotation with its unit, such as \"50 rad/s\"");
  EXPECT_THAT(faults_of("[[initial]]\nspin = \"1 m/s\"\n"), HasSubstr("a rate of rotation"));
  EXPECT_EQ(faults_of("[[initial]]\nspin = [\"1 rad/s\", \"0 rad/s\"]\n", true),
            "\"spin\" has 2 components; expected 3 (x, y, z) in a three-dimensional scene");
  EXPECT_EQ(faults_of("[[initial]]\nvelocity = [\"1 m/s\", \"0 m/s\"]\ncentre = [\"0 m\", \"0 m\"]\n"),
            "\"centre\" without \"spin\" or \"gradient\"; expected one of them with it");
  EXPECT_EQ(faults_of("[[initial]]\ngradient = [[\"1 1/s\"], [\"1 1/s\"]]\n"),
            "\"gradient\" is no square matrix; expected two rows such as [[\"100 1/s\", \"100 1/s\"], [\"100 "
            "1/s\", \"100 1/s\"]]");
  EXPECT_EQ(faults_of("[[initial]]\nspin = \"1 rad/s\"\nprofile = {axis = \"z\", wavelength = \"1 m\"}\n"),
            "\"axis\" is \"z\"; expected \"x\" or \"y\"");
  EXPECT_EQ(faults_of("[[initial]]\nspin = \"1 rad/s\"\nprofile = {axis = \"y\", wavelength = \"0 m\"}\n"),
            "\"wavelength\" is 0 m; expected a length greater than zero");
}

TEST(Start, FaultsOfInitialDisplacements) {
  EXPECT_EQ(faults_of("[[initial_displacements]]\ngradient = [[0.1, 0], [0, 0]]\n"), "");
  EXPECT_EQ(faults_of("[[initial_displacements]]\ngradient = [[0.1, 0]]\n"),
            "\"gradient\" is no square matrix; expected two rows such as [[0.1, 0.1], [0.1, 0.1]]");
  EXPECT_EQ(faults_of("[[initial_displacements]]\ngradient = [[0.1, \"0\"], [0, 0]]\n"),
            "not a number in \"gradient\"; expected two rows such as [[0.1, 0.1], [0.1, 0.1]]");
  EXPECT_EQ(faults_of("[[initial_displacements]]\ngradient = [[-1, 0], [0, 0]]\n"),
            "\"gradient\" turns the body inside out; expected det(1 + gradient) > 0");
  EXPECT_EQ(
      faults_of("[[symmetry]]\nat = \"x-\"\n[[initial_displacements]]\ngradient = [[0.1, 0], [0, 0]]\n"), "")
      << "0 on the plane";
  EXPECT_EQ(
      faults_of("[[symmetry]]\nat = \"x+\"\n[[initial_displacements]]\ngradient = [[0.1, 0], [0, 0]]\n"),
      "the initial displacement leaves the symmetry plane \"x+\"; expected none along its normal there (see "
      "\"centre\")");
  EXPECT_EQ(faults_of("[[symmetry]]\nat = \"x+\"\n[[initial_displacements]]\ncentre = [\"1 m\", \"0 "
                      "m\"]\ngradient = [[0.1, 0], [0, 0]]\n"),
            "");
}

TEST(Start, FaultsOfMovedSupports) {
  const std::string support = "[[supports]]\nat = \"x+\"\nfix = [\"x\"]\n";
  EXPECT_EQ(faults_of(support + "velocity = [\"1 m/s\", \"0 m/s\"]\nhistory = {ramp = \"1 ms\"}\n"), "");
  EXPECT_EQ(faults_of(support + "velocity = [\"1 m/s\", \"1 m/s\"]\n"),
            "\"velocity\" moves y, which this support does not hold; expected 0 there, or \"y\" in \"fix\"");
  EXPECT_EQ(faults_of(support + "history = \"step\"\n"),
            "\"history\" without \"velocity\"; expected both, or neither");
  EXPECT_EQ(faults_of(support + "mode = \"mean\"\nvelocity = [\"1 m/s\", \"0 m/s\"]\n"),
            "\"velocity\" with mode = \"mean\"; expected it only on a support that holds every point");
  EXPECT_EQ(faults_of(support + "velocity = [\"1 m/s\", \"0 m/s\"]\n[settling]\nmethod = \"damping\"\n"),
            "[settling] with a support that has a \"velocity\"; expected supports at rest, or no [settling]");
}

// --- On two masses m and a spring k between them, along x: the solution is known.

constexpr double m = 2, k = 800;

class Dumbbell : public test::FakeBody {
 public:
  Dumbbell() {
    layout_ = {2, 2, 2, 1, 0, 4};
    points_ = {{0, 0, 0}, {1, 0, 0}};
  }
  std::span<const double> mass() const override { return mass_; }
  std::size_t units() const override { return 1; }
  void internal_force(const double* u, const double*, double, double* f, double*) override {
    f[0] = k * (u[2] - u[0]), f[2] = -f[0], f[1] = f[3] = 0;
  }
  void stiffness(const double* x, double* y) const override {
    y[0] = k * (x[0] - x[2]), y[2] = -y[0], y[1] = y[3] = 0;
  }
  Energies energies(const double* u) const override { return {0.5 * k * (u[2] - u[0]) * (u[2] - u[0])}; }
  std::vector<Weight> points_of(const Place& place) const override {
    return {{place.sides.at(0) == "x+" ? 1u : 0u, 1.0}};
  }
  std::vector<Weight> interpolation(const Point&) const override { return {{0, 1.0}}; }

 private:
  std::vector<double> mass_{m, m};
};

Scene two_masses(double duration) {
  Scene s = test::scene_of_masses(duration);
  s.samples = 1000000;
  return s;
}

/// Drawn apart by a tenth of their distance.
Scene stretched_masses() {
  Scene s = two_masses(1.0);
  InitialDisplacement stretch;
  stretch.gradient[0][0] = 0.1;
  s.initial_displacements.push_back(stretch);
  return s;
}

struct Started {
  explicit Started(const Scene& s, const MarchOptions& options = {})
      : march(s, test::bodies_of(std::make_unique<Dumbbell>()), options) {
    MarchEvents events;
    events.sample = [&](const March& now) {
      const Ledger l = now.ledger();
      worst = std::max(worst, std::abs(l.imbalance()));
      most = std::max(most, std::abs(l.external) + l.initial);
    };
    march.run(events);
  }
  double u(int slot) const { return march.bodies()[0].u[std::size_t(slot)]; }
  March march;
  double worst = 0, most = 0;
};

// The far mass is pulled with velocity V, the near one starts from rest: seen from the far one it swings
// about the stretch 0 with u_far - u_near = V / omega sin(omega t), and the work done is k V^2/omega^2 (1 -
// cos(omega t)).
TEST(Start, MovedSupportPullsAndTheLedgerCountsItsWork) {
  Scene s = two_masses(1.0);
  s.supports.push_back({Place{0, {"x+"}, {}, {}}, {true, false, false}, {}, false, {0.5, 0, 0}, {}});
  const Started r(s);
  const double t = r.march.time(), dt = r.march.dt(), omega = std::sqrt(k / m),
               discrete = 2 / dt * std::asin(omega * dt / 2);
  EXPECT_NEAR(r.u(2), 0.5 * t, 1e-12);
  EXPECT_LT(r.worst, 1e-13 * r.most);
  // The leap-frog: stretch(n) = V dt sin(n theta) / sin(theta), theta = discrete dt (it starts at 0, and V dt
  // after one step).
  EXPECT_NEAR(r.u(2) - r.u(0), 0.5 * dt * std::sin(discrete * t) / std::sin(discrete * dt), 1e-12);
  EXPECT_GT(r.most, 0.1);
}

TEST(Start, MovedSupportFollowsItsHistory) {
  Scene s = two_masses(2.0);
  TimeHistory history;
  history.time = {0, 0.5, 1.0};
  history.factor = {0, 1, 0};
  s.supports.push_back({Place{0, {"x+"}, {}, {}}, {true, false, false}, {}, false, {0.3, 0, 0}, history});
  s.damping = 3.0;
  MarchOptions options;
  options.step = 0.05;  // the kinks of the history are whole steps, and the midpoint rule is exact
  const Started r(s, options);
  EXPECT_NEAR(r.u(2), 0.3 * 0.5, 1e-14);
  EXPECT_LT(r.worst, 1e-13 * r.most);
}

TEST(Start, InitialStretchSwingsAndItsEnergyIsCounted) {
  Scene s = stretched_masses();
  const Started r(s);
  const double dt = r.march.dt(), omega = std::sqrt(2 * k / m), discrete = 2 / dt * std::asin(omega * dt / 2);
  EXPECT_NEAR(r.march.ledger().initial, 0.5 * k * 0.01, 1e-12 * k);  // at rest
  // What the leap-frog adds to the kinetic energy, 1/2 v-.M v+ - 1/2 v.M v = -1/8 dt^2 a.M a, less what it
  // was at the start, where a = -+ k s/m on both masses; s goes with the cosine.
  const double begin = 0.25 * m * std::pow(dt * 0.1 * k / m, 2), cosine = std::cos(discrete * r.march.time());
  EXPECT_NEAR(r.march.ledger().discrete, begin * (1 - cosine * cosine), 1e-12 * k);
  EXPECT_NEAR(r.u(2) - r.u(0), 0.1 * std::cos(discrete * r.march.time()), 1e-12);
  EXPECT_LT(r.worst, 1e-13 * r.most);
}

// A support holds its place where the stretch has brought it.
TEST(Start, SupportsHoldTheInitialDisplacement) {
  Scene s = stretched_masses();
  s.supports.push_back({Place{0, {"x+"}, {}, {}}, {true, false, false}});
  const Started r(s);
  const double dt = r.march.dt(), omega = std::sqrt(k / m), discrete = 2 / dt * std::asin(omega * dt / 2);
  EXPECT_EQ(r.u(2), 0.1);
  EXPECT_NEAR(r.u(0), 0.1 * (1 - std::cos(discrete * r.march.time())), 1e-12);
  EXPECT_LT(r.worst, 1e-13 * r.most);
}

}  // namespace
}  // namespace femsph
