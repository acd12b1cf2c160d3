// Supports that fix every point of a place: which displacement components they fix, and for which of these
// the time loop needs a mass because their velocity is prescribed.

#include "model/motion/effects/supports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/effects/mean_supports.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {

namespace {

/// Whether two supports of the same component prescribe the same motion.
bool agree(const Support& a, const Support& b, int c) {
  if (a.velocity[c] != b.velocity[c]) return false;
  return a.velocity[c] == 0 || (a.history.time == b.history.time && a.history.factor == b.history.factor);
}

std::string wanted_motion(const Support& support, int c) {
  return support.velocity[c] == 0
             ? "holds it at rest"
             : fmt::format("moves it at {:g} m/s{}", support.velocity[c],
                           support.history.time.size() > 1 ? " times its history" : "");
}

[[noreturn]] void refuse(const Scene& scene, const MovingBody& body, const Support& one, const Support& other,
                         int c, const Point& x) {
  throw InputError(
      scene.file,
      {Fault{other.place.source.line, other.place.source.column,
             fmt::format("this support {} along {} and the one at {}:{}:{} {}: both have the point ({:.6g}, "
                         "{:.6g}, {:.6g}) m of body \"{}\"; expected supports that agree there, or places "
                         "that do not meet (see \"within\")",
                         wanted_motion(other, c), "xyz"[c], scene.file, one.place.source.line,
                         one.place.source.column, wanted_motion(one, c), x[0], x[1], x[2], body.name)}});
}

void hold_components_of(const Motion& motion, const std::vector<Support>& holds, MovingBody& body) {
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  for (std::size_t h = 0; h < holds.size(); ++h) {
    if (holds[h].place.body != body.index || holds[h].mean) continue;
    for (const Weight& w : motion.points_of(body, holds[h].place, "support"))
      for (int c = 0; c < at.dim; ++c)
        if (holds[h].fixed[c]) body.held.push_back({w.point, c, h});
  }
  std::sort(body.held.begin(), body.held.end());
  for (std::size_t k = 0; k < body.held.size(); ++k) {
    const auto [point, c, h] = body.held[k];
    const std::size_t slot = at.at(point, c);
    if (k > 0 && body.held[k - 1].point == point && body.held[k - 1].component == c) {
      const Support &one = holds[body.held[k - 1].hold], &other = holds[h];
      if (agree(one, other, c)) continue;
      refuse(motion.scene, body, one, other, c, d.position(point));
    }
    double start = 0;
    for (const InitialVelocity& initial : motion.scene.initial_velocities)
      if (initial.body == body.index) start += initial.at(d.position(point))[c];
    body.inverse_mass[slot] = 0;
    if (holds[h].velocity[c] == 0 && start == 0) continue;
    body.driven.push_back({slot, holds[h].velocity[c], h, d.mass()[point], start});
    if (!body.mass.empty()) body.mass[slot] = 0;  // MovedSupports::after_kick counts its damping
  }
  std::sort(
      body.driven.begin(), body.driven.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
}

using namespace scene_reader;

KeyTable support_keys() {
  return {
      "[[supports]]",
      "Fixes displacement components of a place, or prescribes their velocity. Fixed components keep the "
      "value that they have at the start.",
      place_keys(
          {{"fix", key_holds::texts,
            "The components that are fixed or prescribed: \"x\", \"y\", \"z\". For a rigid body also the "
            "rotations: \"turn\" in a plane, \"turn-x\", \"turn-y\", \"turn-z\" in space.",
            true},
           {"mode", key_holds::words(std::vector<std::string>{"each", "mean"}),
            "\"each\": every point of the place is fixed. \"mean\": only the weighted mean of their "
            "displacements is, so that the place can rotate. \"each\" unless given."},
           {"velocity", key_holds::vector(dimension::velocity),
            "Prescribed velocity of the components in \"fix\"; the other entries are 0. Fixed unless given."},
           history_key("the velocity"),
           {"name", key_holds::text,
            "Adds the reaction to the history: support_NAME_force_x, .., support_NAME_moment_z, .. and the "
            "centroid of the place, support_NAME_centroid_x, .. No reaction unless given."}})};
}

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

/// The name for the reaction of the support; empty if the scene gives none.
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

void read_rigid_support(Fields& fields, const Place& place, Reading& reading) {
  std::vector<std::string> all = reading.dim == 2
                                     ? std::vector<std::string>{"x", "y", "turn"}
                                     : std::vector<std::string>{"x", "y", "z", "turn-x", "turn-y", "turn-z"};
  if (reading.dim == 0) all.push_back("turn");  // it may be a plane scene
  const std::string expected = "a list of components such as [\"x\", \"" + all.back() + "\"]";
  Support support{place, {}, {}};
  const auto components = fields.texts("fix", Need::required, expected);
  for (const std::string& component : components.value_or(std::vector<std::string>{})) {
    if (!fields.position_of(component, all, "fix", "component")) continue;
    if (component.starts_with("turn"))
      support.fixed_turn[component == "turn" ? 2 : component.back() - 'x'] = true;
    else
      support.fixed[component[0] - 'x'] = true;
  }
  if (components && components->empty()) fields.fault("fix", "\"fix\" is empty; expected " + expected);
  fields.done();
  reading.scene.supports.push_back(support);
}

void read_supports(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("supports")) {
    const auto place = read_place(fields, reading);
    if (place && reading.scene.bodies[place->body].rigid) {
      read_rigid_support(fields, *place, reading);
      continue;
    }
    // Which components there are is not known where the place is faulty.
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
    if (fields.has("history") && !fields.has("velocity") && !fields.misspelt({"velocity"}))
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

MadeEffect make_supports(Motion& motion) {
  hold_components(motion);
  auto means = std::make_unique<MeanSupports>(motion);
  if (means->holds().empty()) return {};
  return made(std::move(means));
}

}  // namespace

void hold_components(Motion& motion) {
  const std::vector<Support> holds = motion.scene.holds();
  for (MovingBody& body : motion.bodies) hold_components_of(motion, holds, body);
}

EffectEntry supports_effect() {
  EffectEntry e{{"supports", "fixed displacements, or a fixed mean displacement of a place"}};
  e.asked_by = "[[supports]]";
  e.on = [](const Scene& s) { return !s.supports.empty(); };
  e.tables = {support_keys(), history_keys("[supports.history]", "a support's velocity")};
  e.read = read_supports;
  e.outside = true;
  e.listed_off = false;
  e.make = make_supports;
  e.needed = [](const Motion& m) { return !m.scene.supports.empty() || !m.scene.symmetries.empty(); };
  return e;
}

}  // namespace femsph
