#include "compare/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/run/capacity.hpp"
#include "compare/run/run_output.hpp"
#include "model/motion/bodies/mass_properties.hpp"
#include "model/motion/conservation.hpp"
#include "model/motion/effects/catalogue.hpp"

namespace femsph::compare {

namespace {

/// Cells along each side of the body's bounding box.
std::array<int, 3> divisions_of(const Shape& shape, const Resolution& resolution) {
  std::array<int, 3> cells{1, 1, 1};
  for (int a = 0; a < shape.dim(); ++a) {
    const double length = shape.upper()[a] - shape.lower()[a];
    const double n = resolution.divisions[a] > 0 ? resolution.divisions[a]
                                                 : std::round(length / resolution.spacing);
    if (!(n >= 1))
      throw Refusal(fmt::format("a spacing of {:g} mm does not fit a body {:g} mm long along {}",
                                resolution.spacing * 1e3, length * 1e3, "xyz"[a]));
    cells[a] = int(std::min(n, 1e9));
  }
  return cells;
}

double height_spacing(const Shape& shape, const std::array<int, 3>& cells) {
  return (shape.upper()[1] - shape.lower()[1]) / cells[1];
}

}  // namespace

double spacing_of(const Shape& shape, const Resolution& resolution) {
  if (resolution.spacing > 0) return resolution.spacing;
  const std::array<int, 3> cells = divisions_of(shape, resolution);
  const double spacing = height_spacing(shape, cells);
  for (int a = 0; a < shape.dim(); ++a)
    if (const double other = (shape.upper()[a] - shape.lower()[a]) / cells[a];
        std::abs(other - spacing) > 1e-6 * spacing)
      throw Refusal(fmt::format(
          "SPH has one spacing, and these divisions of the {} give {:g} mm along {} and {:g} mm "
          "along y; expected a spacing",
          shape.describe(), 1e3 * other, "xyz"[a], 1e3 * spacing));
  return spacing;
}

std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const BodyMethods& methods,
                                           const Resolution& resolution) {
  const Method& method = methods.of(scene.bodies[body]);
  const Shape& shape = *scene.bodies[body].shape;
  const bool own_cells = method.is_fem() && shape.cells();
  if (!own_cells && !(resolution.spacing > 0) && resolution.divisions[0] <= 0)
    throw Refusal("no resolution is given; expected a spacing, such as --spacing \"10 mm\"");
  if (method.is_fem()) {
    fem::Options options = std::get<fem::Options>(method.options);
    if (!own_cells) options.divisions = divisions_of(shape, resolution);
    return fem::discretize(scene, body, options);
  }
  sph::Options options = std::get<sph::Options>(method.options);
  options.spacing = spacing_of(shape, resolution);
  return sph::discretize(scene, body, options);
}

