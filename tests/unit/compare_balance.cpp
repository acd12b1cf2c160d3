// Reactions close the balance: what supports, loads and gravity give is what the bodies' momentum gains, and
// their work is what the energy gains.
//
// Histories here have a row for every step, so that the trapezoidal rule over a reaction is the sum that the
// leap-frog makes: with m (v+ - v-) = dt f at every whole step and v(n) = (v- + v+)/2, sum' dt f = m (v(N) -
// v(0)), sum' with half of the first and last term. To round-off.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "compare/run/run.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {
namespace {

using testing::AllOf, testing::HasSubstr, testing::ThrowsMessage;

const std::string steel = R"([materials.steel]
law = "elastic"
young = "210 GPa"
poisson = 0.25
density = "7850 kg/m^3"
)";

Scene scene_of(const std::string& text) { return parse_scene(text, "balance.toml"); }

/// A bar 100 x 10 x 10 mm of steel, along x, and what happens to it in `ms`; a row for every step.
Scene bar(const std::string& what, const std::string& ms, const char* motion = "small") {
  return scene_of(
      "[model]\nplane = \"none\"\nmotion = \"" + std::string(motion) + "\"\n" + steel +
      "[bodies.bar]\nshape = \"box\"\nsize = [\"100 mm\", \"10 mm\", \"10 mm\"]\nmaterial = \"steel\"\n" +
      what + "[time]\nduration = \"" + ms + " ms\"\nsamples = 1000000\n");
}

const std::vector<double>& column(const RunResult& r, const std::string& name) {
  return r.history[name].values;
}

