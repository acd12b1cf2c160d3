// Where the time of a whole run goes.

#include <fmt/format.h>

#include <filesystem>

#include "model/numerics/parallel.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/report.hpp"

namespace femsph::bench {

std::string profile(int steps) {
  set_threads(1);
  std::string text = fmt::format("{} steps, 400 samples, 20 snapshots; shares of the wall time.\n\n", steps);
  const std::vector<std::string> phases{
      "setup", "critical step", "neighbour search", "watch", "sampling", "fields"};
  text += "| method | units | seconds | ns a unit and step |";
  for (const std::string& p : phases) text += " " + p + " |";
  text += "\n|---|---:|---:|---:|";
  for (std::size_t k = 0; k < phases.size(); ++k) text += "---:|";
  text += "\n";
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       fmt::format("femsph-bench-{}", ::getpid());
  for (const char* name :
       {"fem-full", "fem-one-point", "fem-assumed-strain", "sph-corrected", "sph-classic-share"}) {
    const Case c{name, 2, compare::method_named(name)};
    double spacing = 0;
    Scene scene = scene_of(c, spacing);
    scene.samples = 400;
    scene.snapshots = 20;
    scene.probes.push_back({"tip", 0, quantity_named("displacement"), {1, 0.05, 0}});
    scene.probes.push_back({"root", 0, quantity_named("stress"), {0.05, 0.05, 0}});
    scene.duration = 1e-12;
    const double dt = compare::run_scene(scene, c.method, {spacing, {}}, {}).price.dt;
    scene.duration = steps * dt;
    compare::RunOptions options;
    options.folder = folder.string();
    const Price price = compare::run_scene(scene, c.method, {spacing, {}}, options).price;
    const auto share = [&](const std::string& phase) {
      for (const auto& [key, seconds] : price.phases)
        if (key == phase) return seconds;
      return 0.0;
    };
    const double whole = price.wall + share("setup") + share("critical step");
    text += fmt::format("| {} | {} | {:.1f} | {:.3g} |", name, price.units, whole,
                        1e9 * price.cpu / double(price.steps) / double(price.units));
    for (const std::string& p : phases)
      text += share(p) > 0 ? fmt::format(" {:.1f} % |", 100 * share(p) / whole) : " |";
    text += "\n";
  }
  std::filesystem::remove_all(folder);
  return text;
}

}  // namespace femsph::bench
