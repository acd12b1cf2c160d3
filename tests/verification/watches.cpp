// Bodies that fail, by every method: the watch that stops the run, where, and the last good state on disk.
// And the estimate of memory.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "compare/run/capacity.hpp"
#include "compare/run/run.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/unit/model_results_hdf5.hpp"

namespace femsph::compare {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// A rubber-like block 100 x 100 mm, held at x-, with a load that it cannot bear.
Scene block(const char* at, const char* force, const char* plane = "stress") {
  const bool solid = std::string(plane) == "none";
  return parse_scene(fmt::format(R"(
[model]
plane = "{}"
motion = "large"
[materials.soft]
law = "elastic"
young = "10 MPa"
poisson = 0.3
density = "1000 kg/m^3"
[bodies.block]
shape = "box"
size = ["100 mm", "100 mm"{}]
material = "soft"
{}
[[supports]]
at = "x-"
fix = ["x", "y"{}]
[[loads]]
at = "{}"
force = [{}{}]
[time]
duration = "60 ms"
samples = 20
snapshots = 3
)",
                                 plane, solid ? ", \"100 mm\"" : "", solid ? "" : "thickness = \"100 mm\"",
                                 solid ? ", \"z\"" : "", at, force, solid ? ", \"0 N\"" : ""),
                     "block.toml");
}

