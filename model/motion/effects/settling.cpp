// Settling to the static state. The march decides when a body is at rest, and applies the damping
// (march_settling.cpp, march_kick.cpp).

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/effects/catalogue.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable settling_keys() {
  return {
      "[settling]",
      "Looks for the static state: the run ends when the bodies are in equilibrium and at rest, at the "
      "latest after the [time] duration.",
      {{"method", key_holds::words(std::vector<std::string>{"damping", "kinetic"}),
        "How the motion is damped. \"damping\": a force in proportion to mass and velocity. \"kinetic\": all "
        "velocities are set to zero whenever the kinetic energy has passed a peak.",
        true},
       {"tolerance", key_holds::number,
        "Above 0 and below 1. At rest means that three ratios are below it: the unbalanced forces to the "
        "loads, the displacement that they can still cause to the displacement, and the amplitude of the "
        "motion to the displacement. 1e-4 unless given."},
       {"rate", key_holds::quantity(dimension::rate),
        "Only with method = \"damping\": c of the damping force -c m v. Unless given it is estimated during "
        "the run: twice the lowest angular frequency, which is critical damping of the slowest mode."}}};
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
  const bool faulty_elsewhere =
      root.misspelt({"loads", "initial", "gravity", "initial_displacements", "materials", "bodies"}) ||
      (!reading.faults.empty() && (root.has("loads") || root.has("initial") || root.has("gravity") ||
                                   root.has("initial_displacements")));
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

}  // namespace

EffectEntry settling_effect() {
  EffectEntry e{{"settling", "the run ends in the static state, reached by viscous or by kinetic damping"}};
  e.asked_by = "[settling]";
  e.tables = {settling_keys()};
  e.read = read_settling;
  e.on = [](const Scene& s) { return s.settling.has_value(); };
  e.words = [](const Scene& s) -> std::vector<std::string> {
    return {s.settling->method == SettlingMethod::damping ? "settling by damping"
                                                          : "settling by kinetic damping"};
  };
  e.outside = true;
  return e;
}

}  // namespace femsph