std::vector<std::pair<std::string, std::string>> derived_values(const March& march,
                                                                const BodyMethods& methods) {
  std::vector<std::pair<std::string, std::string>> out = describe(methods, march.scene());
  for (const MovingBody& body : march.bodies()) {
    out.emplace_back("body " + body.name, body.discretization->describe());
    out.emplace_back(body.name + " " + body.discretization->unit_name() + "s",
                     fmt::format("{}", body.discretization->units()));
    out.emplace_back(body.name + " weighs", to_text(mass_of(*body.discretization), march.scene().dim()));
    out.emplace_back(
        body.name + " should weigh", to_text(mass_of(march.scene(), body.index), march.scene().dim()));
    out.emplace_back(body.name + " wave speed", fmt::format("{:.6g} m/s", body.discretization->wave_speed()));
  }
  for (const RigidBody& body : march.rigid_bodies())
    out.emplace_back(
        "body " + body.name, fmt::format("rigid {}, {}", body.shape->describe(),
                                         to_text({body.mass, body.shape->centroid()}, march.scene().dim())));
  for (const Effect* effect : march.effects().all()) effect->describe(march.motion(), out);
  if (march.bounded_by_effects())
    out.emplace_back("contact shortens the step",
                     fmt::format("by {:.1f} %",
                                 100 * (1 - march.critical_step() / march.critical_step_without_contact())));
  out.emplace_back("critical step", fmt::format("{:.6g} s", march.critical_step()));
  out.emplace_back(
      "step",
      march.step_changes() > 0
          ? fmt::format("{:.6g} s at first, {:.6g} s at least, {:.6g} s at last: changed {} times",
                        march.price().dt, march.smallest_step(), march.dt(), march.step_changes())
          : fmt::format("{:.6g} s{}", march.dt(),
                        march.follows_deformation() ? ", smaller if the deformation requires it" : ""));
  out.emplace_back(
      "planned steps", fmt::format("{}{}", march.planned_steps(),
                                   march.scene().settling ? " at most, fewer once settled" : ""));
  out.emplace_back("memory", fmt::format("{:.3g} MB", double(march.price().bytes) / 1e6));
  const std::vector<Support> holds = march.scene().holds();
  for (std::size_t h = 0; h < holds.size(); ++h)
    if (!holds[h].name.empty()) {
      const Point x = reaction_of(march, h).centroid(march);
      out.emplace_back("support " + holds[h].name,
                       fmt::format("moments about the centroid of its place, ({:.6g}, {:.6g}, {:.6g}) m{}",
                                   x[0], x[1], x[2], march.scene().large_motion ? " now" : ""));
    }
  std::string effects;
  for (const std::string& e : effects_on(march.scene())) effects += (effects.empty() ? "" : ", ") + e;
  out.emplace_back("effects on", effects.empty() ? "none" : effects);
  return out;
}

std::vector<std::string> warnings_of(const March& march, const Recorder& recorder) {
  std::vector<std::string> all = march.warnings();
  constexpr double round_off = 1e-9;
  if (recorder.balance().force > round_off)
    all.push_back(fmt::format(
        "the forces are not in balance: the sum of inertia forces, loads and reactions is {:.2g} of the sum "
        "of "
        "their magnitudes in the worst sample; the reactions have an error of this size",
        recorder.balance().force));
  return all;
}

std::string outcome_of(const March& march) {
  return march.settled() ? "settled" : march.scene().settling ? "not settled" : "finished";
}

namespace {

/// The results of a march, at its end or where it stopped.
RunResult result_of(const March& march, const BodyMethods& methods, const Recorder& recorder,
                    const std::optional<Conservation>& conservation) {
  RunResult r;
  r.history = recorder.history();
  r.ledger = march.ledger();
  r.price = march.price();
  r.settled = march.settled();
  r.derived = derived_values(march, methods);
  r.warnings = warnings_of(march, recorder);
  r.balance = recorder.balance();
  for (const MovingBody& body : march.bodies()) r.points += body.discretization->layout().points;
  r.scalars["critical_step"] = march.critical_step();
  for (const char* name : {"mass_error", "centroid_error"}) r.scalars[name] = 0;
  for (const MovingBody& body : march.bodies()) {  // of the worst
    const MassError error = mass_error(march.scene(), body.index, *body.discretization);
    if (std::abs(error.mass) > std::abs(r.scalars["mass_error"])) r.scalars["mass_error"] = error.mass;
    r.scalars["centroid_error"] = std::max(r.scalars["centroid_error"], error.centre);
  }
  if (conservation) {
    const Drift drift = conservation->drift();
    r.scalars["energy_drift"] = drift.energy;
    r.scalars["momentum_drift"] = drift.momentum;
    r.scalars["angular_momentum_drift"] = drift.angular_momentum;
    r.scalars["hourglass_share"] = drift.hourglass;
  }
  return r;
}

bool asks_for_drift(const std::set<std::string>& scalars) {
  return std::any_of(scalars.begin(), scalars.end(),
                     [](const std::string& s) { return s.ends_with("_drift") || s == "hourglass_share"; });
}

}  // namespace

