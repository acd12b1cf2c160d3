#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "compare/program/commands.hpp"
#include "compare/run/plan/overrides.hpp"
#include "compare/run/run_output.hpp"
#include "model/input/faults.hpp"
#include "model/input/toml_fields.hpp"
#include "model/input/units.hpp"
#include "model/motion/price.hpp"
#include "model/numerics/parallel.hpp"
#include "model/results/record.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {

namespace {

template <class T>
T word(const std::string& option, const std::string& value,
       const std::vector<std::pair<std::string, T>>& words) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : words) {
    if (name == value) return meaning;
    names.push_back(name);
  }
  throw BadCommand(fmt::format(
      "{} cannot be {}; expected {}{}", option, in_quotes(value), one_of(names), did_you_mean(value, names)));
}

double in_range(const std::string& option, const char* name, double value) {
  const OptionRange& range = option_range(name);
  if (range.holds(value)) return value;
  throw BadCommand(fmt::format(
      "{}{} is {:g}; expected {}", option, option.ends_with(name) ? "" : fmt::format(": {}", name), value,
      range.describe()));
}

void refuse_idle(const RunCommand& c, const Method& method) {
  const auto refuse = [&](bool given, const std::string& option) {
    if (const std::string why = why_idle(method, option); given && !why.empty())
      throw BadCommand(fmt::format("--{} does nothing with {}: {}",
                                   option == "kernel_volume" ? "kernel-volume" : option, method.name, why));
  };
  refuse(c.smoothing.has_value(), "smoothing");
  refuse(c.kernel.has_value(), "kernel");
  refuse(c.mass.has_value(), "mass");
  refuse(c.kernel_volume.has_value(), "kernel_volume");
  refuse(c.dilatation.has_value(), "dilatation");
  refuse(!c.viscosity.empty(), "viscosity");
  refuse(c.hourglass.has_value(), "hourglass");
  if (const std::string why = why_idle(method, "projection"); !c.projection && !why.empty())
    throw BadCommand(fmt::format("--no-projection does nothing with {}: {}", method.name, why));
}

void set_sph_options(sph::Options& o, const RunCommand& c) {
  if (c.smoothing) o.smoothing = in_range("--smoothing", "smoothing", *c.smoothing);
  if (c.kernel) o.kernel = word("--kernel", *c.kernel, kernel_words);
  if (c.mass) o.mass = word("--mass", *c.mass, mass_words);
  if (c.kernel_volume) o.kernel_volume = word("--kernel-volume", *c.kernel_volume, kernel_volume_words);
  if (c.dilatation) o.dilatation = word("--dilatation", *c.dilatation, dilatation_words);
  if (!c.viscosity.empty())
    o.viscosity = {
        in_range("--viscosity", "alpha", c.viscosity[0]), in_range("--viscosity", "beta", c.viscosity[1]),
        in_range("--viscosity", "gamma", c.viscosity[2])};
  if (c.hourglass) o.hourglass = in_range("--hourglass", "hourglass", *c.hourglass);
  o.projection = c.projection;
}

}  // namespace

int checked_threads(int threads) {
  if (threads < 1 || threads > most_threads)
    throw BadCommand(
        fmt::format("--threads is {}; expected a whole number from 1 to {}", threads, most_threads));
  return threads;
}

double checked_safety(double safety) {
  if (!(safety > 0 && safety <= 1))
    throw BadCommand(fmt::format(
        "--safety is {:g}; expected a number above 0, up to 1: the step over the critical step", safety));
  return safety;
}

Method method_of(const RunCommand& c) {
  Method m;
  try {
    m = method_named(c.solver == "sph" ? "sph-corrected" : c.solver == "fem" ? "fem-full" : c.solver);
  } catch (const std::runtime_error& error) {
    throw BadCommand(std::string("--solver: ") + error.what());
  }
  refuse_idle(c, m);
  if (!m.is_fem())
    set_sph_options(std::get<sph::Options>(m.options), c);
  else if (c.hourglass)
    std::get<fem::Options>(m.options).hourglass = in_range("--hourglass", "hourglass", *c.hourglass);
  return m;
}

