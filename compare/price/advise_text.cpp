// The text that `advise` prints.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/price/advise.hpp"

namespace femsph::compare {
namespace {

std::string millimetres(double metres) { return rounded(1e3 * metres, 3); }

std::string seconds(double s) {
  if (s < 120) return rounded(s, 2) + " s";
  if (s < 7200) return fmt::format("{:.0f} min", s / 60);
  return fmt::format("{:.1f} h", s / 3600);
}

std::string line(const std::string& key, const std::string& value) {
  return fmt::format("  {:<24} {}\n", key, value);
}

std::string ladders(const Question& question, const Advice& advice) {
  std::vector<std::vector<std::string>> cells{
      {"method", "d mm", "value " + question.quantity.observed.unit.name, "error %", "CPU s"}};
  for (const MethodEvidence& m : advice.methods)
    for (std::size_t i = 0; i < m.rungs.size(); ++i)
      cells.push_back(
          {i == 0 ? m.method.name : "", millimetres(m.rungs[i].spacing), rounded(m.values[i], 5),
           advice.reference ? fmt::format("{:+.2f}", m.rungs[i].error) : "", rounded(m.rungs[i].cpu, 2)});
  return markdown_table(cells);
}

std::string limits(const Question& question, const Advice& advice) {
  std::vector<std::vector<std::string>> cells{
      {"method", "limit", "known to %", "order", "agrees", question.error ? "needs" : "reaches"}};
  for (std::size_t k = 0; k < advice.methods.size(); ++k) {
    const MethodEvidence& m = advice.methods[k];
    std::string can = m.trouble;
    if (k < advice.choices.size()) {
      const auto& c = advice.choices[k];
      can = c ? fmt::format("{} mm, {}, error {} %{}", millimetres(c->spacing), seconds(c->cpu),
                            rounded(c->error, 2), c->extrapolated ? ", extrapolated" : "")
              : advice.why_not[k];
    }
    cells.push_back(
        {m.method.name, m.limit ? rounded(*m.limit, 5) : "none found",
         m.limit ? rounded(m.known_percent, 2) : "", m.order ? fmt::format("{:.2f}", *m.order) : "",
         !advice.reference        ? ""
         : k == *advice.reference ? "reference"
         : m.meets                ? "yes"
                                  : "no",
         can});
  }
  return markdown_table(cells);
}

/// How far apart the limits are, and the observed orders.
std::string agreement(const Advice& advice) {
  if (advice.meeting < 2) return "";
  double least = 1e300, most = 0;
  for (const MethodEvidence& m : advice.methods)
    if (m.meets && m.order) least = std::min(least, *m.order), most = std::max(most, *m.order);
  return fmt::format(" (the farthest is {} % away; orders {:.2f} to {:.2f})",
                     rounded(advice.spread_percent, 2), least, most);
}

/// How far the reference can be trusted.
std::string confidence(const Advice& advice) {
  for (const MethodEvidence& m : advice.methods)
    if (!m.dissent.empty()) return "but " + m.dissent + ": confidence none";
  if (advice.meeting < 2) return "confidence none";
  if (!advice.suspect.empty()) return "but there is " + advice.suspect + ": confidence low";
  return advice.both_kinds     ? "FEM and SPH among them: confidence good"
         : advice.meeting >= 3 ? "all of one kind: confidence fair"
                               : "all of one kind: confidence low";
}

/// The probe, which the command line need not name.
std::string probe_line(const Scene& scene, const Question& question) {
  for (const Probe& probe : scene.probes)
    if (probe.name == question.quantity.observed.probe)
      return line(
          "probe",
          fmt::format("{} of body {}, component {}{}", probe.name, scene.bodies[probe.body].name,
                      question.quantity.observed.component,
                      scene.probes.size() > 1
                          ? fmt::format("; one of {} probes (--probe names another)", scene.probes.size())
                          : ""));
  return "";
}

}  // namespace

std::string describe(const Scene& scene, const Question& question, const Advice& advice) {
  std::string text = scene.title + "\n";
  const auto& q = question.quantity;
  text += line(
      "asked",
      q.name + (question.error ? fmt::format(", error at most {:g} %", *question.error)
                               : fmt::format(", least error within {} of CPU", seconds(*question.within))));
  text += probe_line(scene, question);
  if (!advice.methods.empty())
    text += line(
        "ladders",
        fmt::format("{} methods at spacings that divide the shortest side, {} mm; {} of CPU on one thread",
                    advice.methods.size(), millimetres(advice.shortest), seconds(advice.spent)));
  if (!advice.methods.empty())
    text += "\n" + ladders(question, advice) + "\n" + limits(question, advice) + "\n";
  if (advice.reference) {
    const MethodEvidence& reference = advice.methods[*advice.reference];
    text += line(
        "reference",
        fmt::format("{} {}, Richardson's limit of {}, known to {} %", rounded(*reference.limit, 5),
                    q.observed.unit.name, reference.method.name, rounded(reference.known_percent, 2)));
    text += line("evidence", fmt::format("{} of {} methods approach it within {:g} %{}, {}", advice.meeting,
                                         advice.methods.size(), advice.tolerance_percent, agreement(advice),
                                         confidence(advice)));
  }
  if (!advice.best) return text + line("advice", "none: " + advice.refusal);
  const Choice& best = *advice.best;
  text += line(
      "advice", fmt::format("--solver {} --spacing \"{:.6g} mm\" --safety {:g}",
                            advice.methods[best.method].method.name, 1e3 * best.spacing, question.safety));
  text += line("predicted", fmt::format("{} of CPU, error {} %{}", seconds(best.cpu), rounded(best.error, 2),
                                        best.extrapolated ? " (extrapolated)" : " (between runs made)"));
  return text;
}

std::string describe(const Advice& advice, const Question& question, const Outcome& outcome) {
  const char* verdict = !question.error                              ? ""
                        : std::abs(outcome.error) <= *question.error ? ": as asked"
                                                                     : ": more than asked";
  return line("advised run",
              fmt::format("{} of CPU, {:.2f} times the predicted; {} {}, error {:+.2g} %{}",
                          seconds(outcome.cpu), outcome.cpu / advice.best->cpu, rounded(outcome.value, 5),
                          question.quantity.observed.unit.name, outcome.error, verdict)) +
         price_text(outcome.price, advice.methods[advice.best->method].method.unit_name());
}

}  // namespace femsph::compare