RunResult run_scene(const Scene& scene, const BodyMethods& methods, const Resolution& resolution,
                    const RunOptions& options) {
  refuse_excess(scene, methods, resolution);
  const double start = wall_seconds(), start_cpu = cpu_seconds();
  std::vector<std::unique_ptr<Discretization>> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].rigid) bodies.push_back(discretize(scene, b, methods, resolution));
  const double ready = wall_seconds();
  March march(scene, std::move(bodies), options.march);
  march.price().add("setup", ready - start);
  std::size_t reported = 0;
  const auto report_warnings = [&](const std::vector<std::string>& warnings) {
    for (; reported < warnings.size(); ++reported)
      if (options.warn) options.warn(warnings[reported]);
  };
  report_warnings(march.warnings());
  Recorder recorder(march);
  std::unique_ptr<RunOutput> output;
  if (options.folder) output = std::make_unique<RunOutput>(methods, options, march, recorder, start_cpu);
  const auto total_cpu = [&] { return cpu_seconds() - start_cpu + (output ? output->cpu_before() : 0.0); };
  std::optional<Conservation> conservation;
  if (asks_for_drift(options.scalars)) conservation.emplace(march);
  Progress progress(options.label.empty() ? methods.name : options.label);

  MarchEvents events;
  events.sample = [&](const March& m) {
    recorder.sample(m);
    if (conservation) conservation->sample(m);
  };
  if (output) events.snapshot = [&](const March&) { output->snapshot(); };
  if (output && options.checkpoint) events.between = [&](March&) { output->between(); };
  events.progress = [&](const March& m) { progress.show(m.step(), m.planned_steps(), m.time()); };
  try {
    march.run(events);
    march.price().total_cpu = total_cpu();
  } catch (const MotionError& error) {
    march.price().total_cpu = total_cpu();
    if (options.partial) *options.partial = result_of(march, methods, recorder, conservation);
    const auto* stop = dynamic_cast<const Stopped*>(&error);
    if (!output) throw;
    const std::string message = error.what() + (stop ? output->save_last_good() : "");
    output->finish(message, false);
    if (stop) throw Stopped(stop->watch, message);
    throw;
  } catch (const std::exception& error) {
    if (output) output->try_to_finish(error.what());
    throw;
  }
  report_warnings(warnings_of(march, recorder));
  if (output) output->finish(outcome_of(march), true);

  RunResult r = result_of(march, methods, recorder, conservation);
  r.profiles = recorder.profiles(march);
  r.momentum_error = march.force_imbalance();
  r.moment_error = march.moment_imbalance();
  // Of several bodies the coarsest counts: the widest spacing, and among equal ones the fewest cells.
  for (const MovingBody& body : march.bodies()) {
    const Shape& shape = *scene.bodies[body.index].shape;
    const Method& method = methods.of(scene.bodies[body.index]);
    const double spacing = shape.cells() && method.is_fem()
                               ? body.discretization->spacing()
                               : height_spacing(shape, divisions_of(shape, resolution));
    const int cells = int(std::lround((shape.upper()[1] - shape.lower()[1]) / spacing));
    if (spacing > r.spacing * (1 + 1e-9))
      r.spacing = spacing, r.cells_over_height = cells;
    else if (spacing >= r.spacing * (1 - 1e-9))
      r.cells_over_height = std::min(r.cells_over_height, cells);
    const auto* options_of_sph = std::get_if<sph::Options>(&method.options);
    if (!options_of_sph || !options.scalars.contains("surface_weight_loss")) continue;
    sph::Options o = *options_of_sph;
    o.spacing = body.discretization->spacing();
    double& loss = r.scalars["surface_weight_loss"];
    loss = std::max(loss, sph::surface_weight_loss(scene, body.index, o));
  }
  return r;
}

}  // namespace femsph::compare
