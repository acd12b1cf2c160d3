#pragma once
// Short runs that between them carry every kind of history, for runs that are interrupted. METHOD stands for
// the way of settling, SOURCE for the folder of the sources.

#include <vector>

namespace femsph::interrupted {

struct Case {
  const char *name, *scene, *solver, *options;
};

inline const char* const blow = R"(
[model]
plane = "stress"
motion = "large"
[materials.steel]
law = "plastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "300 MPa"
tangent_ratio = 0.01
[bodies.A]
shape = "box"
origin = ["50 mm", "100 mm"]
size = ["100 mm", "50 mm"]
thickness = "100 mm"
material = "steel"
[bodies.B]
shape = "box"
size = ["200 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[bodies.weight]
shape = "disc"
centre = ["20 mm", "150.1 mm"]
radius = "50 mm"
rigid = true
mass = "30 kg"
[[supports]]
body = "B"
at = "y-"
fix = ["x", "y"]
[[contacts]]
between = ["A", "B"]
friction = 0.3
[[contacts]]
between = ["weight", "B"]
friction = 0.1
[[initial]]
body = "A"
velocity = ["20 m/s", "-40 m/s"]
[[initial]]
body = "weight"
velocity = ["0 m/s", "-10 m/s"]
[[probes]]
name = "A"
body = "A"
quantity = "displacement"
point = ["100 mm", "150 mm"]
[[sections]]
name = "middle"
body = "B"
quantity = "stress"
from = ["100 mm", "0 mm"]
to = ["100 mm", "100 mm"]
[time]
duration = "1.5 ms"
samples = 50
snapshots = 5
)";

inline const char* const settling = R"(
[model]
plane = "stress"
[materials.concrete]
law = "plastic"
young = "23.3 GPa"
poisson = 0.2
density = "2400 kg/m^3"
yield = "30 MPa"
tangent_ratio = 0.01
[materials.bar]
law = "plastic"
young = "206 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "20 MPa"
tangent_ratio = 0.01
[bodies.beam]
shape = "box"
size = ["400 mm", "50 mm"]
thickness = "50 mm"
material = "concrete"
[bars.bottom]
body = "beam"
from = ["0 mm", "12 mm"]
to = ["400 mm", "12 mm"]
area = "100 mm^2"
material = "bar"
[[supports]]
at = "x-"
fix = ["x", "y"]
[[loads]]
at = "x+"
force = ["0 N", "-1.2 kN"]
[[probes]]
name = "tip"
quantity = "displacement"
point = ["400 mm", "25 mm"]
[settling]
method = "METHOD"
[time]
duration = "60 ms"
samples = 50
snapshots = 5
)";

inline const char* const solid = R"(
[model]
plane = "none"
motion = "large"
[materials.steel]
law = "plastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "300 MPa"
tangent_ratio = 0.01
[bodies.bar]
shape = "box"
size = ["60 mm", "20 mm", "20 mm"]
material = "steel"
[[supports]]
at = "x-"
fix = ["x", "y", "z"]
[[initial]]
body = "bar"
velocity = ["0 m/s", "-40 m/s", "15 m/s"]
[[probes]]
name = "end"
quantity = "displacement"
point = ["60 mm", "20 mm", "20 mm"]
[time]
duration = "0.8 ms"
samples = 50
snapshots = 5
)";

/// Tied bodies of unlike grids, neo-Hookean; one end is drawn by a support that starts gently and turns back.
inline const char* const bonded = R"(
[model]
plane = "stress"
motion = "large"
[materials.stiff]
law = "neo-hookean"
young = "60 MPa"
poisson = 0.3
density = "1000 kg/m^3"
[materials.soft]
law = "neo-hookean"
young = "10 MPa"
poisson = 0.3
density = "1000 kg/m^3"
[bodies.stiff]
shape = "box"
size = ["100 mm", "50 mm"]
thickness = "20 mm"
material = "stiff"
[bodies.soft]
shape = "box"
origin = ["100 mm", "0 mm"]
size = ["100 mm", "50 mm"]
thickness = "20 mm"
material = "soft"
[[contacts]]
name = "bond"
kind = "tied"
between = ["stiff", "soft"]
[[supports]]
body = "stiff"
at = "x-"
fix = ["x", "y"]
[[supports]]
name = "grip"
body = "soft"
at = "x+"
fix = ["x", "y"]
velocity = ["2 m/s", "1 m/s"]
history = {time = ["0 ms", "2 ms", "6 ms", "8 ms"], factor = [0, 1, 1, -0.5]}
[[probes]]
name = "soft"
body = "soft"
quantity = "displacement"
point = ["150 mm", "25 mm"]
[time]
duration = "12 ms"
samples = 50
snapshots = 5
)";

