// Bodies bonded where they touch, with both solvers.

#include <gtest/gtest.h>

#include <algorithm>

#include "momentum.hpp"
#include "support.hpp"

namespace femsph::test {
namespace {

const char* const methods[] = {"fem-full", "fem-one-point", "sph-corrected", "sph-classic-trapezoid"};

/// Two boxes, `stiff` (E = 210 GPa) and `soft` (E / `ratio`), tied.
Scene pair_of(const char* motion, double ratio, const std::string& stiff, const std::string& soft, const std::string& rest, const char* poisson = "0.0") {
  const auto body = [](const char* name, const std::string& box) {
    return fmt::format("[bodies.{0}]\nshape = \"box\"\n{1}thickness = \"10 mm\"\nmaterial = \"{0}\"\n", name, box);
  };
  const auto material = [&](const char* name, double young) {
    return fmt::format("[materials.{}]\nlaw = \"elastic\"\nyoung = \"{:.9g} Pa\"\npoisson = {}\ndensity = \"7850 kg/m^3\"\n", name, young, poisson);
  };
  return parse_scene(fmt::format("title = \"tied\"\n[model]\nplane = \"stress\"\nmotion = \"{}\"\n", motion) + material("stiff", 2.1e11) + material("soft", 2.1e11 / ratio) +
                         body("stiff", stiff) + body("soft", soft) + "[[contacts]]\nname = \"bond\"\nkind = \"tied\"\nbetween = [\"stiff\", \"soft\"]\n" + rest,
                     "tied.toml");
}

std::string stress_probe(const char* name, const char* body, const char* point) {
  return fmt::format("[[probes]]\nname = \"{}\"\nbody = \"{}\"\nquantity = \"stress\"\npoint = [{}]\n", name, body, point);
}

// A bar of two halves with E1 / E2 = 1e4 is pulled by 1 kN: uniaxial stress F / A = 1e3 / (0.02 x 0.01) = 5 MPa everywhere, and
// elongation s (L1 / E1 + L2 / E2) = 5e6 x 0.1 x (1 + 1e4) / 2.1e11 = 23.812 mm/m x 1 m .. = 0.0238119 x 1e-0 m at the soft end.
// (Strain of the soft half 23.8 %: small motion keeps it linear.) Poisson's ratio 0 leaves the stress uniform.
TEST(Tied, BarOfTwoHalvesWithTenThousandfoldStiffness) {
  const Scene scene = pair_of("small", 1e4, "size = [\"100 mm\", \"20 mm\"]\n", "origin = [\"100 mm\", \"0 mm\"]\nsize = [\"100 mm\", \"20 mm\"]\n",
                              "[[supports]]\nbody = \"stiff\"\nat = \"x-\"\nfix = [\"x\"]\n[[supports]]\nbody = \"stiff\"\nat = \"x- y-\"\nfix = [\"y\"]\n"
                              "[[loads]]\nbody = \"soft\"\nat = \"x+\"\nforce = [\"1 kN\", \"0 N\"]\n"
                              "[[probes]]\nname = \"end\"\nbody = \"soft\"\nquantity = \"displacement\"\npoint = [\"200 mm\", \"10 mm\"]\n" +
                                  stress_probe("left", "stiff", "\"97.5 mm\", \"10 mm\"") + stress_probe("right", "soft", "\"102.5 mm\", \"10 mm\"") +
                                  "[time]\nduration = \"500 ms\"\nsamples = 10\n[settling]\nmethod = \"damping\"\ntolerance = 1e-5\n");
  for (const char* method : methods) {
    const auto r = run(scene, method, 5);
    fmt::print("{}: end {:.6g} m ({:+.3f} %), stress {:.6g} and {:.6g} Pa, force {:.6g} N, {} steps, imbalance {:.2g} of {:.3g} J, contact {:.2g} J\n", method, last(r, "end_x"),
               error(last(r, "end_x"), 0.02381190), last(r, "left_xx"), last(r, "right_xx"), last(r, "contact_bond_force_x"), r.price.steps, r.ledger.imbalance(),
               r.ledger.external, r.ledger.contact);
    EXPECT_TRUE(r.settled) << method;
  }
}

}  // namespace
}  // namespace femsph::test