double impulse(const RunResult& r, const std::string& force) {
  const auto &t = column(r, "time"), &f = column(r, force);
  double sum = 0;
  for (std::size_t k = 1; k < t.size(); ++k) sum += 0.5 * (t[k] - t[k - 1]) * (f[k] + f[k - 1]);
  return sum;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

double change(const RunResult& r, const std::string& name) {
  return column(r, name).back() - column(r, name).front();
}

constexpr double bar_mass = 7850 * 0.1 * 1e-4;

// Brought to 1 m/s by its left face in 1 ms, some thirteen periods of its slowest motion: M v at every
// spacing, and on the way exactly.
TEST(Balance, ImpulseOfADrivenFaceIsTheMomentumOfTheBar) {
  const Scene scene = bar(
      "[[supports]]\nat = \"x-\"\nfix = [\"x\"]\nvelocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]\nhistory = "
      "{time = [\"0 ms\", \"1 ms\"], factor = [0, 1]}\nname = \"grip\"\n",
      "1.2");
  for (const char* method : {"fem-full", "sph-corrected"})
    for (const double mm : {10.0, 5.0}) {
      const RunResult r = run_scene(scene, method_named(method), {mm * 1e-3, {}}, {});
      EXPECT_NEAR(impulse(r, "support_grip_force_x"), change(r, "momentum_x"), 1e-12 * bar_mass)
          << method << mm;
      const auto &t = column(r, "time"), &p = column(r, "momentum_x");
      double sum = 0;
      int n = 0;
      for (std::size_t k = 0; k < t.size(); ++k)
        if (t[k] > 1e-3) sum += p[k], ++n;
      EXPECT_NEAR(sum / n, bar_mass, 2e-3 * bar_mass) << method << mm;
      EXPECT_LT(largest(column(r, "energy_imbalance")), 1e-12 * r.ledger.external) << method << mm;
      EXPECT_LT(r.balance.force, 1e-12) << method << mm;
      EXPECT_LT(r.balance.moment, 1e-12) << method << mm;
    }
}

// A support that moves at full speed from the start gives its points theirs at once; one that holds points of
// a body in flight stops them. Damping of these points is in the reaction as well.
TEST(Balance, SupportsThatStartOrStopAtOnceGiveAnImpulse) {
  const std::string push =
      "[[supports]]\nat = \"x-\"\nfix = [\"x\"]\nvelocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]\nname = "
      "\"grip\"\n";
  const std::string wall =
      "[[supports]]\nat = \"x-\"\nfix = [\"x\"]\nname = \"grip\"\n[[initial]]\nvelocity = [\"-2 m/s\", \"1 "
      "m/s\", \"0 m/s\"]\n";
  const std::string together = push + "[[initial]]\nvelocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]\n";
  for (const char* method : {"fem-full", "sph-corrected"}) {
    const auto run = [&](const std::string& what) {
      return run_scene(bar(what, "0.03"), method_named(method), {0.005, {}}, {});
    };
    const RunResult pushed = run(push), stopped = run(wall), flying = run(together);
    for (const RunResult* r : {&pushed, &stopped}) {
      EXPECT_NEAR(impulse(*r, "support_grip_force_x"), change(*r, "momentum_x"), 1e-12 * bar_mass) << method;
      EXPECT_GT(std::abs(change(*r, "momentum_x")), 0.5 * bar_mass) << method;
      EXPECT_LT(largest(column(*r, "energy_imbalance")), 1e-12 * largest(column(*r, "kinetic_energy")))
          << method;
    }
    EXPECT_NEAR(column(stopped, "momentum_x").front(), -2 * bar_mass, 1e-12)
        << method;  // before the wall has it
    EXPECT_NEAR(column(stopped, "kinetic_energy").front(), 0.5 * bar_mass * 5, 1e-12) << method;
    EXPECT_EQ(column(pushed, "kinetic_energy").front(), 0) << method;
    EXPECT_LT(largest(column(flying, "support_grip_force_x")), 1e-6) << method << ": nothing to give";
  }
}

// With mass-proportional damping the support also overcomes that of its own points, and of classic SPH the
// artificial viscosity.
TEST(Balance, DampingAndViscosityOfDrivenPointsAreInTheAccount) {
  const Scene scene = bar(
      "[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\", \"z\"]\nvelocity = [\"1 m/s\", \"0 m/s\", \"0 "
      "m/s\"]\nhistory = {time = [\"0 ms\", \"0.05 ms\"], factor = [0, 1]}\n"
      "name = \"grip\"\n[damping]\nrate = \"20000 1/s\"\n",
      "0.2");
  Method viscous = method_named("sph-classic-share");
  std::get<sph::Options>(viscous.options).viscosity = {0.5, 0.5, 0.1};
  for (const Method& method : {method_named("fem-full"), viscous}) {
    const RunResult r = run_scene(scene, method, {0.005, {}}, {});
    // P' = R - c P
    EXPECT_NEAR(impulse(r, "support_grip_force_x") - 20000 * impulse(r, "momentum_x"),
                change(r, "momentum_x"), 1e-11 * impulse(r, "support_grip_force_x"))
        << method.name;
    EXPECT_LT(largest(column(r, "energy_imbalance")), 1e-12 * r.ledger.external) << method.name;
    EXPECT_GT(r.ledger.damping, 0.1 * r.ledger.external) << method.name;
  }
  EXPECT_GT(run_scene(scene, viscous, {0.005, {}}, {}).ledger.viscosity, 0);
}

std::string block(const std::string& rest) {
  return "[model]\nplane = \"stress\"\n[materials.m]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = "
         "0.3\ndensity = \"1000 kg/m^3\"\n"
         "[bodies.b]\nshape = \"box\"\nsize = [\"2 m\", \"1 m\"]\nthickness = \"1 m\"\nmaterial = \"m\"\n" +
         rest;
}

// A block of 20 kN held in y along its foot and in x and y along its side: the corner belongs to both, and
// counts once.
TEST(Balance, SupportsThatShareACornerShareItsReaction) {
  const std::string rest =
      "[[supports]]\nat = \"y-\"\nfix = [\"y\"]\nname = \"foot\"\n[[supports]]\nat = \"x-\"\nfix = [\"x\", "
      "\"y\"]\nname = \"side\"\n"
      "[gravity]\nacceleration = [\"0 m/s^2\", \"-10 m/s^2\"]\n[settling]\nmethod = \"damping\"\ntolerance = "
      "1e-6\n[time]\nduration = \"0.5 s\"\nsamples = 5\n";
  for (const char* method : {"fem-full", "sph-corrected"})
    for (const double d : {0.5, 0.125}) {
      const RunResult r = run_scene(scene_of(block(rest)), method_named(method), {d, {}}, {});
      ASSERT_TRUE(r.settled) << method;
      EXPECT_NEAR(column(r, "support_foot_force_y").back() + column(r, "support_side_force_y").back(), 20000,
                  1e-6 * 2 * 20000)
          << method << d;
      EXPECT_GT(column(r, "support_side_force_y").back(), 100) << method << d;
      EXPECT_LT(r.balance.force, 1e-12) << method << d;
    }
}

// A bar of quadrilaterals, fine at the lower edge and coarse at the upper one, pulled at its right end by a
// traction: no moment at the left.
TEST(Balance, CentricPullOnAGradedFaceHasNoMoment) {
  const std::vector<double> y{0, 0.02, 0.05, 0.1, 0.2, 0.4, 1};
  std::string nodes, cells;
  const int n = int(y.size()), m = 9;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      nodes += std::to_string(i * n + j + 1) + " " + std::to_string(2.0 * i / (m - 1)) + " " +
               std::to_string(y[std::size_t(j)]) + " 0\n";
  int count = 0;
  const auto edge = [&](int tag, int a, int b) {
    cells += std::to_string(++count) + " 1 2 " + std::to_string(tag) + " " + std::to_string(tag) + " " +
             std::to_string(a) + " " + std::to_string(b) + "\n";
  };
  for (int j = 1; j < n; ++j) edge(1, j, j + 1), edge(2, (m - 1) * n + j, (m - 1) * n + j + 1);
  for (int i = 0; i + 1 < m; ++i)
    for (int j = 1; j < n; ++j) {
      const int a = i * n + j;
      cells += std::to_string(++count) + " 3 2 3 1 " + std::to_string(a) + " " + std::to_string(a + n) + " " +
               std::to_string(a + n + 1) + " " + std::to_string(a + 1) + "\n";
    }
  const std::string file =
      (std::filesystem::temp_directory_path() / ("graded-" + std::to_string(::getpid()) + ".msh")).string();
  std::ofstream(file) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"clamp\"\n1 2 "
                         "\"pull\"\n2 3 \"bar\"\n$EndPhysicalNames\n$Nodes\n"
                      << n * m << "\n"
                      << nodes << "$EndNodes\n$Elements\n"
                      << count << "\n"
                      << cells << "$EndElements\n";
  const RunResult r = run_scene(
      scene_of(
          "[model]\nplane = \"stress\"\n[materials.m]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = "
          "0.0\ndensity = \"1000 kg/m^3\"\n"
          "[bodies.b]\nshape = \"mesh\"\nfile = \"" +
          file +
          "\"\nunit = \"m\"\nthickness = \"1 m\"\nmaterial = \"m\"\n"
          "[[supports]]\nat = \"clamp\"\nfix = [\"x\", \"y\"]\nname = \"foot\"\n[[loads]]\nat = "
          "\"pull\"\nforce = [\"1 MN\", \"0 N\"]\n"
          "[settling]\nmethod = \"damping\"\ntolerance = 1e-6\n[time]\nduration = \"0.5 s\"\nsamples = 5\n"),
      method_named("fem-full"), {}, {});
  std::filesystem::remove(file);
  ASSERT_TRUE(r.settled) << testing::PrintToString(r.warnings);
  EXPECT_NEAR(column(r, "support_foot_force_x").back(), -1e6, 2);
  EXPECT_NEAR(column(r, "support_foot_moment_z").back(), 0, 1e6 * 1e-5);
  EXPECT_NEAR(column(r, "support_foot_centroid_x").back(), 0, 1e-12);
  EXPECT_NEAR(column(r, "support_foot_centroid_y").back(), 0.5, 1e-9);  // not the mean of the nodes, 0.25
  const auto said = std::find_if(
      r.derived.begin(), r.derived.end(), [](const auto& value) { return value.first == "support foot"; });
  ASSERT_NE(said, r.derived.end());
  EXPECT_THAT(said->second, HasSubstr("(0, 0.5, 0) m"));
}

TEST(Balance, SupportsThatContradictEachOtherAreRefused) {
  const std::string foot = "[[supports]]\nat = \"y-\"\nfix = [\"x\", \"y\"]\n",
                    time = "[time]\nduration = \"1 ms\"\n";
  const auto push = [](const char* speed, const char* more = "") {
    return std::string("[[supports]]\nat = \"x+\"\nfix = [\"x\"]\nvelocity = [\"") + speed +
           "\", \"0 m/s\"]\n" + more;
  };
  const auto run = [&](const std::string& rest) {
    return run_scene(scene_of(block(rest + time)), method_named("fem-full"), {0.5, {}}, {});
  };
  EXPECT_THAT(
      [&] { run(foot + push("1 m/s")); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("balance.toml:17:6: this support moves it at 1 m/s along x "
                                                "and the one at balance.toml:14:6 holds it at rest"),
                                      HasSubstr("both have the point (2, 0, 0) m of body \"b\""))));
  EXPECT_THAT(
      [&] {
        run(push("1 m/s") + "[[supports]]\nat = \"y+\"\nfix = [\"x\"]\nvelocity = [\"2 m/s\", \"0 m/s\"]\n");
      },
      ThrowsMessage<InputError>(HasSubstr(
          "this support moves it at 2 m/s along x and the one at balance.toml:14:6 moves it at 1 m/s")));
  EXPECT_THAT(
      [&] { run(push("1 m/s") + "[[symmetry]]\nat = \"x+\"\n"); },
      ThrowsMessage<InputError>(HasSubstr("balance.toml:18:6: this support holds it at rest along x")));
  EXPECT_THAT(
      [&] {
        run(push("1 m/s", "history = {ramp = \"1 ms\"}\n") +
            "[[supports]]\nat = \"y+\"\nfix = [\"x\"]\nvelocity = [\"1 m/s\", \"0 m/s\"]\n");
      },
      ThrowsMessage<InputError>(HasSubstr("moves it at 1 m/s times its history")));
  EXPECT_THAT([&] { run(push("1 m/s") + "[[supports]]\nat = \"y+\"\nfix = [\"x\"]\nmode = \"mean\"\n"); },
              ThrowsMessage<InputError>(HasSubstr("holds the mean along x of a place of body \"b\" where the "
                                                  "one at balance.toml:14:6 moves points")));
  EXPECT_NO_THROW(run(
      push("1 m/s") + "[[supports]]\nat = \"y+\"\nfix = [\"x\", \"y\"]\nvelocity = [\"1 m/s\", \"0 m/s\"]\n"))
      << "they agree";
  EXPECT_NO_THROW(
      run(foot +
          "[[supports]]\nat = \"x-\"\nfix = [\"x\"]\n[[loads]]\nat = \"x+\"\nforce = [\"1 N\", \"0 N\"]\n"))
      << "they agree";
}

