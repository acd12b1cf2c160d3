#include "compare/study/reader/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/input/faults.hpp"

namespace femsph::compare {
namespace {

/// All bounds that hold for a row.
Bound bound_of(const std::vector<Bound>& bounds, const Row& row) {
  Bound all;
  for (const Bound& b : bounds) {
    if (!listed(b.cases, row.case_name) || !listed(b.methods, row.method) ||
        (!b.quantity.empty() && b.quantity != row.quantity))
      continue;
    for (const auto member : {&Bound::energy_drift, &Bound::momentum_drift, &Bound::angular_momentum_drift,
                              &Bound::hourglass_share, &Bound::error_percent, &Bound::low, &Bound::high})
      if (b.*member) all.*member = b.*member;
  }
  return all;
}

/// All bounds that a row breaks, in one sentence; empty if it keeps all.
std::string broken(const Bound& bound, const Row& row) {
  if (!row.failure.empty()) return row.failure;
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  const auto drift =
      [&](const char* what, const std::optional<double>& value, const std::optional<double>& most) {
        if (most && value && !(*value <= *most))
          add(fmt::format("{} {} is above {:g}", what, rounded(*value, 3), *most));
        if (most && !value) add(fmt::format("{} is not known", what));
      };
  drift("energy drift", row.energy_drift, bound.energy_drift);
  drift("momentum drift", row.momentum_drift, bound.momentum_drift);
  drift("angular momentum drift", row.angular_momentum_drift, bound.angular_momentum_drift);
  drift("hourglass share", row.hourglass_share, bound.hourglass_share);
  if (bound.error_percent && !row.error_percent)
    add(fmt::format("the error of {} is not known", row.quantity));
  if (bound.error_percent && row.error_percent && !(std::abs(*row.error_percent) <= *bound.error_percent))
    add(fmt::format(
        "{} is off by {:+.3g} %, more than {:g} %", row.quantity, *row.error_percent, *bound.error_percent));
  if ((bound.low || bound.high) && !row.value) add(fmt::format("{} is not known", row.quantity));
  if (bound.low && row.value && !(*row.value >= *bound.low))
    add(fmt::format("{} is below {:g} {}", row.quantity, *bound.low, row.unit));
  if (bound.high && row.value && !(*row.value <= *bound.high))
    add(fmt::format("{} is above {:g} {}", row.quantity, *bound.high, row.unit));
  if (row.settled == false) add("not settled within the duration");
  return text;
}

JudgedRow judge_one(const std::vector<Bound>& bounds, const std::vector<Expectation>& expectations,
                    const Row& row) {
  using Verdict = JudgedRow::Verdict;
  JudgedRow judged{Verdict::stable, &row, broken(bound_of(bounds, row), row)};
  const auto expected = std::find_if(expectations.begin(), expectations.end(), [&](const Expectation& e) {
    return listed(e.cases, row.case_name) && listed(e.methods, row.method) &&
           (e.quantity.empty() || e.quantity == row.quantity);
  });
  if (expected == expectations.end()) {
    if (!judged.reason.empty()) judged.verdict = Verdict::failed;
  } else if (judged.reason.empty()) {
    judged.verdict = Verdict::failed;
    judged.reason = fmt::format("did not fail, although {}", expected->reason);
  } else if (std::none_of(expected->messages.begin(), expected->messages.end(),
                          [&](const std::string& m) { return judged.reason.find(m) != std::string::npos; })) {
    judged.verdict = Verdict::failed;
    judged.reason += fmt::format(
        "; expected a failure that says {}, because {}", one_of(expected->messages), expected->reason);
  } else {
    judged.verdict = Verdict::expected_failure;
    judged.reason += fmt::format(" (expected: {})", expected->reason);
  }
  return judged;
}

const char* word(JudgedRow::Verdict verdict) {
  const char* const words[] = {"stable", "expected-failure", "failed"};
  return words[int(verdict)];
}

std::string with_unit(const Row& row) {
  return row.unit.empty() || row.unit == "1" ? row.quantity : fmt::format("{} ({})", row.quantity, row.unit);
}
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '|') c = c == '|' ? '/' : ' ';
  return text;
}

}  // namespace

std::vector<JudgedRow> judge(const std::vector<Bound>& bounds, const std::vector<Expectation>& expectations,
                             const std::vector<Row>& rows) {
  std::vector<JudgedRow> all;
  for (const Row& row : rows) all.push_back(judge_one(bounds, expectations, row));
  return all;
}

std::string csv(const std::vector<JudgedRow>& judged) {
  std::string text =
      "case,method,verdict,reason,energy_drift,momentum_drift,angular_momentum_drift,hourglass_share,"
      "quantity,value,reference,error_percent,steps,cpu_s\r\n";
  for (const JudgedRow& j : judged) {
    const Row& r = *j.row;
    text += csv_line({r.case_name, r.method, word(j.verdict), one_line(j.reason), csv_number(r.energy_drift),
                      csv_number(r.momentum_drift), csv_number(r.angular_momentum_drift),
                      csv_number(r.hourglass_share), with_unit(r), csv_number(r.value), csv_number(r.theory),
                      csv_number(r.error_percent), csv_number(r.steps), csv_number(r.cpu_s)});
  }
  return text;
}

std::string markdown(const std::vector<JudgedRow>& judged) {
  std::array<int, 3> count{};
  const auto small = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.1e}", *value) : "";
  };
  const auto number = [](const std::optional<double>& value, int digits) {
    return value ? rounded(*value, digits) : "";
  };
  std::vector<std::vector<std::string>> cells = {
      {"case", "method", "verdict", "energy drift", "momentum drift", "angular", "hourglass", "quantity",
       "value", "reference", "error %", "steps", "CPU s", "why"}};
  for (const JudgedRow& j : judged) {
    const Row& r = *j.row;
    ++count[std::size_t(j.verdict)];
    cells.push_back(
        {r.case_name, r.method, word(j.verdict), small(r.energy_drift), small(r.momentum_drift),
         small(r.angular_momentum_drift), small(r.hourglass_share), with_unit(r), number(r.value, 4),
         number(r.theory, 4), r.error_percent ? fmt::format("{:+.3g}", *r.error_percent) : "",
         r.steps ? fmt::format("{:.9g}", *r.steps) : "", number(r.cpu_s, 2), one_line(j.reason)});
  }
  return fmt::format("{} rows: {} stable, {} fail as expected, {} failed.\n\n", judged.size(), count[0],
                     count[1], count[2]) +
         markdown_table(cells);
}

}  // namespace femsph::compare