Resolution resolution_of(const RunCommand& c, const Scene& scene, const Method& method) {
  Resolution r;
  if (c.spacing && !c.divisions.empty())
    throw BadCommand("--spacing and --divisions both say how fine; give one of them");
  const bool own_cells = method.is_fem() &&
                         std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                     [](const Body& body) { return body.rigid || body.shape->cells(); });
  if (own_cells && (c.spacing || !c.divisions.empty()))
    throw BadCommand(fmt::format(
        "{} does nothing with {}: every body of {} that deforms brings its own cells",
        c.spacing ? "--spacing" : "--divisions", method.name, scene.file));
  if (!own_cells && !c.spacing && c.divisions.empty())
    throw BadCommand("how fine? give a spacing, such as --spacing \"10 mm\"");
  if (c.spacing) {
    try {
      r.spacing = to_si(*c.spacing, dimension::length);
    } catch (const std::exception& error) {
      throw BadCommand(fmt::format("--spacing {}: {}", in_quotes(*c.spacing), error.what()));
    }
    if (!(r.spacing > 0))
      throw BadCommand(fmt::format(
          "--spacing {}: expected a length above zero, such as \"10 mm\"", in_quotes(*c.spacing)));
  }
  if (!c.divisions.empty() && int(c.divisions.size()) != scene.dim())
    throw BadCommand(fmt::format(
        "--divisions: {} number{}; expected {}, one along each axis of {}, such as {}", c.divisions.size(),
        c.divisions.size() == 1 ? "" : "s", scene.dim(), scene.file,
        scene.dim() == 2 ? "100,10" : "100,10,10"));
  for (std::size_t a = 0; a < c.divisions.size(); ++a) {
    if (c.divisions[a] < 1 || c.divisions[a] > most_divisions)
      throw BadCommand(fmt::format("--divisions: {}; expected whole numbers from 1 to {}, such as 100,10",
                                   c.divisions[a], most_divisions));
    r.divisions[a] = c.divisions[a];
  }
  if (!c.divisions.empty() && !method.is_fem()) try {
      for (const Body& body : scene.bodies)
        if (!body.rigid) spacing_of(*body.shape, r);
    } catch (const Refusal& refusal) {
      throw BadCommand(std::string("--divisions: ") + refusal.what());
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
    throw BadCommand(fmt::format(
        "--checkpoint {}: expected a number of steps, such as 1000, or a time on the clock, such "
        "as \"10 min\"",
        in_quotes(*c.checkpoint)));
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

/// A run writes its scene beside its results; a scene.toml that no run has put there is somebody's own.
void refuse_foreign(const std::string& folder, const Scene& scene) {
  const std::string file = folder + "/scene.toml";
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) || has_record(folder) ||
      read_text_file(file, "a scene", Length::any) == scene.text)
    return;
  throw BadCommand(fmt::format(
      "--out {}: there is a scene.toml that no run has put there, and this run would write its "
      "own over it; give another folder",
      in_quotes(folder)));
}

int run_command(const RunCommand& command) {
  const MarchOptions march{checked_safety(command.safety), {}};
  set_threads(checked_threads(command.threads));
  const CheckpointOptions checkpoints = checkpoint_of(command);
  const Scene scene = command.from ? scene_again(command.from->origin()) : read_scene(command.scene);
  const Method method = method_of(command);
  const Resolution resolution = resolution_of(command, scene, method);
  std::error_code failure;
  std::filesystem::create_directories(command.out, failure);
  if (failure)
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", command.out, failure.message()));
  if (!command.from) refuse_foreign(command.out, scene);
  RunOptions options;
  options.march = march;
  options.folder = command.out;
  options.fields = command.fields;
  options.command = command.command;
  options.checkpoint = checkpoints;
  options.warn = print_warning;
  const RunResult r = run_scene(scene, method, resolution, options);

  fmt::print("{}\n", scene.title);
  for (const auto& [key, value] : r.derived) fmt::print("  {:<24} {}\n", key, value);
  fmt::print("  {:<24} {}\n", "outcome",
             r.settled        ? "settled"
             : scene.settling ? "NOT SETTLED within the duration: no static state"
                              : "finished");
  for (const Column& column : r.history.columns)
    fmt::print(
        "  {:<24} {:.6g} {}\n", column.name, column.values.back(), column.unit == "1" ? "" : column.unit);
  const double scale = std::max(std::abs(r.ledger.external) + r.ledger.initial, 1e-300);
  fmt::print("  {:<24} {:.2e} of the energy supplied; linear momentum {:.1e}, angular {:.1e}\n", "imbalance",
             std::abs(r.ledger.imbalance()) / scale, r.momentum_error, r.moment_error);
  fmt::print(
      "  {:<24} {:.1e} of the forces, {:.1e} of their moments: loads + reactions - inertia, at worst\n",
      "balance", r.balance.force, r.balance.moment);
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
