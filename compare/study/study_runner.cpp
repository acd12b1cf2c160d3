#include "compare/study/study_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/measure/errors.hpp"
#include "compare/measure/reduce.hpp"
#include "compare/study/study_limits.hpp"

namespace femsph::compare {
namespace {

Row row_of(const Study& study, const PlannedRun& run, const QuantitySpec& quantity) {
  Row row;
  row.study = study.name;
  row.case_name = run.case_name;
  row.method = run.label;
  if (run.resolution.spacing > 0) row.spacing_mm = 1e3 * run.resolution.spacing;
  row.quantity = quantity.name;
  row.unit = quantity.observed.unit.name;
  row.ladder = run.ladder;
  row.scene = run.scene;
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
  row.units = double(result.price.units);
  row.dof = double(result.points) * scene.dim();
  row.memory_mb = double(result.price.bytes) / 1e6;
  row.total_cpu_s = row.total_cpu_min_s = row.total_cpu_max_s = result.price.total_cpu;
  row.repeats = 1;
  row.ns_per_unit_step = result.price.nanoseconds();
  const double supplied = std::abs(ledger.external) + ledger.initial;
  if (supplied > 0) row.energy_imbalance_percent = 100 * ledger.imbalance() / supplied;
  row.momentum_error = result.momentum_error;
  if (scene.settling) row.settled = result.settled;
}

void add_drift(const RunResult& result, Row& row) {
  const auto scalar = [&](const char* name) {
    return result.scalars.contains(name) ? std::optional(result.scalars.at(name)) : std::nullopt;
  };
  row.energy_drift = scalar("energy_drift"), row.momentum_drift = scalar("momentum_drift");
  row.angular_momentum_drift = scalar("angular_momentum_drift"),
  row.hourglass_share = scalar("hourglass_share");
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

/// Removes a doubtful limit: nothing is compared with it.
void forget_limit(const QuantitySpec& quantity, Row& row) {
  row.limit.reset(), row.error_vs_limit_percent.reset(), row.limit_known_percent.reset();
  if (quantity.reduce == Reduce::l2 && !row.error_percent)
    row.value.reset(), row.failure = "no limit: " + row.limit_doubt;
}

// The rows of one run; a quantity that cannot be computed is a row with the reason.
std::vector<Row> rows_of(const Study& study, const PlannedRun& run, const RunResult* result,
                         const RunResult& partial, const std::string& failure, const StaticLimits& limits) {
  const Scene& scene = study.scenes.at(run.scene);
  std::vector<Row> rows;
  for (const QuantitySpec& quantity : study.quantities) {
    if (!quantity.is_of(run)) continue;
    Row row = row_of(study, run, quantity);
    row.failure = failure;
    add_drift(result ? *result : partial, row);
    if (!result && partial.price.steps > 0)
      row.steps = double(partial.price.steps), row.cpu_s = partial.price.cpu;
    if (result) {
      add_cost(*result, scene, row);
      try {
        const KnownLimit* known = limit_of(limits, run.scene);
        const Reduced reduced = reduce(quantity, *result, scene, known ? &known->limit : nullptr);
        row.value = reduced.value;
        row.theory = reduced.theory, row.error_percent = reduced.error_percent;
        if (reduced.limit && !known->coarser.probes.empty())
          if (const auto coarser = reduce(quantity, *result, scene, &known->coarser).limit;
              coarser && *reduced.limit != 0)
            row.limit_known_percent = 100 * std::abs(*coarser / *reduced.limit - 1);
        row.limit = reduced.limit, row.error_vs_limit_percent = reduced.error_vs_limit_percent;
        if (row.error_vs_limit_percent) row.limit_doubt = doubt_of(quantity, scene, *known);
        if (!row.limit_doubt.empty()) forget_limit(quantity, row);
        if (row.settled == false)
          row.error_percent = row.error_vs_limit_percent =
              {};  // the error of a state that has not settled is not that of the method
      } catch (const std::exception& e) {
        row.failure = e.what();
      }
    }
    add_paper(study, row);
    rows.push_back(row);
  }
  return rows;
}

std::string line_of(const Study& study, const PlannedRun& run, const std::vector<Row>& rows,
                    const std::string& failure) {
  std::string line = fmt::format("{} {} {}", study.name, run.case_name, run.label);
  if (!failure.empty()) return line + " failed: " + failure;
  if (!rows.empty() && rows[0].spacing_mm) line += fmt::format(" {:g} mm", *rows[0].spacing_mm);
  for (const Row& row : rows) {
    line += row.value ? fmt::format("  {} {} {}", row.quantity, rounded(*row.value), row.unit)
                      : fmt::format("  {}: {}", row.quantity, row.failure);
    if (!row.limit_doubt.empty()) line += " (no limit: table.md says why)";
    if (row.error_percent && row.theory) line += fmt::format(" ({:+.2f} %)", *row.error_percent);
  }
  if (!rows.empty() && rows[0].settled == false) line += "  NOT SETTLED";
  if (!rows.empty() && rows[0].cpu_s) line += fmt::format("  {:.2f} s CPU", *rows[0].cpu_s);
  return line;
}

RunOptions options_of(const Study& study, const PlannedRun& run, const StudyOptions& options) {
  RunOptions run_options;
  run_options.march = run.march;
  run_options.label = fmt::format("{} {} {}", study.name, run.case_name, run.label);
  run_options.command = options.command;
  for (const QuantitySpec& q : study.quantities)
    if (!q.observed.scalar.empty() && q.is_of(run)) run_options.scalars.insert(q.observed.scalar);
  if (!study.bounds.empty()) run_options.scalars.insert("energy_drift");
  return run_options;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// CPU times of all repetitions of a run, s.
struct Costs {
  std::vector<double> march, total;
};
void add_costs(const Costs& costs, const RunResult& result, Row& row) {
  row.cpu_s = median(costs.march);
  row.total_cpu_s = median(costs.total);
  row.total_cpu_min_s = *std::min_element(costs.total.begin(), costs.total.end());
  row.total_cpu_max_s = *std::max_element(costs.total.begin(), costs.total.end());
  row.repeats = double(costs.total.size());
  if (result.price.steps && result.price.units)
    row.ns_per_unit_step = 1e9 * *row.cpu_s / (double(result.price.steps) * double(result.price.units));
}

bool same_numbers(const RunResult& a, const RunResult& b) {
  if (a.price.steps != b.price.steps || a.history.columns.size() != b.history.columns.size()) return false;
  for (std::size_t c = 0; c < a.history.columns.size(); ++c)
    if (a.history.columns[c].values != b.history.columns[c].values) return false;
  return true;
}

/// Repeats every run to measure its time again. A round makes all runs one after another, so that other load
/// on the machine affects all methods alike.
void repeat_runs(const Study& study, const Engine& engine, const StudyOptions& options,
                 StudyOutcome& outcome) {
  std::vector<Costs> costs;
  for (const FinishedRun& run : outcome.runs)
    costs.push_back({{run.result.price.cpu}, {run.result.price.total_cpu}});
  for (int round = 2; round <= study.repeat; ++round) {
    if (options.log)
      options.log(fmt::format("{}: all runs again, {} of {}", study.name, round, study.repeat));
    for (std::size_t k = 0; k < outcome.runs.size(); ++k) {
      const FinishedRun& run = outcome.runs[k];
      try {
        const RunResult again = engine.run(study.scenes.at(run.plan->scene), run.plan->methods,
                                           run.plan->resolution, options_of(study, *run.plan, options));
        if (!same_numbers(run.result, again))
          throw std::runtime_error("a repeated run gave different results");
        costs[k].march.push_back(again.price.cpu);
        costs[k].total.push_back(again.price.total_cpu);
      } catch (const std::exception& e) {
        ++outcome.failures;
        if (options.log)
          options.log(fmt::format(
              "{} {} {} repeated: {}", study.name, run.plan->case_name, run.plan->label, e.what()));
      }
      for (std::size_t row = run.first_row; row < run.first_row + run.row_count; ++row)
        add_costs(costs[k], run.result, outcome.rows[row]);
    }
    if (options.after_run) options.after_run(outcome);
  }
}

void make_run(const Study& study, const PlannedRun& run, const Engine& engine, const StudyOptions& options,
              const StaticLimits& limits, StudyOutcome& outcome) {
  RunOptions run_options = options_of(study, run, options);
  RunResult partial;
  run_options.partial = &partial;
  run_options.warn = [&](const std::string& text) {  // each text once
    if (outcome.warnings.insert(text).second && options.log) options.log("warning: " + text);
  };
  std::optional<RunResult> result;
  std::string failure;
  try {
    result = engine.run(study.scenes.at(run.scene), run.methods, run.resolution, run_options);
  } catch (const std::exception& e) {
    failure = e.what();
  }
  const auto rows = rows_of(study, run, result ? &*result : nullptr, partial, failure, limits);
  const bool lacking = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.value; });
  outcome.failures += lacking || !failure.empty();
  const std::size_t first = outcome.rows.size();
  outcome.rows.insert(outcome.rows.end(), rows.begin(), rows.end());
  if (result) outcome.runs.push_back({&run, std::move(*result), first, rows.size()});
  if (options.log) options.log(line_of(study, run, rows, failure));
  if (options.after_run) options.after_run(outcome);
}

}  // namespace

StudyOutcome run_study(const Study& study, const Engine& engine, const StudyOptions& options) {
  StudyOutcome outcome;
  const StaticLimits limits = static_limits(study, engine, options, outcome);
  for (const PlannedRun& run : study.runs)
    if (!options.quick || run.quick) make_run(study, run, engine, options, limits, outcome);
  ladder_limits(study, options, outcome);
  if (study.repeat > 1 && !options.quick) repeat_runs(study, engine, options, outcome);
  return outcome;
}

}  // namespace femsph::compare
