// What acts on the bodies of a scene: supports, loads, gravity, damping, settling.

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/scene_reader.hpp"

namespace femsph::scene_reader {
namespace {

std::optional<std::array<bool, 3>> read_fixed(Fields& fields, int dim) {
  const std::vector<std::string> all = {"x", "y", "z"};
  const std::vector<std::string> known(all.begin(), all.begin() + (dim == 2 ? 2 : 3));
  const std::string expected = "a list of components such as [\"x\", \"y\"]";
  const auto components = fields.texts("fix", Need::required, expected);
  if (!components) return {};
  std::array<bool, 3> fixed{};
  for (const std::string& component : *components) {
    const auto found = std::find(known.begin(), known.end(), component);
    if (found == known.end())
      return fields.fault(
                 "fix",
                 fmt::format("unknown component {}; expected {}{}", in_quotes(component), one_of(known),
                             component == "z" ? " in a plane scene" : did_you_mean(component, known))),
             std::nullopt;
    bool& is_fixed = fixed[found - known.begin()];
    if (is_fixed)
      return fields.fault(
                 "fix", fmt::format("component {} is given twice; expected it once", in_quotes(component))),
             std::nullopt;
    is_fixed = true;
  }
  if (components->empty()) return fields.fault("fix", "\"fix\" is empty; expected " + expected), std::nullopt;
  return fixed;
}

std::optional<TimeHistory> read_ramp(Fields& history) {
  const auto ramp = history.quantity("ramp", Need::required, dimension::time, Sign::positive);
  return ramp ? std::optional(TimeHistory{{0, *ramp}, {0, 1}}) : std::nullopt;
}

std::optional<TimeHistory> read_points(Fields& history) {
  const auto time = history.quantities("time", Need::required, dimension::time, Sign::not_negative);
  const auto factor = history.numbers("factor", Need::required);
  if (!time || !factor) return {};
  if (time->empty())
    return history.fault("time", "\"time\" is empty; expected at least one time"), std::nullopt;
  if (std::adjacent_find(time->begin(), time->end(), std::greater_equal<>()) != time->end())
    return history.fault("time", "the times do not increase; expected each time later than the one before"),
           std::nullopt;
  if (time->size() != factor->size())
    return history.fault("factor", fmt::format("{} factors for {} times; expected as many factors as times",
                                               factor->size(), time->size())),
           std::nullopt;
  return TimeHistory{*time, *factor};
}

std::optional<TimeHistory> read_history(Fields& load) {
  const std::string expected = "\"step\", {ramp = \"10 ms\"} or {time = [..], factor = [..]}";
  if (!load.holds_table("history")) {
    const auto word = load.text("history", Need::optional, expected);
    if (word && *word != "step")
      load.fault("history", fmt::format("\"history\" is {}; expected {}{}", in_quotes(*word), expected,
                                        did_you_mean(*word, {"step"})));
    return TimeHistory{};
  }
  auto history = load.table("history", Need::optional, expected);
  const bool points = history->has("time") || history->has("factor");
  const auto read = points ? read_points(*history) : read_ramp(*history);
  history->done();
  return read;
}

bool is_zero(const Point& p) { return p == Point{}; }
bool is_zero(const Matrix& m) { return m == Matrix{}; }

bool something_moves(const Scene& scene) {
  return (scene.gravity && !is_zero(*scene.gravity)) ||
         std::any_of(scene.loads.begin(), scene.loads.end(),
                     [](const Load& load) { return !is_zero(load.force) || load.pressure != 0; }) ||
         std::any_of(scene.supports.begin(), scene.supports.end(),
                     [](const Support& support) { return !is_zero(support.velocity); }) ||
         std::any_of(scene.initial_displacements.begin(), scene.initial_displacements.end(),
                     [](const auto& u) { return !is_zero(u.gradient); }) ||
         std::any_of(scene.initial_velocities.begin(), scene.initial_velocities.end(), [](const auto& v) {
           return !is_zero(v.velocity) || !is_zero(v.spin) || !is_zero(v.gradient);
         });
}

/// Empty unless the support's reaction is asked for.
std::string read_support_name(Fields& fields, const Reading& reading) {
  const auto name = fields.text("name", Need::optional);
  if (!name) return {};
  if (!usable_name(*name))
    fields.fault(
        "name",
        fmt::format(
            "the name {} cannot be used; expected letters, digits, _ and - (at most 64: it names columns)",
            in_quotes(*name)));
  for (const Support& other : reading.scene.supports)
    if (other.name == *name)
      return fields.fault(
                 "name", fmt::format("the name {} is taken; expected a name that no other support has",
                                     in_quotes(*name))),
             std::string();
  return *name;
}

}  // namespace

void read_supports(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("supports")) {
    const auto place = read_place(fields, reading);
    if (place && reading.scene.bodies[place->body].rigid) {
      read_rigid_support(fields, *place, reading);
      continue;
    }
    // Of an unknown place it is not known which components there are.
    const auto fixed = !place && fields.has("fix") ? (fields.accept("fix"), std::nullopt)
                                                   : read_fixed(fields, reading.dim);
    const auto mean = fields.choice<bool>("mode", Need::optional, {{"each", false}, {"mean", true}});
    const auto velocity = fields.vector("velocity", Need::optional, dimension::velocity, reading.dim);
    const auto history = read_history(fields);
    const std::string name = read_support_name(fields, reading);
    fields.done();
    if (!name.empty() && mean == true)
      fields.fault(
          "name", "\"name\" with mode = \"mean\"; expected it only on a support that holds every point");
    if (velocity && mean == true)
      fields.fault("velocity",
                   "\"velocity\" with mode = \"mean\"; expected it only on a support that holds every point");
    if (fields.has("history") && !fields.has("velocity"))
      fields.fault("history", "\"history\" without \"velocity\"; expected both, or neither");
    if (velocity && fixed)
      for (int c = 0; c < 3; ++c)
        if (!(*fixed)[c] && (*velocity)[c] != 0)
          fields.fault("velocity", fmt::format("\"velocity\" moves {0}, which this support does not hold; "
                                               "expected 0 there, or \"{0}\" in \"fix\"",
                                               "xyz"[c]));
    if (place && fixed && history)
      reading.scene.supports.push_back(
          {*place, *fixed, {}, mean.value_or(false), velocity.value_or(Point{}), *history, name});
  }
}

