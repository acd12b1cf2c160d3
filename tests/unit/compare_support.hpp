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
#include "tests/scene_text.hpp"

namespace femsph::compare::test {

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
inline const std::string cantilever_toml =
    scene_text::clamped_beam("1000 100 mm", "100 mm") + scene_text::load("x+ y+", "0 -25 kN") +
    scene_text::probe("tip", "displacement", "1000 50 mm") +
    scene_text::section("inner", "stress", "100 0 mm", "100 100 mm") + scene_text::settling("damping") +
    scene_text::time("50 ms");

/// A [[quantities]] table of a study that reads probe "tip", in mm.
inline std::string tip_quantity(const std::string& name, const std::string& more = "") {
  return fmt::format(
      "[[quantities]]\nname = \"{}\"\nprobe = \"tip\"\ncomponent = \"y\"\nunit = \"mm\"\n{}", name, more);
}
inline const std::string cantilever_tip = "theory = \"cantilever_tip\"\n", reversed = "sign = \"reversed\"\n";
/// A [[quantities]] table that reads stress xx in section "inner".
inline std::string inner_quantity(const std::string& name, const std::string& more) {
  return fmt::format(
      "[[quantities]]\nname = \"{}\"\nsection = \"inner\"\ncomponent = \"xx\"\n{}", name, more);
}

/// A [[claims]] table: the error of fem-full is below 10 %.
inline std::string below_claim(const std::string& case_name, const std::string& quantity) {
  return fmt::format(
      "[[claims]]\nid = \"c\"\nsource = \"fig 1\"\ntext = \"it bends\"\nkind = \"below\"\n"
      "rows = {{cases = [\"{}\"], method = \"fem-full\", quantity = \"{}\"}}\nbound = 10\n",
      case_name, quantity);
}

/// What `act` throws; empty if it throws nothing.
template <class Act>
std::string message_of(Act act) {
  try {
    act();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

}  // namespace femsph::compare::test
