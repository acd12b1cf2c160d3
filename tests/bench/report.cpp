#include "tests/bench/report.hpp"

#include <fmt/format.h>

#include "model/results/record.hpp"

namespace femsph::bench {

namespace {

double counter(const Line& l, const char* name) {
  const auto found = l.counters.find(name);
  return found == l.counters.end() ? 0.0 : found->second;
}
double nanoseconds(const Line& l) { return 1e9 * l.seconds / counter(l, "units"); }
std::string number(double x, const char* digits = "{:.3g}") {
  return x > 0 ? fmt::format(fmt::runtime(digits), x) : "";
}

std::string processor() {
  for (const auto& [key, value] : provenance())
    if (key == "processor") return value;
  return "unknown machine";
}

}  // namespace

std::string markdown(const std::vector<Line>& lines, const std::map<std::string, double>& targets,
                     const std::map<std::string, std::string>& without) {
  double memory = 0, oracle[4] = {};
  std::map<std::string, double> speedup, effect;
  std::string head, target, method, effects;
  for (const Line& l : lines) {
    if (l.section == "triad")
      head += fmt::format(
          "; a = b + s c over {:.0f} numbers: {:.3g} ns each", counter(l, "units"), nanoseconds(l));
    if (l.name == "triad, large") memory = nanoseconds(l);
    if (l.section == "oracle") oracle[l.name[0] - '0'] = nanoseconds(l);
    if (l.section == "threads") speedup[l.name] = counter(l, "speedup");
    if (l.section == "effect") effect[l.name] = nanoseconds(l);
  }
  for (const Line& l : lines) {
    const double ns = nanoseconds(l), force = 1e9 * counter(l, "force") / counter(l, "units"),
                 bytes = counter(l, "bytes");
    const bool element = l.name.find("SPH") == std::string::npos && l.name.find("sph") == std::string::npos;
    const std::string ratio = element && oracle[l.name[0] - '0'] > 0
                                  ? fmt::format("{:.0f}", oracle[l.name[0] - '0'] / ns)
                                  : "";
    if (l.section == "target") {
      const double aim = targets.at(l.name), yielding = counter(l, "yielding");
      target += fmt::format("| {} | {:.0f} | {:.3g} | {} | {:.3g} | {:.0f} | {} | {} | {} | {:.0f} |\n",
                            l.name, aim, ns, ns <= aim ? "yes" : "**no**", force, ns / memory, ratio,
                            yielding > 0 ? fmt::format("{:.0f} %", 100 * yielding) : "",
                            number(speedup[l.name], "{:.2f}"), bytes);
    }
    if (l.section == "method")
      method += fmt::format("| {} | {:.0f} | {:.3g} | {:.3g} | {:.0f} | {} | {:.0f} |\n", l.name,
                            counter(l, "units"), ns, force, ns / memory, ratio, bytes);
    if (l.section == "effect") {
      const auto base = without.find(l.name);
      effects += base == without.end() || !effect.count(base->second)
                     ? fmt::format("| **{}** | {:.3g} | | {:.0f} |\n", l.name, ns, bytes)
                     : fmt::format("| {} | {:.3g} | {:+.1f} | {:.0f} |\n", l.name, ns,
                                   ns - effect.at(base->second), bytes);
    }
  }
  std::string text = fmt::format("{}, {}{}.\n", version_line(), processor(), head);
  for (int dim : {2, 3})
    if (oracle[dim] > 0)
      text += fmt::format("The FEValues oracle takes {:.0f} ns in {}D.\n", oracle[dim], dim);
  if (!target.empty())
    text +=
        "\n### Targets\n\n| case | target ns | ns a step | met | of it force | times the triad | oracle / "
        "this | points that yield | two threads | bytes |\n"
        "|---|---:|---:|---|---:|---:|---:|---:|---:|---:|\n" +
        target;
  if (!method.empty())
    text +=
        "\n### Every method, elastic\n\n| method | units | ns a step | of it force | times the triad | "
        "oracle / this | bytes |\n|---|---:|---:|---:|---:|---:|---:|\n" +
        method;
  if (!effects.empty())
    text +=
        "\n### What an effect costs\n\nWhole steps of the march.\n\n| case | ns a step | more than without | "
        "bytes |\n|---|---:|---:|---:|\n" +
        effects;
  return text;
}

}  // namespace femsph::bench
