// Bodies bonded where they touch, with both solvers and between the two.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "model/scene/shapes/box.hpp"
#include "momentum.hpp"
#include "support.hpp"

namespace femsph::test {
namespace {

/// Two boxes, `stiff` (E = 210 GPa) and `soft` (E / `ratio`), tied.
Scene pair_of(const char* motion, double ratio, const std::string& stiff, const std::string& soft,
              const std::string& rest, const char* poisson = "0.0") {
  const auto body = [](const char* name, const std::string& box) {
    return fmt::format(
        "[bodies.{0}]\nshape = \"box\"\n{1}thickness = \"10 mm\"\nmaterial = \"{0}\"\n", name, box);
  };
  const auto material = [&](const char* name, double young) {
    return fmt::format(
        "[materials.{}]\nlaw = \"elastic\"\nyoung = \"{:.9g} Pa\"\npoisson = {}\ndensity = \"7850 kg/m^3\"\n",
        name, young, poisson);
  };
  return parse_scene(
      fmt::format("title = \"tied\"\n[model]\nplane = \"stress\"\nmotion = \"{}\"\n", motion) +
          material("stiff", 2.1e11) + material("soft", 2.1e11 / ratio) + body("stiff", stiff) +
          body("soft", soft) +
          "[[contacts]]\nname = \"bond\"\nkind = \"tied\"\nbetween = [\"stiff\", \"soft\"]\n" + rest,
      "tied.toml");
}

std::string stress_probe(const char* name, const char* body, const char* point) {
  return fmt::format(
      "[[probes]]\nname = \"{}\"\nbody = \"{}\"\nquantity = \"stress\"\npoint = [{}]\n", name, body, point);
}

// A bar of two halves with E1 / E2 = 1e4 is pulled by 1 kN: stress F / A = 1e3 / (0.02 x 0.01) = 5 MPa
// everywhere, and the end moves by s (L1 / E1 + L2 / E2) = 5e6 x 0.1 x (1 + 1e4) / 2.1e11 = 23.8119 mm (small
// motion: linear at any size). Poisson's ratio 0 leaves the stress uniform; FEM then is exact. Particles
// within two spacings of a boundary show their own stress, on both sides of the bond the same.
TEST(Tied, BarOfTwoHalvesWithTenThousandfoldStiffness) {
  const Scene scene = pair_of(
      "small", 1e4, "size = [\"100 mm\", \"20 mm\"]\n",
      "origin = [\"100 mm\", \"0 mm\"]\nsize = [\"100 mm\", \"20 mm\"]\n",
      "[[supports]]\nbody = \"stiff\"\nat = \"x-\"\nfix = "
      "[\"x\"]\n[[supports]]\nbody = \"stiff\"\nat = \"x- y-\"\nfix = [\"y\"]\n"
      "[[loads]]\nbody = \"soft\"\nat = \"x+\"\nforce = [\"1 kN\", \"0 N\"]\n"
      "[[probes]]\nname = \"end\"\nbody = \"soft\"\nquantity = "
      "\"displacement\"\npoint = [\"200 mm\", \"10 mm\"]\n" +
          stress_probe("left", "stiff", "\"97.5 mm\", \"10 mm\"") +
          stress_probe("right", "soft", "\"102.5 mm\", \"10 mm\"") +
          "[time]\nduration = \"500 ms\"\nsamples = 10\n[settling]\nmethod = "
          "\"damping\"\ntolerance = 1e-5\n");
  for (const char* method : {"fem-full", "fem-one-point", "sph-corrected",
                             "stiff=fem-full,soft=sph-corrected", "stiff=sph-corrected,soft=fem-full"}) {
    const auto r = run(scene, method, 5);
    const bool fem = method[0] == 'f';
    fmt::print("{}: end {:+.4f} %, stress {:.6g} and {:.6g} Pa, force {:.6g} N, contact {:.2g} of {:.3g} J\n",
               method, error(last(r, "end_x"), 0.02381190), last(r, "left_xx"), last(r, "right_xx"),
               last(r, "contact_bond_force_x"), r.ledger.contact, r.ledger.external);
    EXPECT_TRUE(r.settled) << method;
    EXPECT_NEAR(error(last(r, "end_x"), 0.02381190), 0, fem ? 0.001 : 1) << method;
    EXPECT_NEAR(last(r, "contact_bond_force_x"), -1000, 0.01) << method;  // of the stiff half on the soft one
    EXPECT_NEAR(last(r, "left_xx") / last(r, "right_xx"), 1, fem ? 1e-5 : 0.02) << method;
    if (fem) {
      EXPECT_NEAR(last(r, "left_xx") / 5e6, 1, 1e-4) << method;
    }
    EXPECT_LT(std::abs(r.ledger.contact), 1e-10 * r.ledger.external) << method;
    EXPECT_LT(std::abs(r.ledger.imbalance()), 1e-5 * r.ledger.external) << method;
  }
}

// Where points meet points, two tied halves of one material are one body: FEM gives the same motion to
// round-off.
TEST(Tied, MatchingHalvesAreOneBody) {
  const std::string rest =
      "[[supports]]\nbody = \"stiff\"\nat = \"x-\"\nfix = [\"x\", \"y\"]\n[time]\nduration = \"100 "
      "us\"\nsamples = 100\n";
  const auto probe = [](const char* body) {
    return fmt::format(
        "[[probes]]\nname = \"end\"\nbody = \"{}\"\nquantity = \"displacement\"\npoint = [\"200 mm\", \"20 "
        "mm\"]\n",
        body);
  };
  const auto load = [](const char* body) {
    return fmt::format("[[loads]]\nbody = \"{}\"\nat = \"x+ y+\"\nforce = [\"10 kN\", \"-10 kN\"]\n", body);
  };
  const Scene two = pair_of("small", 1, "size = [\"100 mm\", \"20 mm\"]\n",
                            "origin = [\"100 mm\", \"0 mm\"]\nsize = [\"100 mm\", \"20 mm\"]\n",
                            rest + probe("soft") + load("soft"), "0.3");
  Scene one = two;
  one.bodies.pop_back();
  one.bodies[0].shape = std::make_shared<Box>(2, Point{0, 0, 0}, Point{0.2, 0.02, 0});
  one.contacts.clear();
  one.probes[0].body = one.loads[0].place.body = 0;
  compare::RunOptions options;
  options.march.step = 4e-7;
  const auto tied = compare::run_scene(two, compare::method_named("fem-full"), {5e-3, {}}, options),
             whole = compare::run_scene(one, compare::method_named("fem-full"), {5e-3, {}}, options);
  double largest = 0, difference = 0;
  for (const char* column : {"end_x", "end_y"})
    for (std::size_t k = 0; k < whole.history.rows(); ++k) {
      largest = std::max(largest, std::abs(whole.history[column].values[k]));
      difference = std::max(
          difference, std::abs(whole.history[column].values[k] - tied.history[column].values[k]));
    }
  EXPECT_GT(largest, 1e-5);
  EXPECT_LT(difference, 1e-11 * largest);
}

// Two tied blocks of different sizes, grids and stiffness fly turning: they keep both momenta to round-off
// and their energy through a third of a turn (some 1e4 steps, in each of which the forces inside a body of
// particles cancel to 1e-12 of their sizes), and the bond takes nothing.
TEST(Tied, FlyingBlocksKeepMomentumAndEnergy) {
  const std::string spin =
      "velocity = [\"1 m/s\", \"0 m/s\"]\nspin = \"100 rad/s\"\ncentre = [\"50 mm\", \"20 mm\"]\n";
  const Scene scene = pair_of(
      "large", 1e2, "size = [\"50 mm\", \"40 mm\"]\n",
      "origin = [\"50 mm\", \"-7 mm\"]\nsize = [\"37 mm\", \"53 mm\"]\n",
      "[[initial]]\nbody = \"stiff\"\n" + spin + "[[initial]]\nbody = \"soft\"\n" + spin +
          "[time]\nduration = \"20 ms\"\nsamples = 20\n",
      "0.3");
  for (const char* method : {"fem-full", "sph-corrected", "stiff=fem-full,soft=sph-corrected",
                             "stiff=sph-corrected,soft=fem-full"}) {
    const compare::BodyMethods methods = compare::read_body_methods(method, &scene);
    std::vector<std::unique_ptr<Discretization>> bodies;
    for (std::size_t b = 0; b < 2; ++b) bodies.push_back(compare::discretize(scene, b, methods, {4e-3, {}}));
    March march(scene, std::move(bodies), {});
    std::optional<Momentum> start;
    double linear = 0, angular = 0, imbalance = 0, bond = 0;
    MarchEvents events;
    events.sample = [&](const March& m) {
      const Momentum now = test::momentum(m);
      if (!start) start = now;
      for (int c = 0; c < 3; ++c) {
        linear = std::max(linear, std::abs(now.linear[c] - start->linear[c]) / std::abs(start->linear[0]));
        angular = std::max(
            angular, std::abs(now.angular[c] - start->angular[c]) / std::abs(start->angular[2]));
      }
      const Ledger l = m.ledger();
      imbalance = std::max(imbalance, std::abs(l.imbalance()) / l.initial);
      bond = std::max(bond, std::abs(l.contact) / l.initial);
    };
    march.run(events);
    fmt::print("{}: linear {:.1e}, angular {:.1e}, imbalance {:.1e}, bond {:.1e}\n", method, linear, angular,
               imbalance, bond);
    EXPECT_LT(linear, 1e-9) << method;
    EXPECT_LT(angular, 1e-9) << method;
    EXPECT_LT(imbalance, 1e-5) << method;
    EXPECT_LT(bond, 1e-10) << method;
  }
}

}  // namespace
}  // namespace femsph::test