struct Folder {
  fs::path path = fs::temp_directory_path() / ("femsph-watches-" + std::to_string(getpid()));
  Folder() { fs::remove_all(path), fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Runs into `folder` until a watch stops it.
Stopped stopped(const Scene& scene, const char* method, double spacing, const fs::path& folder) {
  set_threads(1);
  RunOptions options;
  options.folder = folder;
  try {
    run_scene(scene, method_named(method), {spacing, {}}, options);
  } catch (const Stopped& stop) {
    EXPECT_THAT(text_of(folder / "record.toml"), HasSubstr("stopped at step"));
    EXPECT_TRUE(fs::exists(folder / "history.csv"));
    return stop;
  }
  ADD_FAILURE() << method << " was not stopped";
  return {Stopped::Watch::not_a_number, ""};
}

TEST(Watches, ACornerPushedThroughTurnsUnitsInsideOut) {
  for (const char* plane : {"stress", "none"})
    for (const char* method :
         {"fem-full", "fem-sri", "fem-one-point", "fem-assumed-strain", "sph-corrected"}) {
      SCOPED_TRACE(std::string(method) + " " + plane);
      const Folder out;
      const Stopped stop = stopped(
          block("x+ y+",
                *plane == 'n' ? *method == 's' ? "\"-12 kN\", \"-12 kN\"" : "\"-8 kN\", \"-8 kN\""
                              : "\"-15 kN\", \"-15 kN\"",
                plane),
          method, 0.02, out.path);
      EXPECT_EQ(stop.watch, Stopped::Watch::unit) << stop.what();
      EXPECT_THAT(stop.what(), AllOf(HasSubstr("turned inside out"), HasSubstr("body \"block\", at ("),
                                     HasSubstr("try "), HasSubstr("last_good.xdmf")));
      const std::string described = text_of(out.path / "last_good.xdmf");
      EXPECT_THAT(described,
                  AllOf(HasSubstr("last good state, step "),
                        HasSubstr("fields/last_good.h5:/body0/displacement"), HasSubstr("fields/bodies.h5")));
      EXPECT_TRUE(fs::exists(out.path / "fields/last_good.h5"));
      EXPECT_TRUE(fs::exists(out.path / "fields/bodies.h5"));
    }
}

/// Displacement and velocity of every point as fields hold them, three components a point, of a march that
/// goes to `step` by itself and stops there.
std::array<std::vector<double>, 2> state_at(const Scene& scene, const char* method, double spacing,
                                            long step) {
  struct Reached {};
  std::vector<std::unique_ptr<Discretization>> bodies;
  bodies.push_back(discretize(scene, 0, method_named(method), {spacing, {}}));
  March march(scene, std::move(bodies), {});
  std::array<std::vector<double>, 2> found;
  MarchEvents events;
  events.between = [&](March& m) {
    if (m.step() != step) return;
    const MovingBody& body = m.bodies()[0];
    const Layout& at = body.discretization->layout();
    for (std::size_t i = 0; i < at.points; ++i)
      for (int c = 0; c < 3; ++c) {
        found[0].push_back(c < at.dim ? body.u[at.at(i, c)] : 0);
        found[1].push_back(c < at.dim ? body.v[at.at(i, c)] : 0);
      }
    throw Reached();
  };
  try {
    march.run(events);
  } catch (const Reached&) {
  }
  return found;
}

TEST(Watches, TheLastGoodStateIsThatOfTheStepThatTheMessageNames) {
  for (const char* plane : {"stress", "none"})
    for (const char* method : {"fem-full", "fem-assumed-strain", "sph-corrected"}) {
      SCOPED_TRACE(std::string(method) + " " + plane);
      const Folder out;
      Scene scene = block(
          "x+ y+", *plane == 'n' ? "\"-18 kN\", \"-18 kN\"" : "\"-15 kN\", \"-15 kN\"", plane);
      scene.duration = 0.6;  // slowly, so that more than one look finds all well
      scene.loads[0].history = {{0, 0.6}, {0, 1}};
      const std::string said = stopped(scene, method, 0.02, out.path).what();
      std::smatch found;
      ASSERT_TRUE(std::regex_search(
          said, found, std::regex("stopped at step (\\d+).*the last good state \\(step (\\d+), t = ")))
          << said;
      const long step = std::stol(found[2]);
      EXPECT_GT(step, 0);
      EXPECT_LT(step, std::stol(found[1]));
      EXPECT_THAT(
          text_of(out.path / "last_good.xdmf"), HasSubstr(fmt::format("last good state, step {}", step)));
      const auto expected = state_at(scene, method, 0.02, step);
      ASSERT_FALSE(expected[0].empty());
      const std::string file = (out.path / "fields/last_good.h5").string();
      EXPECT_EQ(test::read_hdf5(file, "/body0/displacement").values, expected[0]);
      EXPECT_EQ(test::read_hdf5(file, "/body0/velocity").values, expected[1]);
    }
}

TEST(Watches, ClassicParticlesThatArePulledApartLoseTheirNeighbours) {
  const Folder out;
  const Stopped stop = stopped(block("x+", "\"200 kN\", \"0 N\""), "sph-classic-share", 0.02, out.path);
  EXPECT_EQ(stop.watch, Stopped::Watch::unit) << stop.what();
  EXPECT_THAT(stop.what(), AllOf(HasSubstr("lost its neighbours"), HasSubstr("last_good.xdmf")));
}

TEST(Capacity, TheEstimateIsRefusedWithASpacingThatFits) {
  const Scene scene = block("x+", "\"1 N\", \"0 N\"", "none");
  for (const char* name : {"fem-full", "sph-corrected", "sph-classic-share"}) {
    SCOPED_TRACE(name);
    const Method method = method_named(name);
    const Size size = estimated_size(scene, method, {1e-3, {}});
    EXPECT_NEAR(size.units, method.is_fem() ? 1e6 : 1.03e6, 1e4);
    EXPECT_NO_THROW(refuse_excess(scene, method, {1e-3, {}}, 1.01 * size.bytes));
    std::string said;
    try {
      refuse_excess(scene, method, {1e-5, {}}, 16e9);
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    EXPECT_THAT(said, AllOf(HasSubstr("this spacing gives about 1e+12"),
                            HasSubstr(" PB of memory; 16 GB are available; use a spacing of at least ")));
    double advised = 0;
    ASSERT_EQ(std::sscanf(said.substr(said.find("at least ")).c_str(), "at least %lf mm", &advised), 1)
        << said;
    EXPECT_NO_THROW(refuse_excess(scene, method, {1e-3 * advised, {}}, 16e9));
    EXPECT_THROW(refuse_excess(scene, method, {0.9e-3 * advised, {}}, 16e9), std::runtime_error);
  }
  EXPECT_THROW(refuse_excess(scene, method_named("fem-full"), {0, {100000, 100000, 100000}}, 16e9),
               std::runtime_error);
  EXPECT_NO_THROW(refuse_excess(scene, method_named("fem-full"), {0, {10, 10, 10}}, 16e9));
}

TEST(Capacity, SomethingIsAvailable) {
  EXPECT_GT(available_memory(), 1e7);
  EXPECT_LT(available_memory(), 1e16);
}

}  // namespace
}  // namespace femsph::compare
