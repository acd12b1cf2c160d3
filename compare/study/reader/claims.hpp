#pragma once
// Claims: statements of the paper that are checked with the rows of a table.

#include <optional>
#include <string>
#include <vector>

#include "compare/report/table.hpp"

namespace femsph::compare {

/// Selects rows; what is not given matches all.
struct RowFilter {
  std::optional<std::string> study, method, quantity;
  std::vector<std::string> cases;  ///< any of them; empty: all
  std::optional<double> spacing_mm;
  bool matches(const Row& row) const;
  std::string describe() const;
};

struct Claim {
  enum class Kind {
    value,    ///< |error| or value of the rows is the paper's number, within `tolerance`
    below,    ///< |error| of the rows is below `bound` percent
    above,    ///< |error| of the rows is above `bound` percent
    ratio,    ///< |error| of the row over that of the `other` row is the paper's ratio, within `factor`
    order,    ///< observed order of the ladder is between `low` and `high`
    finer,    ///< to reach the |error| of the `other` row, the rows must be finer by the paper's ratio,
              ///< within `factor`
    larger,   ///< the rows are larger in magnitude than the reference
    smaller,  ///< the rows are smaller
  };
  std::string id, source, text, note;
  Kind kind = Kind::value;
  RowFilter rows, other;
  Reference reference = Reference::theory;
  bool of_value = false;        ///< kind value: compare the value, not the error
  std::optional<double> paper;  ///< the paper's number: percent, ratio, or in the row's unit
  double tolerance = 0, bound = 0, factor = 1, low = 0, high = 0;
};

struct Verdict {
  enum class Holds { yes, no, partly, unknown } holds = Holds::unknown;
  const Claim* claim = nullptr;
  std::string paper, ours;  ///< numbers with their units
  std::string note;         ///< remarks of the evaluation; the claim's own note if it does not hold
};

/// Checks every claim against the rows. `unknown` if a row is missing or has no number; of several cases
/// all must be there.
std::vector<Verdict> judge(const std::vector<Claim>& claims, const std::vector<Row>& rows);

std::string csv(const std::vector<Verdict>& verdicts);
std::string markdown(const std::vector<Verdict>& verdicts);

}  // namespace femsph::compare
