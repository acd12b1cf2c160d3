#pragma once
// Short runs that between them have every kind of state that a checkpoint must keep, for runs that are
// interrupted.

#include <string>
#include <vector>

#include "tests/scene_text.hpp"

namespace femsph::interrupted {

struct Case {
  std::string name, scene, solver, options;
};

/// The end of every scene: 50 samples and 5 snapshots in `duration`.
inline std::string lasting(const std::string& duration) {
  return scene_text::time(duration, "samples = 50\nsnapshots = 5\n");
}

/// Friction, a rigid body, large motion, plasticity: a block strikes another aslant, a heavy disc falls on
/// it.
inline std::string impact() {
  using namespace scene_text;
  return model("stress", large_motion) + plastic_steel() +
         box("A", "100 50 mm", origin("50 100 mm") + thick("100 mm")) +
         box("B", "200 100 mm", thick("100 mm")) +
         "[bodies.weight]\nshape = \"disc\"\ncentre = [\"20 mm\", \"150.1 mm\"]\nradius = \"50 mm\"\n" +
         rigid("30 kg") + support("y-", "x y", of_body("B")) + contact("A", "B", "friction = 0.3\n") +
         contact("weight", "B", "friction = 0.1\n") + initial("20 -40 m/s", of_body("A")) +
         initial("0 -10 m/s", of_body("weight")) + probe("A", "displacement", "100 150 mm", of_body("A")) +
         section("middle", "stress", "100 0 mm", "100 100 mm", of_body("B")) + lasting("1.5 ms");
}

/// A reinforced beam that settles; method: "damping" or "kinetic".
inline std::string settling(const std::string& method) {
  using namespace scene_text;
  return model("stress") +
         material("concrete", "plastic", "23.3 GPa", "0.2", "2400 kg/m^3",
                  "yield = \"30 MPa\"\ntangent_ratio = 0.01\n") +
         material("bar", "plastic", "206 GPa", "0.3", "7850 kg/m^3",
                  "yield = \"20 MPa\"\ntangent_ratio = 0.01\n") +
         box("beam", "400 50 mm", thick("50 mm"), "concrete") +
         "[bars.bottom]\nbody = \"beam\"\nfrom = [\"0 mm\", \"12 mm\"]\nto = [\"400 mm\", \"12 mm\"]\n"
         "area = \"100 mm^2\"\nmaterial = \"bar\"\n" +
         support("x-", "x y") + load("x+", "0 -1.2 kN") + probe("tip", "displacement", "400 25 mm") +
         scene_text::settling(method) + lasting("60 ms");
}

/// A bar in space that is thrown against its clamped end.
inline std::string solid() {
  using namespace scene_text;
  return model("none", large_motion) + plastic_steel() + box("bar", "60 20 20 mm") + support("x-", "x y z") +
         initial("0 -40 15 m/s") + probe("end", "displacement", "60 20 20 mm") + lasting("0.8 ms");
}

/// Tied bodies of unlike grids, neo-Hookean; one end is drawn by a support that starts gently and turns back.
inline std::string bonded() {
  using namespace scene_text;
  return model("stress", large_motion) + material("stiff", "neo-hookean", "60 MPa", "0.3", "1000 kg/m^3") +
         material("soft", "neo-hookean", "10 MPa", "0.3", "1000 kg/m^3") +
         box("stiff", "100 50 mm", thick("20 mm"), "stiff") +
         box("soft", "100 50 mm", origin("100 0 mm") + thick("20 mm"), "soft") +
         contact("stiff", "soft", named("bond") + "kind = \"tied\"\n") +
         support("x-", "x y", of_body("stiff")) +
         support(
             "x+", "x y",
             named("grip") + of_body("soft") + "velocity = [\"2 m/s\", \"1 m/s\"]\n" +
                 "history = {time = [\"0 ms\", \"2 ms\", \"6 ms\", \"8 ms\"], factor = [0, 1, 1, -0.5]}\n") +
         probe("soft", "displacement", "150 25 mm", of_body("soft")) + lasting("12 ms");
}

/// Johnson-Cook: plastic strain, its rate and heat are carried from step to step.
inline std::string hot() {
  using namespace scene_text;
  return model("none", large_motion) +
         material("steel", "plastic", "206 GPa", "0.3", "7830 kg/m^3", "yield = \"806 MPa\"\n") +
         R"toml([materials.steel.johnson_cook]
B = "614 MPa"
n = 0.168
C = 0.0089
reference_rate = "1 1/s"
m = 1.1
melting = "1813.15 K"
room = "293.15 K"
heat_capacity = "460 J/(kg K)"
heat_share = 0.9
)toml" + box("bar", "20 20 60 mm") +
         support("z-", "z") + initial("0 0 -100 m/s") + probe("foot", "plastic_strain", "10 10 1 mm") +
         lasting("200 us");
}

