#pragma once
// Whether runs are stable: bounds that every row must keep, failures that must occur, and the verdict on each
// row.

#include <algorithm>

#include "compare/report/table.hpp"

namespace femsph::compare {

/// `name` is one of `names`; a list without names means all.
inline bool listed(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Bounds for the rows of some cases, methods and a quantity (empty: all). Where several match, the last one
/// that gives a bound counts.
struct Bound {
  std::vector<std::string> cases, methods;
  std::string quantity;
  std::optional<double> energy_drift, momentum_drift, angular_momentum_drift,
      hourglass_share;                  ///< fractions
  std::optional<double> error_percent;  ///< largest magnitude of the error against theory or reference
  std::optional<double> low, high;      ///< smallest and largest value, in the unit of the table
};

/// Runs that must fail: the run stops, or a row breaks a bound, with a message that contains one of
/// `messages`.
struct Expectation {
  std::vector<std::string> cases, methods;
  std::vector<std::string> messages;
  std::string reason;         ///< why they must fail
  std::string quantity = {};  ///< rows of this quantity alone; empty: of all
};

struct JudgedRow {
  enum class Verdict { stable, expected_failure, failed } verdict = Verdict::failed;
  const Row* row = nullptr;
  std::string reason;  ///< broken bounds or the failure; empty if there are none
};

/// An expected failure that does not occur is a failed row.
std::vector<JudgedRow> judge(const std::vector<Bound>& bounds, const std::vector<Expectation>& expectations,
                             const std::vector<Row>& rows);

/// case, method, verdict, reason, the drifts, quantity, value, reference, error_percent, steps, cpu_s.
std::string csv(const std::vector<JudgedRow>& judged);
/// The counts of the verdicts, and one table.
std::string markdown(const std::vector<JudgedRow>& judged);

}  // namespace femsph::compare
