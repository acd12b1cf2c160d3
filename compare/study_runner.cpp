#include "compare/study_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/errors.hpp"
#include "compare/reduce.hpp"

namespace femsph::compare {
namespace {

using Limits = std::map<std::string, fem::StaticLimit>;

Limits static_limits(const Study& study, const Engine& engine, const StudyOptions& options, StudyOutcome& outcome) {
  Limits limits;
  if (!study.limit) return limits;
  for (const PlannedRun& run : study.runs) {
    if ((options.quick && !run.quick) || limits.contains(run.scene)) continue;
    try {
      limits[run.scene] = engine.limit(study.scenes.at(run.scene), study.limit->divisions, study.limit->degree);
    } catch (const std::exception& e) {
      limits[run.scene] = {};
      ++outcome.failures;
      if (options.log) options.log(fmt::format("{} limit of {}: {}", study.name, run.scene, e.what()));
    }
  }
  return limits;
}

Row row_of(const Study& study, const PlannedRun& run, const QuantitySpec& quantity) {
  Row row;
  row.study = study.name;
  row.case_name = run.case_name;
  row.method = run.label;
  if (run.resolution.spacing > 0) row.spacing_mm = 1e3 * run.resolution.spacing;
  row.quantity = quantity.name;
  row.unit = quantity.observed.unit.name;
  row.ladder = run.ladder;
  return row;
}

void add_cost(const RunResult& result, const Scene& scene, Row& row) {
  const Ledger& ledger = result.ledger;
  row.spacing_mm = 1e3 * result.spacing;
  row.cells_over_height = result.cells_over_height;
  row.steps = double(result.price.steps);
  row.dt_s = result.price.dt;
  row.cpu_s = result.price.cpu;
  row.wall_s = result.price.wall;
  row.threads = result.price.threads;
  row.points = double(result.points);
  row.ns_per_unit_step = result.price.nanoseconds();
  const double supplied = std::abs(ledger.external) + ledger.initial;
  if (supplied > 0) row.energy_imbalance_percent = 100 * ledger.imbalance() / supplied;
  row.momentum_error = result.momentum_error;
  if (scene.settling) row.settled = result.settled;
}

void add_drift(const RunResult& result, Row& row) {
  const auto scalar = [&](const char* name) { return result.scalars.contains(name) ? std::optional(result.scalars.at(name)) : std::nullopt; };
  row.energy_drift = scalar("energy_drift"), row.momentum_drift = scalar("momentum_drift");
  row.angular_momentum_drift = scalar("angular_momentum_drift"), row.hourglass_share = scalar("hourglass_share");
}

void add_paper(const Study& study, Row& row) {
  for (const PaperNumber& number : study.paper) {
    if (!number.rows.matches(row)) continue;
    if (number.value) row.paper = number.value;
    if (number.error_percent)
      row.paper_error_percent = number.error_percent;
    else if (number.value && row.theory)
      row.paper_error_percent = percent_error(*number.value, *row.theory);
  }
}

const fem::StaticLimit* limit_of(const Limits& limits, const std::string& scene) {
  const auto found = limits.find(scene);
  return found == limits.end() || (found->second.probes.empty() && found->second.sections.empty()) ? nullptr : &found->second;
}

// The rows of one run; a quantity that cannot be taken is a row with the reason.
std::vector<Row> rows_of(const Study& study, const PlannedRun& run, const RunResult* result, const RunResult& partial,
                         const std::string& failure, const Limits& limits) {
  const Scene& scene = study.scenes.at(run.scene);
  std::vector<Row> rows;
  for (const QuantitySpec& quantity : study.quantities) {
    if (!quantity.is_of(run)) continue;
    Row row = row_of(study, run, quantity);
    row.failure = failure;
    add_drift(result ? *result : partial, row);
    if (!result && partial.price.steps > 0) row.steps = double(partial.price.steps), row.cpu_s = partial.price.cpu;
    if (result) {
      add_cost(*result, scene, row);
      try {
        const Reduced reduced = reduce(quantity, *result, scene, limit_of(limits, run.scene));
        row.value = reduced.value;
        row.theory = reduced.theory, row.error_percent = reduced.error_percent;
        row.limit = reduced.limit, row.error_vs_limit_percent = reduced.error_vs_limit_percent;
      } catch (const std::exception& e) {
        row.failure = e.what();
      }
    }
    add_paper(study, row);
    rows.push_back(row);
  }
  return rows;
}

std::string line_of(const Study& study, const PlannedRun& run, const std::vector<Row>& rows, const std::string& failure) {
  std::string line = fmt::format("{} {} {}", study.name, run.case_name, run.label);
  if (!failure.empty()) return line + " failed: " + failure;
  if (!rows.empty() && rows[0].spacing_mm) line += fmt::format(" {:g} mm", *rows[0].spacing_mm);
  for (const Row& row : rows) {
    line += row.value ? fmt::format("  {} {} {}", row.quantity, rounded(*row.value), row.unit)
                      : fmt::format("  {}: {}", row.quantity, row.failure);
    if (row.error_percent && row.theory) line += fmt::format(" ({:+.2f} %)", *row.error_percent);
  }
  if (!rows.empty() && rows[0].settled == false) line += "  NOT SETTLED";
  if (!rows.empty() && rows[0].cpu_s) line += fmt::format("  {:.2f} s CPU", *rows[0].cpu_s);
  return line;
}

void make_run(const Study& study, const PlannedRun& run, const Engine& engine, const StudyOptions& options, const Limits& limits,
              StudyOutcome& outcome) {
  RunOptions run_options;
  run_options.march = run.march;
  run_options.label = fmt::format("{} {} {}", study.name, run.case_name, run.label);
  run_options.command = options.command;
  for (const QuantitySpec& q : study.quantities)
    if (!q.observed.scalar.empty() && q.is_of(run)) run_options.scalars.insert(q.observed.scalar);
  if (!study.bounds.empty()) run_options.scalars.insert("energy_drift");
  RunResult partial;
  run_options.partial = &partial;
  std::optional<RunResult> result;
  std::string failure;
  try {
    result = engine.run(study.scenes.at(run.scene), run.method, run.resolution, run_options);
  } catch (const std::exception& e) {
    failure = e.what();
  }
  const auto rows = rows_of(study, run, result ? &*result : nullptr, partial, failure, limits);
  const bool lacking = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.value; });
  outcome.failures += lacking || !failure.empty();
  outcome.rows.insert(outcome.rows.end(), rows.begin(), rows.end());
  if (result) outcome.runs.push_back({&run, std::move(*result)});
  if (options.log) options.log(line_of(study, run, rows, failure));
  if (options.after_run) options.after_run(outcome);
}

}  // namespace

StudyOutcome run_study(const Study& study, const Engine& engine, const StudyOptions& options) {
  StudyOutcome outcome;
  const Limits limits = static_limits(study, engine, options, outcome);
  for (const PlannedRun& run : study.runs)
    if (!options.quick || run.quick) make_run(study, run, engine, options, limits, outcome);
  return outcome;
}

}  // namespace femsph::compare
