// `femsph advise`: reads the question from the command line, and prints the advice.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/price/advise.hpp"
#include "compare/program/commands.hpp"
#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"
#include "model/input/units.hpp"
#include "model/numerics/parallel.hpp"
#include "model/results/recorder.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::compare {
namespace {

double seconds_of(const char* option, const std::string& text) {
  try {
    const double s = to_si(text, dimension::time);
    if (s > 0) return s;
  } catch (const std::exception&) {
  }
  throw BadCommand(fmt::format(
      "{} {}: expected a time above zero with its unit, such as \"10 min\"", option, in_quotes(text)));
}

/// "1%" or "0.01".
double percent_of(const std::string& text) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  while (end > 0 && end < text.size() && text[end] == ' ') ++end;
  const bool percent = end > 0 && text.substr(end) == "%";
  const double result = percent ? value : 100 * value;
  if (end == 0 || !(percent || end == text.size()) || !(result > 0 && result < 100))
    throw BadCommand(fmt::format(
        "--error {}: expected a fraction between 0 and 1, or a percentage: 0.01 or 1%", in_quotes(text)));
  return result;
}

/// "fem-full,sph-corrected" is two methods; "bar=sph-corrected,plate=fem-full", with an equals sign, is one.
std::vector<std::string> split_methods(const std::string& text) {
  if (text.find('=') != std::string::npos) return {text};
  std::vector<std::string> names;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    names.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return names;
}

const Probe& probe_of(const Scene& scene, const std::string& name) {
  if (scene.probes.empty())
    throw BadCommand(fmt::format(
        "{} has no probe; expected [[probes]] with the quantity whose error matters", scene.file));
  if (name.empty()) return scene.probes.front();
  return entry_named<BadCommand>(
      scene.probes, name, &Probe::name, "--probe: no probe is called " + in_quotes(name));
}

Reduce reduce_of(const Scene& scene, const std::string& word) {
  static const std::vector<std::pair<std::string, Reduce>> known = {
      {"final", Reduce::final}, {"peak", Reduce::peak}, {"mean", Reduce::mean}};
  if (word.empty()) return scene.settling ? Reduce::final : Reduce::peak;
  return value_named<BadCommand>(known, word, fmt::format("--reduce: {} is unknown", in_quotes(word)));
}

/// The component with the largest magnitude in a coarse run, by the first method that can make such a run.
std::string largest_component(const Scene& scene, const Probe& probe,
                              const std::vector<std::string>& components, const Question& question) {
  double shortest = 1e300;
  for (const Body& body : scene.bodies)
    for (int a = 0; !body.rigid && a < scene.dim(); ++a)
      shortest = std::min(shortest, body.shape->upper()[a] - body.shape->lower()[a]);
  std::string why;
  for (const int divisions : {2, 4, 8})
    for (const BodyMethods& method : question.methods) try {
        RunOptions options;
        options.march.safety = question.safety;
        const RunResult r = run_scene(scene, method, Resolution{shortest / divisions, {}}, options);
        std::string best = components.front();
        double most = -1;
        for (const std::string& c : components) {
          const auto& values = r.history[probe.name + "_" + c].values;
          const double size = question.quantity.reduce == Reduce::final
                                  ? std::abs(values.back())
                                  : std::abs(*std::max_element(
                                        values.begin(), values.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); }));
          if (size > most) most = size, best = c;
        }
        return best;
      } catch (const std::exception& e) {
        why = e.what();
      }
  throw Refusal(fmt::format("no method can make even a coarse run: {}", why));
}

}  // namespace

Question question_of(const AdviseCommand& c, const Scene& scene) {
  Question q;
  if (c.error.empty() == c.within.empty())
    throw BadCommand("expected either an error, such as --error 1%, or a time, such as --within \"10 min\"");
  if (!c.error.empty()) q.error = percent_of(c.error);
  if (!c.within.empty()) q.within = seconds_of("--within", c.within);
  q.budget = seconds_of("--budget", c.budget);
  q.safety = checked_safety(c.safety);
  try {
    for (const std::string& text : c.methods)
      for (const std::string& name : split_methods(text))
        q.methods.push_back(read_body_methods(name, &scene));
    if (c.methods.empty()) q.methods = usual_methods();
  } catch (const std::runtime_error& e) {
    throw BadCommand(std::string("--methods: ") + e.what());
  }
  for (std::size_t i = 0; i < q.methods.size(); ++i)  // a method given twice would agree with itself
    for (std::size_t j = 0; j < i; ++j)
      if (q.methods[i].name == q.methods[j].name)
        throw BadCommand(fmt::format("--methods: {} is given twice", q.methods[i].name));
  const Probe& probe = probe_of(scene, c.probe);
  q.quantity.reduce = reduce_of(scene, c.reduce);
  const auto components = component_names(*probe.quantity, scene.dim());
  if (!c.component.empty() &&
      std::find(components.begin(), components.end(), c.component) == components.end())
    throw BadCommand(fmt::format(
        "--component: {} has no {}; expected {}", probe.name, in_quotes(c.component), one_of(components)));
  const std::string si = probe.quantity->unit;
  q.quantity.observed = {
      probe.name, "",          "",
      "",         c.component, si == "m" ? Unit{"mm", 1e-3} : si == "Pa" ? Unit{"MPa", 1e6} : Unit{si, 1}};
  if (c.component.empty())
    q.quantity.observed.component = components.size() == 1 ? components[0]
                                                           : largest_component(scene, probe, components, q);
  const char* word = q.quantity.reduce == Reduce::final  ? "at the end"
                     : q.quantity.reduce == Reduce::peak ? "at its peak"
                                                         : "on average";
  q.quantity.name = fmt::format("{}_{} {}", probe.name, q.quantity.observed.component, word);
  return q;
}

int advise_command(const AdviseCommand& command) {
  set_threads(1);
  Scene scene = read_scene(command.scene);
  scene.snapshots = 0;
  const Question question = question_of(command, scene);
  const Engine engine{run_scene, fem::static_limit};
  const Advice advice = advise(scene, question, engine);
  fmt::print("{}", describe(scene, question, advice));
  if (!advice.best) return 3;
  if (command.run) {
    std::fflush(stdout);
    fmt::print("{}", describe(advice, question, follow(scene, question, advice, engine)));
  }
  return 0;
}

}  // namespace femsph::compare