// Free fall from rest: v = g t at whole steps, so that the kinetic energy is 1/2 M (g t)^2, from 0 on.
TEST(Balance, KineticEnergyIsThatOfTheWholeStep) {
  const RunResult r = run_scene(scene_of(block("[gravity]\nacceleration = [\"0 m/s^2\", \"-10 "
                                               "m/s^2\"]\n[time]\nduration = \"5 ms\"\nsamples = 20\n")),
                                method_named("fem-full"), {0.25, {}}, {});
  for (std::size_t k = 0; k < r.history.rows(); ++k) {
    const double t = column(r, "time")[k];
    EXPECT_NEAR(column(r, "kinetic_energy")[k], 0.5 * 2000 * 100 * t * t, 1e-12);
    EXPECT_NEAR(column(r, "momentum_y")[k], -20000 * t, 1e-9);
    EXPECT_NEAR(column(r, "angular_momentum_z")[k], -20000 * t, 1e-9);  // the centre is 1 m from the origin
    EXPECT_LT(std::abs(column(r, "energy_imbalance")[k]), 1e-11);
  }
}

TEST(Balance, NamesThatMeetInAColumnAreRefused) {
  EXPECT_THAT(
      [] {
        run_scene(
            scene_of(block("[[supports]]\nat = \"x-\"\nfix = [\"x\"]\nname = \"foot\"\n[[probes]]\nname = "
                           "\"support_foot_force\"\nquantity = \"displacement\"\npoint = [\"1 m\", \"0 m\"]\n"
                           "[time]\nduration = \"1 ms\"\n")),
            method_named("fem-full"), {0.5, {}}, {});
      },
      ThrowsMessage<InputError>(HasSubstr("the history would have two columns \"support_foot_force_x\"")));
}