/// Johnson-Cook: plastic strain, its rate and heat are carried from step to step.
inline const char* const hot = R"toml(
[model]
plane = "none"
motion = "large"
[materials.steel]
law = "plastic"
young = "206 GPa"
poisson = 0.3
density = "7830 kg/m^3"
yield = "806 MPa"
[materials.steel.johnson_cook]
B = "614 MPa"
n = 0.168
C = 0.0089
reference_rate = "1 1/s"
m = 1.1
melting = "1813.15 K"
room = "293.15 K"
heat_capacity = "460 J/(kg K)"
heat_share = 0.9
[bodies.bar]
shape = "box"
size = ["20 mm", "20 mm", "60 mm"]
material = "steel"
[[supports]]
at = "z-"
fix = ["z"]
[[initial]]
body = "bar"
velocity = ["0 m/s", "0 m/s", "-100 m/s"]
[[probes]]
name = "foot"
quantity = "plastic_strain"
point = ["10 mm", "10 mm", "1 mm"]
[time]
duration = "200 us"
samples = 50
snapshots = 5
)toml";

/// Cells from a file.
inline const char* const meshed = R"(
[model]
plane = "stress"
motion = "large"
[materials.steel]
law = "plastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
yield = "300 MPa"
tangent_ratio = 0.01
[bodies.plate]
shape = "mesh"
file = "SOURCE/tests/scenes/l_shape.msh"
unit = "m"
thickness = "100 mm"
material = "steel"
[[supports]]
at = "foot"
fix = ["x", "y"]
[[initial]]
body = "plate"
velocity = ["30 m/s", "-10 m/s"]
[[probes]]
name = "top"
quantity = "displacement"
point = ["0.5 m", "2 m"]
[time]
duration = "80 ms"
samples = 50
snapshots = 5
)";

/// A quarter of a ball with its own cells, on a wall, mirrored.
inline const char* const ball = R"(
[model]
plane = "none"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
[bodies.ball]
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
[[initial]]
body = "ball"
velocity = ["0 m/s", "0 m/s", "-30 m/s"]
[[contacts]]
between = ["ball", "wall"]
stiffness = 10
[[probes]]
name = "centre"
body = "ball"
quantity = "displacement"
point = ["0 mm", "0 mm", "10 mm"]
[time]
duration = "100 us"
samples = 50
snapshots = 5
)";

inline const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"blow", blow, "fem-full", "--spacing 5mm"},
      {"blow", blow, "fem-sri", "--spacing 5mm"},
      {"blow", blow, "fem-one-point", "--spacing 5mm"},
      {"blow", blow, "fem-assumed-strain", "--spacing 5mm"},
      {"blow", blow, "sph-corrected", "--spacing 5mm"},
      {"blow", blow, "sph-classic-share", "--spacing 5mm --viscosity 1,1,0.01"},
      {"damped", settling, "fem-full", "--spacing 12.5mm"},
      {"damped", settling, "sph-classic-share", "--spacing 12.5mm --viscosity 1,1,0.01"},
      {"damped", settling, "sph-virtual", "--spacing 12.5mm"},
      {"damped", settling, "sph-weight", "--spacing 12.5mm"},
      {"kinetic", settling, "sph-corrected", "--spacing 12.5mm"},
      {"kinetic", settling, "fem-one-point", "--spacing 12.5mm"},
      {"bonded", bonded, "fem-full", "--spacing 5mm"},
      {"bonded", bonded, "sph-corrected", "--spacing 5mm"},
      {"hot", hot, "fem-one-point", "--spacing 5mm"},
      {"hot", hot, "sph-corrected", "--spacing 5mm"},
      {"meshed", meshed, "fem-full", ""},
      {"meshed", meshed, "sph-corrected", "--spacing 125mm"},
      {"ball", ball, "fem-assumed-strain", "--spacing 2mm"},
      {"ball", ball, "sph-corrected", "--spacing 2mm"},
      {"solid", solid, "fem-full", "--spacing 5mm"},
      {"solid", solid, "fem-assumed-strain", "--spacing 5mm"},
      {"solid", solid, "sph-corrected", "--spacing 5mm"},
      {"solid", solid, "sph-classic-full", "--spacing 5mm"},
  };
  return all;
}

}  // namespace femsph::interrupted