/// Cells from a file.
inline std::string meshed() {
  using namespace scene_text;
  return model("stress", large_motion) + plastic_steel() +
         "[bodies.plate]\nshape = \"mesh\"\nfile = \"" FEMSPH_SOURCE_DIR
         "/tests/scenes/l_shape.msh\"\n"
         "unit = \"m\"\nthickness = \"100 mm\"\nmaterial = \"steel\"\n" +
         support("foot", "x y") + initial("30 -10 m/s") + probe("top", "displacement", "0.5 2 m") +
         lasting("80 ms");
}

/// A quarter of a ball with its own cells, on a wall, mirrored.
inline std::string ball() {
  using namespace scene_text;
  return model("none") + steel() + R"([bodies.ball]
shape = "ball"
centre = ["0 mm", "0 mm", "10 mm"]
radius = "10 mm"
part = "quarter"
material = "steel"
[bodies.wall]
shape = "box"
rigid = true
mass = "1 kg"
origin = ["-15 mm", "-15 mm", "-5 mm"]
size = ["30 mm", "30 mm", "5 mm"]
[[supports]]
body = "wall"
fix = ["x", "y", "z", "turn-x", "turn-y", "turn-z"]
[[symmetry]]
body = "ball"
at = "x-"
[[symmetry]]
body = "ball"
at = "y-"
)" + initial("0 0 -30 m/s", of_body("ball")) +
         contact("ball", "wall", "stiffness = 10\n") +
         probe("centre", "displacement", "0 0 10 mm", of_body("ball")) + lasting("100 us");
}

inline const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"impact", impact(), "fem-full", "--spacing 5mm"},
      {"impact", impact(), "fem-sri", "--spacing 5mm"},
      {"impact", impact(), "fem-one-point", "--spacing 5mm"},
      {"impact", impact(), "fem-assumed-strain", "--spacing 5mm"},
      {"impact", impact(), "sph-corrected", "--spacing 5mm"},
      {"impact", impact(), "sph-classic-share", "--spacing 5mm --viscosity 1,1,0.01"},
      {"impact", impact(), "A=sph-classic-share,B=fem-assumed-strain", "--spacing 5mm --viscosity 1,1,0.01"},
      {"damped", settling("damping"), "fem-full", "--spacing 12.5mm"},
      {"damped", settling("damping"), "sph-classic-share", "--spacing 12.5mm --viscosity 1,1,0.01"},
      {"damped", settling("damping"), "sph-virtual", "--spacing 12.5mm"},
      {"damped", settling("damping"), "sph-weight", "--spacing 12.5mm"},
      {"kinetic", settling("kinetic"), "sph-corrected", "--spacing 12.5mm"},
      {"kinetic", settling("kinetic"), "fem-one-point", "--spacing 12.5mm"},
      {"bonded", bonded(), "fem-full", "--spacing 5mm"},
      {"bonded", bonded(), "sph-corrected", "--spacing 5mm"},
      {"bonded", bonded(), "fem-full,soft=sph-corrected", "--spacing 5mm"},
      {"hot", hot(), "fem-one-point", "--spacing 5mm"},
      {"hot", hot(), "sph-corrected", "--spacing 5mm"},
      {"meshed", meshed(), "fem-full", ""},
      {"meshed", meshed(), "sph-corrected", "--spacing 125mm"},
      {"ball", ball(), "fem-assumed-strain", "--spacing 2mm"},
      {"ball", ball(), "sph-corrected", "--spacing 2mm"},
      {"solid", solid(), "fem-full", "--spacing 5mm"},
      {"solid", solid(), "fem-assumed-strain", "--spacing 5mm"},
      {"solid", solid(), "sph-corrected", "--spacing 5mm"},
      {"solid", solid(), "sph-classic-full", "--spacing 5mm"},
  };
  return all;
}

/// The first case by that name and solver.
inline const Case& case_named(const std::string& name, const std::string& solver) {
  for (const Case& c : cases())
    if (c.name == name && c.solver == solver) return c;
  throw std::logic_error("no case " + name + " by " + solver);
}

}  // namespace femsph::interrupted