// Whatever acts, by every method: the accounts of every sample add up.
TEST(Balance, EveryScenesForcesAddUp) {
  const std::string gravity = "[gravity]\nacceleration = [\"3 m/s^2\", \"-10 m/s^2\"]\n",
                    time = "[time]\nduration = \"4 ms\"\nsamples = 8\n";
  const std::string second =
      "[bodies.c]\nshape = \"box\"\norigin = [\"0 m\", \"1 m\"]\nsize = [\"2 m\", \"1 m\"]\nthickness = \"1 "
      "m\"\nmaterial = \"m\"\n";
  const std::vector<std::pair<const char*, std::string>> scenes = {
      {"loads",
       block("[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[[loads]]\nat = \"x+\"\nforce = [\"1 kN\", "
             "\"-2 kN\"]\nhistory = {ramp = \"3 ms\"}\n[[loads]]\nat = \"y+\"\npressure = \"1 kPa\"\n" +
             gravity)},
      {"mean", block("[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\"]\nmode = \"mean\"\n[[loads]]\nat = "
                     "\"x+\"\nforce = [\"1 kN\", \"-2 kN\"]\n" +
                     gravity)},
      {"driven", block("[[supports]]\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[[supports]]\nat = \"x+\"\nfix = "
                       "[\"y\"]\nvelocity = [\"0 m/s\", \"0.1 m/s\"]\n[damping]\nrate = \"100 1/s\"\n" +
                       gravity)},
      {"symmetry", block("[[symmetry]]\nat = \"x-\"\n[[supports]]\nat = \"y-\"\nfix = [\"y\"]\n" + gravity)},
      {"tied", block(second +
                     "[[supports]]\nbody = \"b\"\nat = \"y-\"\nfix = [\"x\", \"y\"]\n[[contacts]]\nkind = "
                     "\"tied\"\nbetween = [\"b\", \"c\"]\n" +
                     gravity)},
      {"contact", block(second +
                        "[[supports]]\nbody = \"b\"\nat = \"y-\"\nfix = [\"x\", "
                        "\"y\"]\n[[contacts]]\nbetween = [\"b\", \"c\"]\nfriction = 0.3\n" +
                        gravity)},
      {"rigid",
       block(
           "[bodies.w]\nshape = \"box\"\nrigid = true\norigin = [\"0.5 m\", \"1 m\"]\nsize = [\"1 m\", \"1 "
           "m\"]\nmass = \"500 kg\"\n[[supports]]\nbody = \"w\"\nfix = [\"x\"]\n[[supports]]\nbody = \"b\"\n"
           "at = \"y-\"\nfix = [\"x\", \"y\"]\n[[contacts]]\nbetween = [\"w\", \"b\"]\nfriction = 0.3\n" +
           gravity)}};
  for (const auto& [name, text] : scenes)
    for (const bool large : {false, true})
      for (const Method& method : methods()) {
        const bool virtual_only_small = !method.is_fem() && method.name != "sph-corrected" &&
                                        (std::string(name) == "symmetry");
        if (virtual_only_small || (large && (std::string(name) == "loads" || method.name == "sph-virtual" ||
                                             method.name == "sph-weight")))
          continue;
        std::string whole = text + time;
        if (large) whole.insert(whole.find("plane"), "motion = \"large\"\n");
        RunResult r;
        try {
          r = run_scene(scene_of(whole), method, {0.25, {}}, {});
        } catch (const std::exception& error) {
          ADD_FAILURE() << name << " " << method.name << ": " << error.what();
          continue;
        }
        EXPECT_LT(r.balance.force, 1e-11) << name << " " << method.name << (large ? " large" : "");
        const bool keeps_moments = method.is_fem() || method.name == "sph-corrected";
        if (keeps_moments) {
          EXPECT_LT(r.balance.moment, 1e-11) << name << " " << method.name << (large ? " large" : "");
        }
        EXPECT_THAT(r.warnings, testing::Not(testing::Contains(HasSubstr("do not add up"))))
            << name << " " << method.name;
      }
}

}  // namespace
}  // namespace femsph::compare
