#include "compare/study/study_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/measure/errors.hpp"
#include "compare/measure/ladder.hpp"
#include "compare/measure/limit_value.hpp"
#include "compare/measure/reduce.hpp"

namespace femsph::compare {
namespace {

const LimitSpec* spec_of(const Study& study, const std::string& scene) {
  if (const auto own = study.limits.find(scene); own != study.limits.end()) return &own->second;
  return study.limit ? &*study.limit : nullptr;
}

/// Divisions and degree of two coarser solutions than the limit, coarsest first: a quarter and half of the
/// cells along every axis that has four or more; without such an axis, the degree less two and less one.
/// Empty if there is no coarser solution.
struct Coarser {
  std::array<int, 3> divisions;
  int degree;
};
std::vector<Coarser> coarser_of(const LimitSpec& spec) {
  const auto& n = spec.divisions;
  if (std::any_of(n.begin(), n.end(), [](int cells) { return cells >= 4; })) {
    std::vector<Coarser> ladder(2, {n, spec.degree});
    for (int a = 0; a < 3; ++a)
      if (n[a] >= 4)
        ladder[0].divisions[a] = int(std::lround(n[a] / 4.0)),
        ladder[1].divisions[a] = int(std::lround(n[a] / 2.0));
    return ladder;
  }
  if (spec.degree < 3) return {};
  return {{n, spec.degree - 2}, {n, spec.degree - 1}};
}

KnownLimit known_limit(const Scene& scene, const LimitSpec& spec, const Engine& engine, bool priced) {
  KnownLimit known{engine.limit(scene, spec.divisions, spec.degree), {}, {}, 0};
  if (priced && spec.degree > 1) known.coarser = engine.limit(scene, spec.divisions, spec.degree - 1);
  for (const Coarser& coarser : coarser_of(spec)) {
    known.ladder.push_back(engine.limit(scene, coarser.divisions, coarser.degree));
    // With rising degree p the error at a singular point of exponent lambda falls as p^(-4 lambda), and a
    // logarithm changes by ln(p/(p-1)): over degrees 2, 3, 4 the ratios of changes are 0.26 and 0.71.
    known.slowest = coarser.degree == spec.degree ? 0.7 : 0.5;
  }
  return known;
}

void one_ladder_limit(const Study& study, const QuantitySpec& quantity, const std::string& scene,
                      const std::string& label, const StudyOptions& options, StudyOutcome& outcome) {
  Ladder values;
  const auto belongs = [&](const Row& row) {
    return row.scene == scene && row.quantity == quantity.name && row.value;
  };
  for (const Row& row : outcome.rows)
    if (belongs(row) && row.method == label && row.spacing_mm && row.settled != false)
      values.push_back({*row.spacing_mm, *row.value});
  const auto limit = richardson(values);
  const std::string infinite = no_value_at(quantity, study.scenes.at(scene));
  if (!limit || !is_convergence(limit->order) || !infinite.empty()) {
    ++outcome.failures;
    const std::string why =
        !infinite.empty() ? infinite
        : limit           ? fmt::format(
                                "the finest spacings of {} extrapolate to {} with order {:.2f}, which is not that of "
                                          "convergence ({:g} to {:g})",
                                label, rounded(limit->limit, 5), limit->order, least_order, greatest_order)
                : fmt::format(
                      "the {} spacings of {} do not approach a limit in one direction", values.size(), label);
    if (options.log)
      options.log(fmt::format("{} limit of {} in {}: {}", study.name, quantity.name, scene, why));
    for (Row& row : outcome.rows)
      if (belongs(row)) row.limit_doubt = why;
    return;
  }
  Rung finest = values.front();
  for (const Rung& rung : values)
    if (rung.spacing < finest.spacing) finest = rung;
  for (Row& row : outcome.rows) {
    if (!belongs(row)) continue;
    row.limit = limit->limit;
    row.error_vs_limit_percent = percent_error(*row.value, limit->limit);
    if (limit->limit != 0) row.limit_known_percent = 125 * std::abs(finest.value / limit->limit - 1);
  }
  if (options.log)
    options.log(fmt::format("{} limit of {} in {}: {} {}, known to {:.2g} %, order {:.2f}", study.name,
                            quantity.name, scene, rounded(limit->limit, 6), quantity.observed.unit.name,
                            125 * std::abs(finest.value / limit->limit - 1), limit->order));
}

}  // namespace

StaticLimits static_limits(const Study& study, const Engine& engine, const StudyOptions& options,
                           StudyOutcome& outcome) {
  StaticLimits limits;
  for (const PlannedRun& run : study.runs) {
    const LimitSpec* spec = spec_of(study, run.scene);
    if (!spec || !spec->ladder.empty() || (options.quick && !run.quick) || limits.contains(run.scene))
      continue;
    try {
      limits[run.scene] = known_limit(study.scenes.at(run.scene), *spec, engine, !study.prices.empty());
    } catch (const std::exception& e) {
      limits[run.scene] = {};
      ++outcome.failures;
      if (options.log) options.log(fmt::format("{} limit of {}: {}", study.name, run.scene, e.what()));
    }
  }
  return limits;
}

const KnownLimit* limit_of(const StaticLimits& limits, const std::string& scene) {
  const auto found = limits.find(scene);
  return found == limits.end() || (found->second.limit.probes.empty() && found->second.limit.sections.empty())
             ? nullptr
             : &found->second;
}

std::string doubt_of(const QuantitySpec& quantity, const Scene& scene, const KnownLimit& known) {
  if (const std::string infinite = no_value_at(quantity, scene); !infinite.empty()) return infinite;
  if (known.ladder.size() < 2) return "";
  const auto first = change_of(quantity, scene, known.ladder[0], known.ladder[1]),
             second = change_of(quantity, scene, known.ladder[1], known.limit);
  if (!first || !second || second->change <= 1e-4 * second->size ||
      second->change <= known.slowest * first->change)
    return "";
  const auto percent = [&](const LimitChange& one) {
    return second->size > 0 ? fmt::format("{:.2g} %", 100 * one.change / second->size)
                            : rounded(one.change, 2);
  };
  return fmt::format(
      "refinement changes it by {}, then by {}: the changes do not decrease as they do towards a limit",
      percent(*first), percent(*second));
}

void ladder_limits(const Study& study, const StudyOptions& options, StudyOutcome& outcome) {
  for (const auto& [scene, spec] : study.limits)
    for (const QuantitySpec& quantity : study.quantities)
      if (!spec.ladder.empty() && (!quantity.scene || *quantity.scene == scene))
        one_ladder_limit(study, quantity, scene, spec.ladder, options, outcome);
}

}  // namespace femsph::compare
