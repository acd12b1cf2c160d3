#include "compare/study_limits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compare/errors.hpp"
#include "compare/ladder.hpp"

namespace femsph::compare {
namespace {

const LimitSpec* spec_of(const Study& study, const std::string& scene) {
  if (const auto own = study.limits.find(scene); own != study.limits.end()) return &own->second;
  return study.limit ? &*study.limit : nullptr;
}

void one_ladder_limit(const Study& study, const QuantitySpec& quantity, const std::string& scene, const std::string& label, const StudyOptions& options,
                      StudyOutcome& outcome) {
  Ladder values;
  const auto belongs = [&](const Row& row) { return row.scene == scene && row.quantity == quantity.name && row.value; };
  for (const Row& row : outcome.rows)
    if (belongs(row) && row.method == label) values.push_back({*row.spacing_mm, *row.value});
  const auto limit = richardson(values);
  if (!limit) {
    ++outcome.failures;
    if (options.log)
      options.log(fmt::format("{} limit of {} in {}: the {} spacings of {} do not approach a limit in one direction", study.name, quantity.name, scene, values.size(), label));
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
    options.log(fmt::format("{} limit of {} in {}: {} {}, known to {:.2g} %, order {:.2f}", study.name, quantity.name, scene, rounded(limit->limit, 6),
                            quantity.observed.unit.name, 125 * std::abs(finest.value / limit->limit - 1), limit->order));
}

}  // namespace

StaticLimits static_limits(const Study& study, const Engine& engine, const StudyOptions& options, StudyOutcome& outcome) {
  StaticLimits limits;
  for (const PlannedRun& run : study.runs) {
    const LimitSpec* spec = spec_of(study, run.scene);
    if (!spec || !spec->ladder.empty() || (options.quick && !run.quick) || limits.contains(run.scene)) continue;
    try {
      const Scene& scene = study.scenes.at(run.scene);
      KnownLimit known{engine.limit(scene, spec->divisions, spec->degree), {}};
      if (!study.prices.empty() && spec->degree > 1) known.coarser = engine.limit(scene, spec->divisions, spec->degree - 1);
      limits[run.scene] = std::move(known);
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
  return found == limits.end() || (found->second.limit.probes.empty() && found->second.limit.sections.empty()) ? nullptr : &found->second;
}

void ladder_limits(const Study& study, const StudyOptions& options, StudyOutcome& outcome) {
  for (const auto& [scene, spec] : study.limits)
    for (const QuantitySpec& quantity : study.quantities)
      if (!spec.ladder.empty() && (!quantity.scene || *quantity.scene == scene)) one_ladder_limit(study, quantity, scene, spec.ladder, options, outcome);
}

}  // namespace femsph::compare