void read_loads(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("loads")) {
    const auto place = read_place(fields, reading);
    const bool by_pressure = fields.has("pressure");
    const auto force = fields.vector(
        "force", by_pressure ? Need::optional : Need::required, dimension::force, reading.dim);
    const auto pressure = fields.quantity("pressure", Need::optional, dimension::pressure);
    const auto history = read_history(fields);
    fields.done();
    if (by_pressure && force)
      fields.fault("pressure", "both \"force\" and \"pressure\"; expected one of them");
    const bool shape_known =
        place && reading.scene.bodies[place->body].shape;  // else its sides have not been looked up
    if (by_pressure && place && (shape_known || place->point) && place->sides.size() != 1)
      fields.fault("pressure", "\"pressure\" needs one side of a body; expected at = \"x+\" or the like");
    if (by_pressure && reading.scene.large_motion)
      fields.fault(
          "pressure", "\"pressure\" follows no large motion; expected motion = \"small\", or a \"force\"");
    if (place && (force || pressure) && history)
      reading.scene.loads.push_back({*place, force.value_or(Point{}), *history, pressure.value_or(0)});
  }
}

void read_gravity(Fields& root, Reading& reading) {
  auto gravity = root.table(
      "gravity", Need::optional, "a table with acceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"] or the like");
  if (!gravity) return;
  const auto acceleration = gravity->vector(
      "acceleration", Need::required, dimension::acceleration, reading.dim);
  if (acceleration && !is_zero(*acceleration))
    reading.scene.gravity = acceleration;  // zero is no gravity: it costs nothing
  gravity->done();
}

void read_damping(Fields& root, Reading& reading) {
  auto damping = root.table("damping", Need::optional, "a table with rate = \"100 1/s\" or the like");
  if (!damping) return;
  reading.scene.damping = damping->quantity("rate", Need::required, dimension::rate, Sign::positive);
  damping->done();
}

void read_effects(Fields& root, Reading& reading) {
  for (const EffectEntry& effect : effects()) {
    if (!effect.read) continue;
    auto fields = root.table(effect.table.c_str(), Need::optional, "a table: " + effect.about);
    if (!fields) continue;
    if (auto input = effect.read(*fields, reading.dim)) reading.scene.effect_inputs[effect.table] = input;
    fields->done();
  }
}

void read_settling(Fields& root, Reading& reading) {
  auto fields = root.table("settling", Need::optional, "a table with method = \"damping\" or \"kinetic\"");
  if (!fields) return;
  Settling settling;
  const auto method = fields->choice<SettlingMethod>(
      "method", Need::required, {{"damping", SettlingMethod::damping}, {"kinetic", SettlingMethod::kinetic}});
  settling.method = method.value_or(SettlingMethod::damping);
  const std::string share = "a number above 0 and below 1";
  settling.tolerance = fields->number("tolerance", Need::optional, share).value_or(settling.tolerance);
  if (!(settling.tolerance > 0 && settling.tolerance < 1))
    fields->fault("tolerance", fmt::format("\"tolerance\" is {}; expected {}", settling.tolerance, share));
  settling.rate = fields->quantity("rate", Need::optional, dimension::rate, Sign::positive);
  if (fields->has("rate") && method == SettlingMethod::kinetic)
    fields->fault("rate",
                  "\"rate\" with method = \"kinetic\", which damps nothing; expected it only with method = "
                  "\"damping\"");
  fields->done();
  const bool faulty_elsewhere = !reading.faults.empty() &&
                                (root.has("loads") || root.has("initial") || root.has("gravity") ||
                                 root.has("initial_displacements"));
  if (!something_moves(reading.scene) && !faulty_elsewhere)
    root.fault("settling",
               "nothing could move that would settle; expected [[loads]], [gravity] or [[initial]] with a "
               "value other than zero");
  if (std::any_of(reading.scene.supports.begin(), reading.scene.supports.end(),
                  [](const Support& support) { return !is_zero(support.velocity); }))
    root.fault(
        "settling",
        "[settling] with a support that has a \"velocity\"; expected supports at rest, or no [settling]");
  reading.scene.settling = settling;
}

}  // namespace femsph::scene_reader
