#include "compare/study/reader/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/measure/ladder.hpp"
#include "model/input/faults.hpp"

namespace femsph::compare {
namespace {

using Kind = Claim::Kind;
using Holds = Verdict::Holds;

Holds yes_or_no(bool holds) { return holds ? Holds::yes : Holds::no; }

void add_note(Verdict& verdict, const std::string& note) {
  verdict.note += (verdict.note.empty() ? "" : "; ") + note;
}

std::string percent(double value) { return fmt::format("{:+.3g} %", value); }

/// The rows of a filter, if all of them have the number that the claim is about.
std::vector<const Row*> rows_of(const RowFilter& filter, const Claim& claim, const std::vector<Row>& rows,
                                Verdict& verdict) {
  std::vector<const Row*> found;
  int without = 0, unsettled = 0;
  std::vector<std::string> missing = filter.cases;  // of several cases all must be there
  std::string doubt;
  for (const Row& row : rows) {
    if (!filter.matches(row)) continue;
    std::erase(missing, row.case_name);
    const bool usable = row.value && std::isfinite(*row.value) &&
                        (claim.of_value || error_of(row, claim.reference));
    if (claim.reference == Reference::limit && !row.limit_doubt.empty()) doubt = row.limit_doubt;
    unsettled += usable && row.settled == false;
    if (usable)
      found.push_back(&row);
    else
      ++without;
  }
  if (without > 0)
    add_note(verdict, fmt::format("{} row{} without a result ({})", without, without == 1 ? "" : "s",
                                  filter.describe()));
  else if (found.empty())
    add_note(verdict, "no row for " + filter.describe());
  else if (!missing.empty())
    add_note(verdict, "no row of " + one_of(missing));
  if (!doubt.empty()) add_note(verdict, "no limit: " + doubt);
  if (without > 0 || !missing.empty()) found.clear();
  if (!found.empty() && unsettled > 0)
    add_note(verdict, fmt::format("{} row{} not settled", unsettled, unsettled == 1 ? "" : "s"));
  return found;
}

std::string row_text(const Claim& claim, const Row& row) {
  return claim.of_value ? fmt::format("{:.4g} {}", *row.value, row.unit)
                        : percent(*error_of(row, claim.reference));
}

bool row_holds(const Claim& claim, const Row& row) {
  const double error = error_of(row, claim.reference).value_or(0);
  switch (claim.kind) {
    case Kind::below:
      return std::abs(error) < claim.bound;
    case Kind::above:
      return std::abs(error) > claim.bound;
    case Kind::larger:
      return error > 0;
    case Kind::smaller:
      return error < 0;
    default:
      return std::abs(std::abs(claim.of_value ? *row.value : error) - std::abs(*claim.paper)) <=
             claim.tolerance;
  }
}

/// value, below, above, larger, smaller: every row is checked; "partly" if they disagree.
void judge_rows(const Claim& claim, const std::vector<Row>& rows, Verdict& verdict) {
  const auto found = rows_of(claim.rows, claim, rows, verdict);
  if (found.empty()) return;
  std::size_t holding = 0;
  for (const Row* row : found) {
    holding += row_holds(claim, *row);
    verdict.ours += (verdict.ours.empty() ? "" : ", ") + row_text(claim, *row);
  }
  verdict.holds = holding == found.size() ? Holds::yes : holding == 0 ? Holds::no : Holds::partly;
}

bool within_factor(double ours, double paper, double factor) {
  return ours <= paper * factor && ours >= paper / factor;
}

void judge_ratio(const Claim& claim, const std::vector<Row>& rows, Verdict& verdict) {
  const auto above = rows_of(claim.rows, claim, rows, verdict),
             below = rows_of(claim.other, claim, rows, verdict);
  if (above.empty() || below.empty()) return;
  if (above.size() > 1 || below.size() > 1)
    return add_note(verdict, "more than one row; a ratio is that of two rows");
  const double a = *error_of(*above[0], claim.reference), b = *error_of(*below[0], claim.reference);
  if (b == 0) return add_note(verdict, "the second error is 0");
  const double ratio = std::abs(a / b);
  verdict.ours = fmt::format("{:.3g} ({} / {})", ratio, percent(a), percent(b));
  verdict.holds = yes_or_no(within_factor(ratio, *claim.paper, claim.factor));
}

Ladder errors_of(const std::vector<const Row*>& rows, Reference reference) {
  Ladder errors;
  for (const Row* row : rows)
    if (row->spacing_mm) errors.push_back({*row->spacing_mm, *error_of(*row, reference)});
  return errors;
}

void judge_order(const Claim& claim, const std::vector<Row>& rows, Verdict& verdict) {
  const auto found = rows_of(claim.rows, claim, rows, verdict);
  if (found.empty()) return;
  const auto order = fitted_order(errors_of(found, claim.reference));
  if (!order) return add_note(verdict, "an order needs two spacings or more");
  verdict.ours = fmt::format("order {:.2f}", *order);
  verdict.holds = yes_or_no(*order >= claim.low && *order <= claim.high);
}

void judge_finer(const Claim& claim, const std::vector<Row>& rows, Verdict& verdict) {
  const auto ladder = rows_of(claim.rows, claim, rows, verdict),
             target = rows_of(claim.other, claim, rows, verdict);
  if (ladder.empty() || target.empty()) return;
  if (target.size() > 1 || !target[0]->spacing_mm)
    return add_note(verdict, "the error to reach must be that of one row");
  const double error = *error_of(*target[0], claim.reference), spacing = *target[0]->spacing_mm;
  const auto reached = spacing_at_error(errors_of(ladder, claim.reference), std::abs(error));
  if (!reached) return add_note(verdict, "the runs do not show at which spacing they reach that error");
  verdict.ours = fmt::format("{:.3g} times ({:.3g} mm for {} at {:.3g} mm)", spacing / reached->spacing,
                             reached->spacing, percent(error), spacing);
  if (reached->extrapolated) add_note(verdict, "extrapolated beyond the ladder");
  if (!reached->monotone) add_note(verdict, "the ladder's error does not fall from rung to rung");
  verdict.holds = yes_or_no(within_factor(spacing / reached->spacing, *claim.paper, claim.factor));
}

std::string paper_text(const Claim& claim, const std::vector<Row>& rows) {
  switch (claim.kind) {
    case Kind::below:
      return fmt::format("below {:g} %", claim.bound);
    case Kind::above:
      return fmt::format("above {:g} %", claim.bound);
    case Kind::larger:
      return "larger";
    case Kind::smaller:
      return "smaller";
    case Kind::order:
      return fmt::format("order {:g} to {:g}", claim.low, claim.high);
    case Kind::ratio:
      return fmt::format("{:g}, within a factor {:g}", *claim.paper, claim.factor);
    case Kind::finer:
      return fmt::format("{:g} times, within a factor {:g}", *claim.paper, claim.factor);
    case Kind::value:
      break;
  }
  const auto row = std::find_if(
      rows.begin(), rows.end(), [&](const Row& r) { return claim.rows.matches(r); });
  const std::string unit = !claim.of_value ? "%" : row != rows.end() ? row->unit : "";
  return fmt::format("{:g} {} +- {:g}", *claim.paper, unit, claim.tolerance);
}

Verdict judge_one(const Claim& claim, const std::vector<Row>& rows) {
  Verdict verdict;
  verdict.claim = &claim;
  verdict.paper = paper_text(claim, rows);
  switch (claim.kind) {
    case Kind::ratio:
      judge_ratio(claim, rows, verdict);
      break;
    case Kind::order:
      judge_order(claim, rows, verdict);
      break;
    case Kind::finer:
      judge_finer(claim, rows, verdict);
      break;
    default:
      judge_rows(claim, rows, verdict);
  }
  const bool fails = verdict.holds == Holds::no || verdict.holds == Holds::partly;
  if (fails && !claim.note.empty()) add_note(verdict, claim.note);
  return verdict;
}

const char* word(Holds holds) {
  const char* const words[] = {"yes", "no", "partly", "not run"};
  return words[int(holds)];
}

}  // namespace

bool RowFilter::matches(const Row& row) const {
  const auto fits = [](const std::optional<std::string>& asked, const std::string& is) {
    return !asked || *asked == is;
  };
  return fits(study, row.study) && fits(method, row.method) && fits(quantity, row.quantity) &&
         (cases.empty() || std::find(cases.begin(), cases.end(), row.case_name) != cases.end()) &&
         (!spacing_mm || (row.spacing_mm && std::abs(*row.spacing_mm / *spacing_mm - 1) < 1e-6));
}

std::string RowFilter::describe() const {
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
  if (study) add(*study);
  for (const std::string& name : cases) add(name);
  for (const auto* part : {&method, &quantity})
    if (*part) add(**part);
  if (spacing_mm) text += fmt::format(" at {:g} mm", *spacing_mm);
  return text.empty() ? "any row" : text;
}

std::vector<Verdict> judge(const std::vector<Claim>& claims, const std::vector<Row>& rows) {
  std::vector<Verdict> verdicts;
  for (const Claim& claim : claims) verdicts.push_back(judge_one(claim, rows));
  return verdicts;
}

std::string csv(const std::vector<Verdict>& verdicts) {
  std::string text = "id,source,claim,paper,ours,holds,note\r\n";
  for (const Verdict& v : verdicts)
    text += csv_line({v.claim->id, v.claim->source, v.claim->text, v.paper, v.ours, word(v.holds), v.note});
  return text;
}

std::string markdown(const std::vector<Verdict>& verdicts) {
  std::vector<std::vector<std::string>> cells = {{"source", "claim", "paper", "ours", "holds", "note"}};
  for (const Verdict& v : verdicts)
    cells.push_back({v.claim->source, v.claim->text, v.paper, v.ours, word(v.holds), v.note});
  return markdown_table(cells);
}

}  // namespace femsph::compare
