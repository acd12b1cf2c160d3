// Contact and rigid bodies against exact solutions, with both solvers.

#include "model/motion/effects/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "momentum.hpp"
#include "support.hpp"

namespace femsph::test {
namespace {

const char* const both[] = {"fem-full", "sph-corrected"};
constexpr double c_bar = 5172.194, rho = 7850;  // sqrt(2.1e11 / 7850)

/// Steel bodies in plane stress, 10 mm thick; `rest` holds the bodies and what follows.
Scene steel(const std::string& rest, const char* poisson = "0.0", const char* motion = "small") {
  return parse_scene(fmt::format(R"(
title = "contact"
[model]
plane = "stress"
motion = "{}"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = {}
density = "7850 kg/m^3"
{})",
                                 motion, poisson, rest),
                     "contact.toml");
}

std::string box(const char* name, const char* origin, const char* size) {
  return fmt::format(
      "[bodies.{}]\nshape = \"box\"\norigin = [{}]\nsize = [{}]\nthickness = \"10 mm\"\nmaterial = "
      "\"steel\"\n",
      name, origin, size);
}
std::string rigid(const char* name, const char* origin, const char* size, const char* mass) {
  return fmt::format(
      "[bodies.{}]\nshape = \"box\"\nrigid = true\norigin = [{}]\nsize = [{}]\nmass = \"{}\"\n", name, origin,
      size, mass);
}
std::string moving(const char* name, const char* velocity) {
  return fmt::format("[[initial]]\nbody = \"{}\"\nvelocity = [{}]\n", name, velocity);
}
std::string held(const char* name) {
  return fmt::format("[[supports]]\nbody = \"{}\"\nfix = [\"x\", \"y\", \"turn\"]\n", name);
}
std::string contact(const char* a, const char* b, double friction = 0) {
  return fmt::format(
      "[[contacts]]\nname = \"blow\"\nbetween = [\"{}\", \"{}\"]\nfriction = {:.9f}\n", a, b, friction);
}
std::string lasting(double seconds, int samples = 400) {
  return fmt::format("[time]\nduration = \"{:.9g} s\"\nsamples = {}\n", seconds, samples);
}

/// Mean of a column between two times.
double mean(const compare::RunResult& r, const std::string& column, double from, double to) {
  double sum = 0;
  int n = 0;
  for (std::size_t k = 0; k < r.history.rows(); ++k)
    if (r.history["time"].values[k] >= from && r.history["time"].values[k] <= to)
      sum += r.history[column].values[k], ++n;
  return sum / n;
}

/// Bars of length L that meet end to end at +-v behave as against a rigid wall: force rho c v A while waves
/// run to the free ends and back, 2 L / c, and then each has turned its velocity round: the impulse is 2 m v.
/// The contact yields like four spacings (its penalty is a quarter of rho c^2 / d) of 200: about 1 % of the
/// time.
void expect_blow(const compare::RunResult& r, double v, const char* method) {
  const double L = 0.1, area = 1e-4, last = 2 * L / c_bar, F = rho * c_bar * v * area;
  EXPECT_NEAR(std::abs(mean(r, "contact_blow_force_x", 0.2 * last, 0.8 * last)) / F, 1, 0.01) << method;
  const auto &t = r.history["time"].values, &f = r.history["contact_blow_force_x"].values;
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
    if (key == "blow depth" || key == "contact shortens the step")
      fmt::print("{}: {} {}\n", method, key, value);
  fmt::print("{}: force {:.4f}, time {:.4f}, impulse {:.4f}, imbalance {:.2e}\n", method,
             std::abs(mean(r, "contact_blow_force_x", 0.2 * last, 0.8 * last)) / F, end / last,
             impulse / (2 * rho * L * area * v), r.ledger.imbalance() / r.ledger.initial);
}

TEST(Contact, TwoBarsExchangeTheirVelocities) {
  const Scene scene = steel(
      box("left", "\"-100 mm\", \"0 mm\"", "\"100 mm\", \"10 mm\"") +
      box("right", "\"0 mm\", \"0 mm\"", "\"100 mm\", \"10 mm\"") + moving("left", "\"1 m/s\", \"0 m/s\"") +
      moving("right", "\"-1 m/s\", \"0 m/s\"") + contact("left", "right") + lasting(60e-6, 1000));
  for (const char* method : both) expect_blow(run(scene, method, 1), 1, method);
}

TEST(Contact, BarAgainstARigidWall) {
  const Scene scene = steel(
      rigid("wall", "\"-20 mm\", \"-20 mm\"", "\"20 mm\", \"50 mm\"", "1 kg") +
      box("bar", "\"0 mm\", \"0 mm\"", "\"100 mm\", \"10 mm\"") + held("wall") +
      moving("bar", "\"-1 m/s\", \"0 m/s\"") + contact("wall", "bar") + lasting(60e-6, 1000));
  for (const char* method : both) expect_blow(run(scene, method, 1), 1, method);
}

// A mass M at speed V strikes the free end of a fixed bar of mass m = mu M (St Venant). With xi = c t / L the
// stress at the fixed end is
//   s / (rho c V) = 2 e^(-mu (xi - 1)) for 1 < xi < 3, and that + 2 e^(-mu (xi - 3)) (1 - 2 mu (xi - 3)) for
//   3 < xi < 5:
// greatest at xi = 3, 2 (1 + e^(-2 mu)) = 2.270, 2.736 for mu = 1, 0.5. The wave front rings where it is
// discretized, so the peak is read from the ratio of the means of both histories over 0.05 to 0.25 L/c behind
// it, 20 spacings off the root (a boundary particle shows its own stress). The contact delays the front by
// about three times the spacings it yields by, and behind the front the stress falls by 4.3 a L/c: hence a
// stiffness of 4, one spacing of 800. (It chatters more: energy within 1 %, not 0.5 %.)
TEST(Contact, RigidMassOnAFixedBar) {
  const double L = 0.2, m = rho * L * 1e-5;
  for (const double mu : {1.0, 0.5}) {
    const Scene scene = steel(
        rigid("mass", "\"200 mm\", \"-5 mm\"", "\"20 mm\", \"12 mm\"",
              fmt::format("{:.9f} kg", m / mu).c_str()) +
        box("bar", "\"0 mm\", \"0 mm\"", "\"200 mm\", \"1 mm\"") + moving("mass", "\"-1 m/s\", \"0 m/s\"") +
        contact("mass", "bar") + "stiffness = 4.0\n" +
        "[[supports]]\nbody = \"bar\"\nat = \"x-\"\nfix = [\"x\"]\n"
        "[[probes]]\nname = \"root\"\nbody = \"bar\"\nquantity = \"stress\"\npoint = [\"5 mm\", \"0.5 "
        "mm\"]\n" +
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

struct Blow {
  double linear = 0, angular = 0, imbalance = 0, initial = 0, friction = 0,
         depth = 0;  ///< changes over the run, relative to the start
  bool touched = false;
};

Blow collide(const Scene& scene, const std::string& method, double spacing_mm) {
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].rigid)
      bodies.push_back(compare::discretize(scene, b, compare::method_named(method), {spacing_mm * 1e-3, {}}));
  March march(scene, std::move(bodies), {});
  std::optional<Momentum> start;
  Blow blow;
  MarchEvents events;
  events.sample = [&](const March& m) {
    const Momentum now = test::momentum(m);
    if (!start) start = now;
    double p = 0, h = 0, p0 = 0, h0 = 0;
    for (int c = 0; c < 3; ++c) {
      p += std::abs(now.linear[c] - start->linear[c]), p0 += std::abs(start->linear[c]);
      h += std::abs(now.angular[c] - start->angular[c]), h0 += std::abs(start->angular[c]);
    }
    blow.linear = std::max(blow.linear, p / p0);
    blow.angular = std::max(blow.angular, h / h0);
    blow.touched = blow.touched || m.effects().find<ContactOfBodies>()->pairs()[0].touching() > 0;
    const Ledger l = m.ledger();
    blow.imbalance = std::max(blow.imbalance, std::abs(l.imbalance()) / l.initial);
    blow.friction = l.friction / l.initial;
  };
  march.run(events);
  blow.depth = march.effects().find<ContactOfBodies>()->pairs()[0].deepest_share();
  fmt::print(
      "{}: linear {:.1e}, angular {:.1e}, imbalance {:.1e}, friction loss {:.3f}, depth {:.4f} d, step "
      "-{:.1f} %\n",
      method, blow.linear, blow.angular, blow.imbalance, blow.friction, blow.depth,
      100 * (1 - march.critical_step() / march.critical_step_without_contact()));
  return blow;
}

// Two blocks of unequal size meet off centre and turn: what one loses the other gains, with friction too.
// Both discretizations keep momentum and (in large motion) moment of momentum themselves, so the sums of both
// bodies stay put to round-off. Speeds as in the paper's block on block, 20 m/s: strains about 20 / 5300 =
// 0.4 %, so a depth of about 0.4 % / 0.25 of the spacing.
TEST(Contact, CollidingBlocksKeepMomentumAndEnergy) {
  for (const double friction : {0.0, 0.3}) {
    const Scene scene = steel(
        box("lower", "\"0 mm\", \"0 mm\"", "\"60 mm\", \"30 mm\"") +
            box("upper", "\"37 mm\", \"30.1 mm\"", "\"40 mm\", \"40 mm\"") +
            moving("upper", "\"-5 m/s\", \"-20 m/s\"") + contact("upper", "lower", friction) + lasting(60e-6),
        "0.3", "large");
    for (const char* method : both) {
      const Blow blow = collide(scene, method, 2.5);
      EXPECT_TRUE(blow.touched) << method;
      EXPECT_LT(blow.linear, 1e-12) << method;
      EXPECT_LT(blow.angular, 1e-11) << method;
      EXPECT_LT(blow.imbalance, 0.005) << method << friction;
      EXPECT_LT(blow.depth, 0.05) << method;
      if (friction > 0) {
        EXPECT_GT(blow.friction, 0.001) << method;
      }
    }
  }
}

// The same with a rigid disc, which flies on turning.
TEST(Contact, RigidDiscOnABlockKeepsMomentumAndEnergy) {
  const Scene scene = steel(
      box("block", "\"0 mm\", \"0 mm\"", "\"60 mm\", \"30 mm\"") +
          "[bodies.disc]\nshape = \"disc\"\nrigid = true\ncentre = [\"20 mm\", \"50.1 mm\"]\nradius = "
          "\"20 mm\"\nmass = \"0.1 kg\"\n" +
          moving("disc", "\"3 m/s\", \"-5 m/s\"") + contact("disc", "block", 0.2) + lasting(100e-6),
      "0.3", "large");
  for (const char* method : both) {
    const Blow blow = collide(scene, method, 2);
    EXPECT_TRUE(blow.touched) << method;
    EXPECT_LT(blow.linear, 1e-12) << method;
    EXPECT_LT(blow.angular, 1e-11) << method;
    EXPECT_LT(blow.imbalance, 0.005) << method;
    EXPECT_GT(blow.friction, 0) << method;
  }
}

// In space: a cube against a larger one, facets of 5 and 4 mm.
TEST(Contact, CollidingCubesKeepMomentumAndEnergy) {
  const auto cube = [](const char* name, const char* origin, const char* size) {
    return fmt::format("[bodies.{}]\nshape = \"box\"\norigin = [{}]\nsize = [{}]\nmaterial = \"steel\"\n",
                       name, origin, size);
  };
  const Scene scene = parse_scene(
      "title = \"cubes\"\n[model]\nplane = \"none\"\nmotion = \"large\"\n[materials.steel]\nlaw = "
      "\"elastic\"\nyoung = \"210 GPa\"\npoisson = 0.3\n"
      "density = \"7850 kg/m^3\"\n" +
          cube("lower", "\"0 mm\", \"0 mm\", \"0 mm\"", "\"40 mm\", \"40 mm\", \"40 mm\"") +
          cube("upper", "\"12 mm\", \"15 mm\", \"40.05 mm\"", "\"37 mm\", \"37 mm\", \"22 mm\"") +
          moving("upper", "\"2 m/s\", \"1 m/s\", \"-10 m/s\"") + contact("upper", "lower", 0.2) +
          lasting(40e-6),
      "cubes.toml");
  for (const char* method : both) {
    const Blow blow = collide(scene, method, 5);
    EXPECT_TRUE(blow.touched) << method;
    EXPECT_LT(blow.linear, 1e-12) << method;
    EXPECT_LT(blow.angular, 1e-10) << method;
    EXPECT_LT(blow.imbalance, 0.005) << method;
  }
}

// A block at rest on a wall: the contact carries its weight, 7850 x 0.02 x 0.02 x 0.01 x 9.81 = 0.30803 N.
TEST(Contact, RestingBlockWeighsWhatItWeighs) {
  const Scene scene = steel(
      rigid("wall", "\"-50 mm\", \"-20 mm\"", "\"200 mm\", \"20 mm\"", "1 kg") +
          box("block", "\"0 mm\", \"0 mm\"", "\"20 mm\", \"20 mm\"") + held("wall") +
          "[gravity]\nacceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n" + contact("wall", "block") +
          "[settling]\nmethod = \"damping\"\n" + lasting(20e-3, 10),
      "0.3");
  for (const char* method : both) {
    const auto r = run(scene, method, 2);
    EXPECT_TRUE(r.settled) << method;
    EXPECT_NEAR(last(r, "contact_blow_force_y") / 0.30803, 1, 1e-3) << method;
    EXPECT_NEAR(last(r, "contact_blow_force_x"), 0, 1e-9) << method;
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
    const Scene scene = steel(
        rigid("slope", "\"-50 mm\", \"-20 mm\"", "\"200 mm\", \"20 mm\"", "1 kg") +
            box("block", "\"0 mm\", \"0 mm\"", "\"20 mm\", \"20 mm\"") + held("slope") +
            contact("slope", "block", mu) +
            fmt::format("[[loads]]\nbody = \"block\"\nat = \"all\"\nforce = [\"{:.9f} "
                        "N\", \"{:.9f} N\"]\nhistory = {{ramp = \"0.5 ms\"}}\n",
                        N / std::sqrt(3.0), -N) +
            "[[probes]]\nname = \"middle\"\nbody = \"block\"\nquantity = "
            "\"displacement\"\npoint = [\"10 mm\", \"10 mm\"]\n" +
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
