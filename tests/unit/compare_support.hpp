#pragma once
// Scenes and results made by hand for the tests of compare/.

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "compare/run/run.hpp"
#include "model/scene/shapes/box.hpp"

namespace femsph::compare::testing {

/// The steel box of the paper, clamped on x-, with a force on x+. Sizes in m, 2D unless depth is given.
inline Scene steel_box(double length, double height, Point force, double depth = 0) {
  Scene scene;
  scene.plane = depth > 0 ? Plane::none : Plane::stress;
  scene.materials["steel"] = {"steel", 2.1e11, 0.3, 7850};
  Body body{"box", std::make_shared<Box>(depth > 0 ? 3 : 2, Point{0, 0, 0}, Point{length, height, depth}),
            0.1, "steel"};
  scene.bodies.push_back(body);
  scene.supports.push_back({Place{0, {"x-"}, {}, {}}, {true, true, depth > 0}});
  scene.loads.push_back({Place{0, {"x+"}, {}, {}}, force, {}});
  scene.duration = 0.05;
  return scene;
}

/// 300 x 100 x 100 mm under 1.5 kN of compression.
inline Scene bar() { return steel_box(0.3, 0.1, {-1500, 0, 0}); }
/// 1000 x 100 x 100 mm under 25 kN downwards.
inline Scene cantilever() { return steel_box(1.0, 0.1, {0, -25e3, 0}); }

/// A folder for one test, removed with it.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("femsph-" + name + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// What a run gives whose tip goes to `tip` and whose section bears `fibre` at its upper end, linearly.
inline RunResult result(double tip, double fibre, double spacing) {
  RunResult r;
  r.history.columns = {
      {"time", "s", {0, 0.01, 0.02}}, {"tip_y", "m", {0, 1.5 * tip, tip}}, {"kinetic", "J", {0, 2, 1}}};
  Profile profile{"inner", 0.02, {0, 0.05, 0.1}, {{"xx", "Pa", {-fibre, 0, fibre}}}};
  r.profiles["inner"] = profile;
  r.spacing = spacing;
  r.cells_over_height = int(std::lround(0.1 / spacing));
  r.points = 42;
  r.settled = true;
  r.price.steps = 1000;
  r.price.dt = 1e-6;
  r.price.cpu = 0.5;
  r.price.units = 100;
  r.ledger.external = 10;
  r.ledger.strain = 9.9;
  return r;
}

/// The scene file of the cantilever, with a probe "tip" and a section "inner".
inline const char* const cantilever_toml = R"(
[model]
plane = "stress"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
[bodies.beam]
shape = "box"
size = ["1000 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[[supports]]
at = "x-"
fix = ["x", "y"]
[[loads]]
at = "x+ y+"
force = ["0 kN", "-25 kN"]
[[probes]]
name = "tip"
quantity = "displacement"
point = ["1000 mm", "50 mm"]
[[sections]]
name = "inner"
quantity = "stress"
from = ["100 mm", "0 mm"]
to = ["100 mm", "100 mm"]
[settling]
method = "damping"
[time]
duration = "50 ms"
)";

}  // namespace femsph::compare::testing
