// `femsph run`; and how `run` and `check` read the method and the resolution from the command line.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "compare/program/commands.hpp"
#include "compare/run/plan/method_option.hpp"
#include "compare/run/run_output.hpp"
#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"
#include "model/input/toml_fields.hpp"
#include "model/input/units.hpp"
#include "model/motion/bodies/price.hpp"
#include "model/numerics/parallel.hpp"
#include "model/results/record.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {

namespace {

/// "--kernel-volume".
std::string flag_of(const MethodOption& option) {
  std::string flag = "--" + option.word;
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

double in_range(const std::string& flag, const MethodOption& option, double value) {
  if (option.range->holds(value)) return value;
  throw BadCommand(fmt::format(
      "{}{} is {:g}; expected {}", flag, flag == flag_of(option) ? "" : fmt::format(": {}", option.word),
      value, option.range->describe()));
}

void refuse_idle(const std::string& flag, const MethodOption& option, const BodyMethods& methods) {
  if (const std::string why = why_idle(methods, option); !why.empty())
    throw BadCommand(fmt::format("{} does nothing with {}: {}", flag, methods.name, why));
}

const std::string& checked_word(const MethodOption& option, const std::string& value) {
  return entry_named<BadCommand>(option.words, value, std::identity{},
                                 fmt::format("{} cannot be {}", flag_of(option), in_quotes(value)));
}

/// An option of the methods, and the flag that gave it.
using GivenOption = std::pair<const MethodOption*, std::string>;

const char* const viscosity_words[] = {"alpha", "beta", "gamma"};  // --viscosity

std::vector<GivenOption> given_options(const RunCommand& c) {
  std::vector<GivenOption> given;
  const auto note = [&](const std::string& word, const std::string& flag) {
    given.emplace_back(&method_option(word), flag.empty() ? flag_of(method_option(word)) : flag);
  };
  for (const auto& [word, value] : c.numbers)
    if (value) note(word, "");
  for (const auto& [word, value] : c.words)
    if (value) note(word, "");
  if (!c.viscosity.empty())
    for (const char* word : viscosity_words) note(word, "--viscosity");
  if (!c.projection) note("projection", "--no-projection");
  return given;
}

/// The options of the methods that the command line changes. First refuses those that would do nothing, then
/// checks their values.
Overrides overrides_of(const RunCommand& c, const BodyMethods& methods) {
  const std::vector<GivenOption> given = given_options(c);
  for (const auto& [option, flag] : given) refuse_idle(flag, *option, methods);

  Overrides read;
  for (const auto& [option, flag] : given) {
    const auto number = c.numbers.find(option->word);
    const auto word = c.words.find(option->word);
    if (number != c.numbers.end())
      read.set(option->word, in_range(flag, *option, *number->second));
    else if (word != c.words.end())
      read.set(option->word, checked_word(*option, *word->second));
    else if (option->range)
      read.set(
          option->word,
          in_range(
              flag, *option,
              c.viscosity[std::find(viscosity_words, viscosity_words + 3, option->word) - viscosity_words]));
    else
      read.set(option->word, false);
  }
  return read;
}

/// A method's full name, or "sph" or "fem".
Method solver_named(const std::string& name) {
  return method_named(name == "sph" ? "sph-corrected" : name == "fem" ? "fem-full" : name);
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

BodyMethods methods_of(const RunCommand& c, const Scene& scene) {
  try {
    BodyMethods methods = read_body_methods(c.solver, &scene, solver_named);
    overrides_of(c, methods).apply(methods);
    return methods;
  } catch (const BadCommand&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw BadCommand(std::string("--solver: ") + error.what());
  }
}

void print_partial_options(const RunCommand& c, const BodyMethods& methods) {
  std::string last;
  for (const auto& [option, flag] : given_options(c))
    if (const std::string bodies = bodies_with(methods, *option); !bodies.empty() && flag != last) {
      fmt::print(stderr, "note: {} applies to {} only\n", flag, bodies);
      last = flag;
    }
}

Resolution resolution_of(const RunCommand& c, const Scene& scene, const BodyMethods& methods) {
  Resolution r;
  if (c.spacing && !c.divisions.empty())
    throw BadCommand("both --spacing and --divisions are given; expected one of them");
  const bool own_cells = std::all_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) {
    return body.rigid || (body.shape->cells() && methods.of(body).is_fem());
  });
  if (own_cells && (c.spacing || !c.divisions.empty()))
    throw BadCommand(fmt::format(
        "{} does nothing with {}: the cells of every deformable body of {} come from its shape",
        c.spacing ? "--spacing" : "--divisions", methods.name, scene.file));
  if (!own_cells && !c.spacing && c.divisions.empty())
    throw BadCommand("no resolution is given; expected a spacing, such as --spacing \"10 mm\"");
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
  if (!c.divisions.empty()) try {
      for (const Body& body : scene.bodies)
        if (!body.rigid && !methods.of(body).is_fem()) spacing_of(*body.shape, r);
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

constexpr int not_settled = 3;  ///< exit code: the results are written, but are no static state

void print_warning(const std::string& text) { fmt::print(stderr, "warning: {}\n", text); }

/// The scene of a checkpoint: its text is in the checkpoint, mesh files are read again.
Scene scene_again(const RunOrigin& origin) {
  Scene scene = parse_scene(origin.scene_text, origin.scene_path);
  scene.file = origin.scene_file;
  return scene;
}

/// A run writes scene.toml into its folder. It must not overwrite a file that is not from an earlier run.
void refuse_foreign(const std::string& folder, const Scene& scene) {
  const std::string file = folder + "/scene.toml";
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) || has_record(folder) ||
      read_text_file(file, "a scene", Length::any) == scene.text)
    return;
  throw BadCommand(fmt::format(
      "--out {}: it holds a scene.toml that is not from a run, and this run would "
      "overwrite it; expected another folder",
      in_quotes(folder)));
}

int run_command(const RunCommand& command) {
  const MarchOptions march{checked_safety(command.safety), {}};
  set_threads(checked_threads(command.threads));
  const CheckpointOptions checkpoints = checkpoint_of(command);
  const Scene scene = command.from ? scene_again(command.from->origin()) : read_scene(command.scene);
  const BodyMethods methods = methods_of(command, scene);
  const Resolution resolution = resolution_of(command, scene, methods);
  std::error_code failure;
  std::filesystem::create_directories(command.out, failure);
  if (failure)
    throw std::runtime_error(fmt::format("cannot create the folder {}: {}", command.out, failure.message()));
  if (!command.from) refuse_foreign(command.out, scene);
  RunOptions options;
  options.march = march;
  options.folder = command.out;
  options.fields = command.fields;
  options.command = command.command;
  options.checkpoint = checkpoints;
  options.warn = print_warning;
  print_partial_options(command, methods);
  const RunResult r = run_scene(scene, methods, resolution, options);

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
  fmt::print("{}", price_text(r.price, methods.unit_name()));
  fmt::print("results in {}\n", command.out);
  return scene.settling && !r.settled ? not_settled : 0;
}

std::string version_text() {
  std::string text = version_line();
  for (const auto& [key, value] : provenance()) text += fmt::format("\n  {:<12} {}", key, value);
  return text;
}

}  // namespace femsph::compare
