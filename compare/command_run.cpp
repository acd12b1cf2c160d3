#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "compare/commands.hpp"
#include "model/numerics/parallel.hpp"
#include "model/results/price.hpp"
#include "model/results/record.hpp"
#include "model/scene/faults.hpp"
#include "model/scene/reader.hpp"
#include "model/scene/units.hpp"

namespace femsph::compare {

namespace {

template <class T>
T word(const std::string& option, const std::string& value, const std::vector<std::pair<std::string, T>>& words) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : words) {
    if (name == value) return meaning;
    names.push_back(name);
  }
  throw std::runtime_error(fmt::format("{} cannot be {}; expected {}{}", option, in_quotes(value), one_of(names), did_you_mean(value, names)));
}

void set_sph_options(sph::Options& o, const RunCommand& c) {
  if (c.smoothing) o.smoothing = *c.smoothing;
  if (c.kernel)
    o.kernel = word<sph::KernelKind>("--kernel", *c.kernel, {{"cubic-spline", sph::KernelKind::cubic_spline}, {"wendland-c2", sph::KernelKind::wendland_c2}});
  if (c.mass)
    o.mass = word<sph::MassRule>("--mass", *c.mass, {{"share", sph::MassRule::share}, {"full", sph::MassRule::full}, {"trapezoid", sph::MassRule::trapezoid}});
  if (!c.viscosity.empty()) o.viscosity = {c.viscosity[0], c.viscosity[1], c.viscosity[2]};
  if (c.hourglass) o.hourglass = *c.hourglass;
}

void refuse_sph_options(const RunCommand& c) {
  const auto refuse = [&](bool given, const char* option) {
    if (given) throw std::runtime_error(fmt::format("{} is an option of SPH; {} takes none", option, c.solver));
  };
  refuse(c.smoothing.has_value(), "--smoothing");
  refuse(c.kernel.has_value(), "--kernel");
  refuse(c.mass.has_value(), "--mass");
  refuse(!c.viscosity.empty(), "--viscosity");
}

}  // namespace

Method method_of(const RunCommand& c) {
  Method m = method_named(c.solver == "sph" ? "sph-corrected" : c.solver == "fem" ? "fem-full" : c.solver);
  if (m.is_fem()) {
    refuse_sph_options(c);
    if (c.hourglass) std::get<fem::Options>(m.options).hourglass = *c.hourglass;
  } else {
    set_sph_options(std::get<sph::Options>(m.options), c);
  }
  return m;
}

Resolution resolution_of(const RunCommand& c) {
  Resolution r;
  if (c.spacing && !c.divisions.empty()) throw std::runtime_error("--spacing and --divisions both say how fine; give one of them");
  if (c.spacing) {
    try {
      r.spacing = to_si(*c.spacing, dimension::length);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("--spacing {}: {}", in_quotes(*c.spacing), error.what()));
    }
    if (!(r.spacing > 0)) throw std::runtime_error(fmt::format("--spacing {}: expected a length above zero, such as \"10 mm\"", in_quotes(*c.spacing)));
  }
  for (std::size_t a = 0; a < c.divisions.size(); ++a) {
    if (c.divisions[a] < 1) throw std::runtime_error("--divisions: expected whole numbers above zero, such as 100,10");
    r.divisions[a] = c.divisions[a];
  }
  return r;
}

CheckpointOptions checkpoint_of(const RunCommand& c) {
  CheckpointOptions options{0, 0, c.arguments, c.from};
  if (!c.checkpoint) return options;
  try {
    std::size_t end = 0;
    options.every_steps = std::stol(*c.checkpoint, &end);
    if (end == c.checkpoint->size() && options.every_steps > 0) return options;
    options.every_steps = 0;
  } catch (const std::exception&) {
  }
  try {
    options.every_seconds = to_si(*c.checkpoint, dimension::time);
  } catch (const std::exception&) {
  }
  if (!(options.every_seconds > 0))
    throw std::runtime_error(fmt::format("--checkpoint {}: expected a number of steps, such as 1000, or a time on the clock, such as \"10 min\"", in_quotes(*c.checkpoint)));
  return options;
}

constexpr int not_settled = 3;  ///< exit code: the results are there and are no static state

void print_warning(const std::string& text) { fmt::print(stderr, "warning: {}\n", text); }

/// The scene of a checkpoint: its own text; mesh files from where they were.
Scene scene_again(const RunOrigin& origin) {
  Scene scene = parse_scene(origin.scene_text, origin.scene_path);
  scene.file = origin.scene_file;
  return scene;
}

int run_command(const RunCommand& command) {
  set_threads(command.threads);
  const Scene scene = command.from ? scene_again(command.from->origin()) : read_scene(command.scene);
  const Method method = method_of(command);
  const Resolution resolution = resolution_of(command);
  std::error_code failure;
  std::filesystem::create_directories(command.out, failure);
  if (failure) throw std::runtime_error(fmt::format("cannot make the folder {}: {}", command.out, failure.message()));
  RunOptions options;
  options.march.safety = command.safety;
  options.folder = command.out;
  options.fields = command.fields;
  options.command = command.command;
  options.checkpoint = checkpoint_of(command);
  options.warn = print_warning;
  const RunResult r = run_scene(scene, method, resolution, options);

  fmt::print("{}\n", scene.title);
  for (const auto& [key, value] : r.derived) fmt::print("  {:<24} {}\n", key, value);
  fmt::print("  {:<24} {}\n", "outcome", r.settled ? "settled" : scene.settling ? "NOT SETTLED within the duration: no static state" : "finished");
  for (const Column& column : r.history.columns)
    fmt::print("  {:<24} {:.6g} {}\n", column.name, column.values.back(), column.unit == "1" ? "" : column.unit);
  const double scale = std::max(std::abs(r.ledger.external) + r.ledger.initial, 1e-300);
  fmt::print("  {:<24} {:.2e} of the energy supplied; linear momentum {:.1e}, angular {:.1e}\n", "imbalance", std::abs(r.ledger.imbalance()) / scale,
             r.momentum_error, r.moment_error);
  fmt::print("  {:<24} {:.1e} of the forces, {:.1e} of their moments: loads + reactions - inertia, at worst\n", "balance", r.balance.force, r.balance.moment);
  fmt::print("{}", price_text(r.price, method.is_fem() ? "element" : "particle"));
  fmt::print("results in {}\n", command.out);
  return scene.settling && !r.settled ? not_settled : 0;
}

std::string version_text() {
  std::string text = version_line();
  for (const auto& [key, value] : provenance()) text += fmt::format("\n  {:<12} {}", key, value);
  return text;
}

}  // namespace femsph::compare
