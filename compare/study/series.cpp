#include "compare/study/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/measure/errors.hpp"
#include "compare/measure/reduce.hpp"
#include "compare/reference/theory.hpp"

namespace femsph::compare {
namespace {

struct NamedCurve {
  std::string name;
  std::vector<double> values;
};

std::string wide_csv(const std::string& x_name, const std::vector<std::string>& x,
                     const std::vector<NamedCurve>& curves) {
  std::string text = csv_cell(x_name);
  for (const NamedCurve& curve : curves) text += "," + csv_cell(curve.name);
  text += "\r\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    text += csv_cell(x[i]);
    for (const NamedCurve& curve : curves) text += "," + csv_number(curve.values[i]);
    text += "\r\n";
  }
  return text;
}

std::vector<std::string> as_text(const std::vector<double>& x) {
  std::vector<std::string> text;
  for (const double value : x) text.push_back(csv_number(value));
  return text;
}

// Errors over the spacing, coarse to fine, or over the cases, in the order of the series or of the runs: one
// column for each method.
std::string error_csv(const SeriesSpec& series, const StudyOutcome& outcome) {
  const bool over_cases = series.kind == SeriesSpec::Kind::cases;
  std::vector<const Row*> rows;
  for (const Row& row : outcome.rows)
    if (row.quantity == series.quantity && row.spacing_mm && error_of(row, series.reference) &&
        listed(series.cases, row.case_name) && listed(series.methods, row.method))
      rows.push_back(&row);
  std::vector<const Row*> sorted = rows;
  const auto listed_at = [&](const Row& row) {
    return std::find(series.cases.begin(), series.cases.end(), row.case_name) - series.cases.begin();
  };
  if (over_cases)
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Row* a, const Row* b) { return listed_at(*a) < listed_at(*b); });
  else
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Row* a, const Row* b) { return *a->spacing_mm > *b->spacing_mm; });
  const auto place = [&](const Row& row) { return over_cases ? row.case_name : csv_number(*row.spacing_mm); };
  std::vector<std::string> x;
  for (const Row* row : sorted)
    if (std::find(x.begin(), x.end(), place(*row)) == x.end()) x.push_back(place(*row));
  std::vector<NamedCurve> curves;
  for (const Row* row : rows) {
    auto curve = std::find_if(
        curves.begin(), curves.end(), [&](const NamedCurve& c) { return c.name == row->method; });
    if (curve == curves.end())
      curve = curves.insert(curves.end(), {row->method, std::vector<double>(x.size(), std::nan(""))});
    double& value = curve->values[std::find(x.begin(), x.end(), place(*row)) - x.begin()];
    const double error = *error_of(*row, series.reference);
    if (!std::isnan(value) && value != error)
      throw std::runtime_error(fmt::format(
          "{} has two values of {} at {}; expected \"cases\" that choose one", row->method, series.quantity,
          place(*row)));
    value = error;
  }
  return wide_csv(over_cases ? "case" : "spacing_mm", x, curves);
}

std::vector<const FinishedRun*> shown_runs(const SeriesSpec& series, const StudyOutcome& outcome) {
  std::vector<const FinishedRun*> shown;
  for (const FinishedRun& run : outcome.runs)
    if (listed(series.cases, run.plan->case_name) && listed(series.methods, run.plan->label) &&
        (!series.scene || *series.scene == run.plan->scene))
      shown.push_back(&run);
  return shown;
}

// By what the series selects, so that a column keeps its name when some of its runs are missing.
std::string curve_name(const SeriesSpec& series, const PlannedRun& run) {
  if (series.cases.size() == 1) return run.label;
  return series.methods.size() == 1 ? run.case_name : run.label + " " + run.case_name;
}

std::vector<double> grid(const std::vector<Curve>& curves, bool history) {
  if (curves.empty()) return {};
  const auto longest = std::max_element(
      curves.begin(), curves.end(), [](const Curve& a, const Curve& b) { return a.at.back() < b.at.back(); });
  if (!history || curves.size() == 1) return longest->at;
  std::vector<double> x(401);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = longest->at.back() * double(i) / double(x.size() - 1);
  return x;
}

std::vector<double> theory_values(const SeriesSpec& series, const Scene& scene,
                                  const std::vector<double>& x) {
  const Theory& theory = theory_named(*series.theory);
  std::vector<double> values;
  for (const double at : x) {
    Point point{};
    if (series.kind == SeriesSpec::Kind::profile)
      point = section_point(section_named(scene, series.observed.section), at);
    for (const Probe& probe : scene.probes)
      if (probe.name == series.observed.probe) point = probe.point;
    values.push_back(theory.value(scene, point, at) / series.observed.unit.factor);
  }
  return values;
}

std::string curves_csv(const SeriesSpec& series, const Study& study, const StudyOutcome& outcome) {
  const bool history = series.kind == SeriesSpec::Kind::history;
  const auto runs = shown_runs(series, outcome);
  std::vector<Curve> raw;
  for (const FinishedRun* run : runs) raw.push_back(curve_of(series.observed, run->result));
  std::vector<double> x = grid(raw, history);
  std::vector<NamedCurve> curves;
  for (std::size_t i = 0; i < raw.size(); ++i)
    curves.push_back({curve_name(series, *runs[i]->plan), resample(raw[i].at, raw[i].value, x)});
  if (series.theory && !series.scene)
    for (const FinishedRun* run : runs)
      if (run->plan->scene != runs[0]->plan->scene)
        throw std::runtime_error(
            "its runs have several scenes with different theory values; expected \"scene\", which selects "
            "one");
  if (series.theory && !runs.empty())
    curves.push_back(
        {"theory", theory_values(series, study.scenes.at(series.scene.value_or(runs[0]->plan->scene)), x)});
  for (double& at : x) at /= history ? series.time_unit.factor : 1e-3;
  return wide_csv(history ? "time_" + series.time_unit.name : "distance_mm", as_text(x), curves);
}

// One quantity over another, sample by sample: two columns a run.
std::string path_csv(const SeriesSpec& series, const StudyOutcome& outcome) {
  std::vector<NamedCurve> columns;
  std::size_t rows = 0;
  for (const FinishedRun* run : shown_runs(series, outcome)) {
    const std::string name = curve_name(series, *run->plan);
    columns.push_back({name + " along", curve_of(series.along, run->result).value});
    columns.push_back({name, curve_of(series.observed, run->result).value});
    rows = std::max(rows, columns.back().values.size());
  }
  std::vector<std::string> number;
  for (std::size_t i = 0; i < rows; ++i) number.push_back(fmt::format("{}", i));
  for (NamedCurve& c : columns) c.values.resize(rows, std::nan(""));
  return wide_csv("sample", number, columns);
}

}  // namespace

std::string series_csv(const SeriesSpec& series, const Study& study, const StudyOutcome& outcome) {
  if (series.kind == SeriesSpec::Kind::path) return path_csv(series, outcome);
  const bool curves = series.kind == SeriesSpec::Kind::history || series.kind == SeriesSpec::Kind::profile;
  return curves ? curves_csv(series, study, outcome) : error_csv(series, outcome);
}

}  // namespace femsph::compare
