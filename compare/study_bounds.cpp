// [[bounds]] and [[expectations]] of a study: what every run must keep, and which must fail.

#include <fmt/format.h>

#include <algorithm>

#include "compare/study_reading.hpp"

namespace femsph::compare {
namespace {

std::optional<double> not_negative(Fields& fields, const char* key) {
  const auto value = fields.number(key, Need::optional);
  if (!value || *value >= 0) return value;
  fields.fault(key, fmt::format("\"{}\" is {}; expected a number not below 0", key, *value));
  return {};
}

void one_bound(Fields& fields, StudyReading& reading) {
  const Study& study = reading.study;
  Bound bound;
  bound.cases = read_names(fields, "cases", case_names(study), "case");
  bound.methods = read_names(fields, "methods", method_labels(study), "method");
  const auto known = quantity_names(study);
  bound.quantity = fields.text("quantity", Need::optional).value_or("");
  if (!bound.quantity.empty() && std::find(known.begin(), known.end(), bound.quantity) == known.end())
    fields.fault("quantity", fmt::format("unknown quantity {}; expected {}{}", in_quotes(bound.quantity), one_of(known), did_you_mean(bound.quantity, known)));
  bound.energy_drift = not_negative(fields, "energy_drift");
  bound.momentum_drift = not_negative(fields, "momentum_drift");
  bound.angular_momentum_drift = not_negative(fields, "angular_momentum_drift");
  bound.hourglass_share = not_negative(fields, "hourglass_share");
  bound.error_percent = not_negative(fields, "error_percent");
  bound.low = fields.number("low", Need::optional);
  bound.high = fields.number("high", Need::optional);
  if (bound.low && bound.high && *bound.low > *bound.high) fields.fault("low", "\"low\" lies above \"high\", so that nothing can be between; expected it below");
  fields.done();
  reading.study.bounds.push_back(bound);
}

void one_expectation(Fields& fields, StudyReading& reading) {
  Expectation expectation;
  expectation.cases = read_names(fields, "cases", case_names(reading.study), "case");
  expectation.methods = read_names(fields, "methods", method_labels(reading.study), "method");
  expectation.messages = fields.texts("messages", Need::required, "a list of words, of which the failure says one").value_or(std::vector<std::string>{});
  expectation.reason = fields.text("reason", Need::required, "why it must fail").value_or("");
  fields.done();
  if (reading.study.bounds.empty()) fields.fault("messages", "[[expectations]] without [[bounds]]; expected bounds that the failure breaks");
  reading.study.expectations.push_back(expectation);
}

}  // namespace

void read_bounds(Fields& root, StudyReading& reading) {
  for (Fields& fields : root.tables("bounds")) one_bound(fields, reading);
  for (Fields& fields : root.tables("expectations")) one_expectation(fields, reading);
}

}  // namespace femsph::compare
