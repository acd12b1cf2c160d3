// [[bounds]] and [[expectations]] of a study: bounds that every run must keep, and runs that must fail.

#include <fmt/format.h>

#include <algorithm>

#include "compare/study/reader/study_page.hpp"
#include "compare/study/reader/study_reading.hpp"

namespace femsph::compare {
namespace {

std::vector<Key> row_keys() {
  return {{"cases", key_holds::texts, "Only of these cases."},
          {"methods", key_holds::texts, "Only of these labels (names of methods in tables)."}};
}

std::optional<double> not_negative(Fields& fields, const char* key) {
  const auto value = fields.number(key, Need::optional);
  if (!value || *value >= 0) return value;
  fields.fault(key, fmt::format("\"{}\" is {}; expected a number not below 0", key, *value));
  return {};
}

Key row_quantity_key() { return {"quantity", "a text: a quantity of this study", "Only of this quantity."}; }

/// Whether some run of these cases and methods gives a quantity for which `fits` is true.
template <class Fits>
bool some_row(const Study& study, const std::vector<std::string>& cases,
              const std::vector<std::string>& methods, Fits fits) {
  for (const PlannedRun& run : study.runs)
    if (listed(cases, run.case_name) && listed(methods, run.label))
      for (const QuantitySpec& quantity : study.quantities)
        if (quantity.is_of(run) && fits(quantity)) return true;
  return false;
}

/// A bound must hold for some row.
void check_bound(const Fields& fields, const Bound& bound, const Study& study) {
  const auto named = [&](const QuantitySpec& q) {
    return bound.quantity.empty() || q.name == bound.quantity;
  };
  if (!some_row(study, bound.cases, bound.methods, named))
    fields.fault(bound.quantity.empty() ? "cases" : "quantity",
                 "no run gives these cases, methods and quantity together; expected words of one run");
  else if (bound.error_percent && !some_row(study, bound.cases, bound.methods, [&](const QuantitySpec& q) {
             return named(q) && (q.theory || q.reference);
           }))
    fields.fault(
        "error_percent",
        "no quantity of this bound has a theory or a reference, which an error needs; expected one that has");
}

/// The quantity of a table, empty if it names none. Whether it is one of the study.
bool read_quantity(Fields& fields, const StudyReading& reading, std::string& quantity) {
  const auto known = quantity_names(reading.study);
  quantity = fields.text("quantity", Need::optional).value_or("");
  return quantity.empty() ||
         require_known(fields, "quantity", "quantity", quantity, known, reading.quantities_known);
}

void one_bound(Fields& fields, StudyReading& reading) {
  const Study& study = reading.study;
  Bound bound;
  bound.cases = read_names(fields, "cases", case_names(study), "case", reading.runs_known);
  bound.methods = read_names(fields, "methods", method_labels(study), "method", reading.runs_known);
  const bool is_known = read_quantity(fields, reading, bound.quantity);
  bound.energy_drift = not_negative(fields, "energy_drift");
  bound.momentum_drift = not_negative(fields, "momentum_drift");
  bound.angular_momentum_drift = not_negative(fields, "angular_momentum_drift");
  bound.hourglass_share = not_negative(fields, "hourglass_share");
  bound.error_percent = not_negative(fields, "error_percent");
  bound.low = fields.number("low", Need::optional);
  bound.high = fields.number("high", Need::optional);
  if (bound.low && bound.high && *bound.low > *bound.high)
    fields.fault("low", "\"low\" is above \"high\"; expected it below");
  fields.done();
  if (is_known && reading.runs_known && reading.quantities_known) check_bound(fields, bound, study);
  reading.study.bounds.push_back(bound);
}

void one_expectation(Fields& fields, StudyReading& reading, bool bounds_known) {
  Expectation expectation;
  expectation.cases = read_names(fields, "cases", case_names(reading.study), "case", reading.runs_known);
  expectation.methods = read_names(
      fields, "methods", method_labels(reading.study), "method", reading.runs_known);
  const bool is_known = read_quantity(fields, reading, expectation.quantity);
  expectation.messages =
      fields.texts("messages", Need::required, "a list of words, one of which the message contains")
          .value_or(std::vector<std::string>{});
  expectation.reason = fields.text("reason", Need::required, "why it must fail").value_or("");
  fields.done();
  if (is_known && reading.runs_known && reading.quantities_known &&
      !some_row(reading.study, expectation.cases, expectation.methods, [&](const QuantitySpec& q) {
        return expectation.quantity.empty() || q.name == expectation.quantity;
      }))
    fields.fault(
        "cases", expectation.quantity.empty()
                     ? "no run has these cases and methods together; expected words of one run"
                     : "no run gives these cases, methods and quantity together; expected words of one run");
  if (reading.study.bounds.empty() && bounds_known)
    fields.fault("messages", "[[expectations]] without [[bounds]]; expected bounds that the failure breaks");
  reading.study.expectations.push_back(expectation);
}

}  // namespace

KeyTable bound_keys() {
  KeyTable table{"[[bounds]]",
                 "Bounds that rows must keep; the study's table then shows verdicts. Where several tables "
                 "match a row, the last one that gives a bound counts.",
                 row_keys()};
  for (const Key& key : std::vector<Key>{
           row_quantity_key(),
           {"energy_drift", key_holds::number, "Upper bound of the energy error over the largest energy."},
           {"momentum_drift", key_holds::number,
            "Upper bound of the change of the total momentum over its scale."},
           {"angular_momentum_drift", key_holds::number,
            "Upper bound of the change of the total angular momentum over its scale."},
           {"hourglass_share", key_holds::number,
            "Upper bound of the hourglass energy over the internal energy."},
           {"error_percent", key_holds::number, "Upper bound of the magnitude of the error, percent."},
           {"low", key_holds::number, "The least value, in the unit of the table."},
           {"high", key_holds::number, "The largest value, in the unit of the table."}})
    table.keys.push_back(key);
  return table;
}

KeyTable expectation_keys() {
  KeyTable table{"[[expectations]]", "Runs that must fail, in a study with [[bounds]].", row_keys()};
  table.keys.push_back(row_quantity_key());
  table.keys.push_back({"messages", key_holds::texts,
                        "The message of the failure, or of the broken bound, contains one of these.", true});
  table.keys.push_back({"reason", key_holds::text, "Why it must fail.", true});
  return table;
}

void read_bounds(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("bounds")) one_bound(fields, reading);
  const bool bounds_known = !root.misspelt({"bounds"});
  for (Fields& fields : root.tables("expectations")) one_expectation(fields, reading, bounds_known);
}

}  // namespace femsph::compare
