// A press fit of two rings: the shaft, radii 10 and 20.0025 mm, goes into the hub, 20 and 30 mm, shrunk by
// 0.03 % at the start, and springs back. Lame, plane stress, E = 200 GPa, R = 20 mm, interference d = 2.5 um.
// Under the pressure p the hub's bore widens by
//   p R/E ((ro^2 + R^2)/(ro^2 - R^2) + nu),   the shaft shrinks by   p R/E ((R^2 + ri^2)/(R^2 - ri^2) - nu):
//   p = d E / (R (2.6 + 1.66667)) = 5.859 MPa.
// Across the section x = 0 of the quarter hub, 10 mm thick, the contact's resultant is p R t = 1171.9 N, and
// the hoop stress at r = 25 mm is
//   p R^2/(ro^2 - R^2) (1 + ro^2/r^2) = 11.437 MPa.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace femsph::test {
namespace {

std::string ring(const char* name, const char* inner, const char* outer) {
  return fmt::format(
      "[bodies.{0}]\nshape = \"ring\"\ncentre = [\"0 mm\", \"0 mm\"]\ninner = \"{1} mm\"\nouter = \"{2} "
      "mm\"\npart = \"quarter\"\nthickness = \"10 mm\"\nmaterial = \"steel\"\n"
      "[[symmetry]]\nbody = \"{0}\"\nat = \"x-\"\n[[symmetry]]\nbody = \"{0}\"\nat = \"y-\"\n",
      name, inner, outer);
}

Scene press(double shrink) {
  const auto text =
      "title = \"press fit\"\n[model]\nplane = \"stress\"\n[materials.steel]\nlaw = \"elastic\"\nyoung = "
      "\"200 GPa\"\npoisson = 0.3\ndensity = \"7850 kg/m^3\"\n" +
      ring("shaft", "10", "20.0025") + ring("hub", "20", "30") +
      fmt::format(
          "[[initial_displacements]]\nbody = \"shaft\"\ngradient = [[{0:.6f}, 0], [0, {0:.6f}]]\n", -shrink) +
      "[[contacts]]\nname = \"fit\"\nbetween = [\"shaft\", \"hub\"]\nstiffness = 4\n"
      "[[probes]]\nname = \"mid\"\nbody = \"hub\"\nquantity = \"stress\"\npoint = [\"25 mm\", \"0 "
      "mm\"]\n[settling]\nmethod = \"damping\"\n[time]\nduration = \"0.4 ms\"\nsamples = 20\n";
  return parse_scene(text, "press.toml");
}

// Four layers in either ring make five sectors in both, whose points lie opposite each other. Sectors of 18
// degrees: a point between two chords presses on one of them, whose normal is 9 degrees off the arc's (cos 9
// degrees: 1.2 %, and the resultant turns a little away from 45 degrees); the chords are 0.4 % shorter than
// the arc and their middles 1.2 % nearer to the centre; linear elements are some percent off in bending.
// Together within 5 %.
TEST(PressFit, OfAShrunkShaftHasLamesPressure) {
  const Scene scene = press(3e-4);
  const auto r = compare::run_scene(
      scene, compare::method_named("fem-full"), compare::Resolution{0, {4, 4, 0}}, {});
  EXPECT_TRUE(r.settled);
  fmt::print("force {:.6g} N, hoop {:.6g} Pa\n", last(r, "contact_fit_force_x"), last(r, "mid_yy"));
  const double x = last(r, "contact_fit_force_x"), y = last(r, "contact_fit_force_y");
  EXPECT_NEAR(std::hypot(x, y) / (1171.9 * std::sqrt(2)), 1, 0.05);
  EXPECT_NEAR(std::atan2(y, x), std::atan(1), 0.03);
  EXPECT_NEAR(last(r, "mid_yy") / 11.437e6, 1, 0.05);
}

// Shrunk by less than the interference it overlaps the hub.
TEST(PressFit, OfAShaftThatOverlapsTheHubIsRefused) {
  for (const double shrink : {1e-6, 1e-4}) {
    const Scene scene = press(shrink);
    try {
      compare::run_scene(scene, compare::method_named("fem-full"), compare::Resolution{0, {4, 4, 0}}, {});
      FAIL() << shrink;
    } catch (const MotionError& e) {
      EXPECT_NE(std::string(e.what()).find("contact \"fit\": the bodies overlap by 0.00"), std::string::npos)
          << e.what();
    }
  }
}

}  // namespace
}  // namespace femsph::test
