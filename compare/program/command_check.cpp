// `femsph check`: prints a scene and, with a method, its discretization, without running it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/program/commands.hpp"
#include "compare/run/capacity.hpp"
#include "model/motion/bodies/mass_properties.hpp"
#include "model/motion/bodies/price.hpp"
#include "model/motion/effects/catalogue.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {

namespace {

void print_scene(const Scene& scene) {
  const auto line = [](const std::string& key, const std::string& value) {
    fmt::print("  {:<24} {}\n", key, value);
  };
  fmt::print("{}: {}\n", scene.file, scene.title);
  line("plane", scene.plane == Plane::stress   ? "plane stress"
                : scene.plane == Plane::strain ? "plane strain"
                                               : "none: three-dimensional");
  for (const Body& body : scene.bodies) {
    if (body.rigid) {
      line("body " + body.name, fmt::format("rigid {}", body.shape->describe()));
      line("mass of " + body.name,
           to_text(mass_of(scene, std::size_t(&body - scene.bodies.data())), scene.dim()));
      continue;
    }
    const Material& m = scene.material_of(body);
    line("body " + body.name,
         m.is_fluid() ? fmt::format("{}, {} (rho {:g} kg/m3)", body.shape->describe(), m.name, m.density)
                      : fmt::format("{}, {} (E {:.4g} GPa, nu {:g}, rho {:g} kg/m3)", body.shape->describe(),
                                    m.name, m.young / 1e9, m.poisson, m.density));
    line("mass of " + body.name,
         to_text(mass_of(scene, std::size_t(&body - scene.bodies.data())), scene.dim()));
  }
  line("supports, loads", fmt::format("{}, {}", scene.supports.size(), scene.loads.size()));
  line("probes, sections", fmt::format("{}, {}", scene.probes.size(), scene.sections.size()));
  line("duration",
       fmt::format("{:g} ms{}", scene.duration * 1e3, scene.settling ? " at most: until settled" : ""));
}

std::string effects_line(const std::vector<std::string>& on) {
  std::string text;
  for (const std::string& e : on) text += (text.empty() ? "" : ", ") + e;
  return text.empty() ? "none" : text;
}

/// CPU seconds of one step, measured over some tenths of a second.
double seconds_per_step(const Scene& scene, const BodyMethods& methods, const Resolution& resolution,
                        const MarchOptions& options, double step, std::size_t units) {
  const double steps = std::clamp(2e7 / double(units), 20.0, 2000.0);
  Scene brief = scene;
  brief.duration = steps * step;
  brief.samples = 1;
  brief.snapshots = 0;
  RunOptions quiet;
  quiet.march = options;
  const RunResult r = run_scene(brief, methods, resolution, quiet);
  return r.price.cpu / double(std::max(1L, r.price.steps));
}

}  // namespace

int check_command(const RunCommand& command) {
  set_threads(checked_threads(command.threads));
  checked_safety(command.safety);
  const Scene scene = read_scene(command.scene);
  print_scene(scene);
  fmt::print("  {:<24} {}\n", "effects on", effects_line(effects_on(scene)));
  fmt::print("  {:<24} {}\n", "effects off", effects_line(effects_off(scene)));
  if (command.solver.empty()) {
    for (const std::string& text : scene.warnings) print_warning(text);
    fmt::print("add --solver and --spacing to see particles or elements, critical step, memory and time\n");
    return 0;
  }
  const BodyMethods methods = methods_of(command, scene);
  const Resolution resolution = resolution_of(command, scene, methods);
  print_partial_options(command, methods);
  refuse_excess(scene, methods, resolution);
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].rigid) bodies.push_back(discretize(scene, b, methods, resolution));
  MarchOptions options;
  options.safety = command.safety;
  const March march(scene, std::move(bodies), options);
  for (const std::string& text : march.warnings()) print_warning(text);
  fmt::print("with {}:\n", methods.name);
  for (const auto& [key, value] : derived_values(march, methods))
    if (key != "effects on") fmt::print("  {:<24} {}\n", key, value);
  const double each = seconds_per_step(scene, methods, resolution, options, march.dt(), march.price().units);
  fmt::print("  {:<24} {:.2g} s of CPU expected (measured: {:.3g} ns per {} and step)\n", "time",
             each * double(march.planned_steps()), 1e9 * each / double(march.price().units),
             methods.unit_name());
  return 0;
}

}  // namespace femsph::compare
