// The tables of a study in Markdown.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/report/table.hpp"

namespace femsph::compare {
namespace {

using Cells = std::vector<std::vector<std::string>>;

std::string number(const std::optional<double>& value, int digits = 4) {
  return value ? rounded(*value, digits) : "";
}

// Counts and spacings: no more digits than they have.
std::string plain(const std::optional<double>& value) { return value ? fmt::format("{:.9g}", *value) : ""; }

// Errors: one decimal from 10 % on, two below.
std::string percent(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "";
  return std::abs(*value) >= 9.995 ? fmt::format("{:+.1f}", *value) : fmt::format("{:+.2f}", *value);
}

// The value that all rows share, if they do.
std::optional<double> common(const std::vector<const Row*>& rows, std::optional<double> Row::*member) {
  for (const Row* row : rows)
    if (row->*member != rows.front()->*member) return {};
  return rows.front()->*member;
}

// A pipe would end the cell; so would a line break.
std::string in_cell(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string quantity_table(const std::vector<const Row*>& rows, bool several_studies) {
  const auto theory = common(rows, &Row::theory), limit = common(rows, &Row::limit);
  std::string caption = fmt::format("**{}** ({})", rows.front()->quantity, rows.front()->unit);
  if (theory) caption += fmt::format(", theory {}", rounded(*theory));
  if (limit) caption += fmt::format(", converged limit {}", rounded(*limit));
  Cells cells = {{several_studies ? "study" : "", "case", "method", "d mm", "cells over height", "value",
                  theory ? "" : "theory", "error %", limit ? "" : "limit", "error vs limit %", "paper",
                  "paper error %", "steps", "CPU s", "settled"}};
  for (const Row* row : rows)
    cells.push_back(
        {several_studies ? in_cell(row->study) : "", in_cell(row->case_name), in_cell(row->method),
         plain(row->spacing_mm), plain(row->cells_over_height), number(row->value),
         theory ? "" : number(row->theory), percent(row->error_percent), limit ? "" : number(row->limit),
         percent(row->error_vs_limit_percent), number(row->paper), percent(row->paper_error_percent),
         plain(row->steps), number(row->cpu_s, 2),
         !row->settled   ? ""
         : *row->settled ? "yes"
                         : "**NO**"});
  return caption + "\n\n" + markdown_table(cells);
}

std::string order_table(const std::vector<Order>& orders) {
  Cells cells = {{"study", "method", "quantity", "reference", "d mm", "observed order", "between neighbours",
                  "extrapolated"}};
  for (const Order& order : orders) {
    std::string spacings, pairwise;
    for (const double d : order.spacings_mm) spacings += (spacings.empty() ? "" : ", ") + plain(d);
    for (const double p : order.pairwise)
      pairwise += (pairwise.empty() ? "" : ", ") + (std::isnan(p) ? "-" : fmt::format("{:.2f}", p));
    cells.push_back({in_cell(order.study), in_cell(order.method), in_cell(order.quantity), order.reference,
                     spacings, order.observed ? fmt::format("{:.2f}", *order.observed) : "", pairwise,
                     order.extrapolated ? rounded(*order.extrapolated) + " " + order.unit : ""});
  }
  return "**Observed orders** (least squares of log error over log spacing)\n\n" + markdown_table(cells);
}

}  // namespace

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return "";
  if (value == 0) return "0";
  const int exponent = int(std::floor(std::log10(std::abs(value))));
  if (exponent < -4 || exponent > 5) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

std::string markdown_table(const Cells& cells) {
  std::vector<std::size_t> shown, width;
  for (std::size_t c = 0; c < cells.front().size(); ++c) {
    std::size_t widest = 0;
    for (std::size_t r = 1; r < cells.size(); ++r) widest = std::max(widest, cells[r][c].size());
    if (widest == 0) continue;
    shown.push_back(c);
    width.push_back(std::max({widest, cells.front()[c].size(), std::size_t(3)}));
  }
  std::string text;
  for (std::size_t r = 0; r < cells.size(); ++r) {
    text += "|";
    for (std::size_t k = 0; k < shown.size(); ++k)
      text += fmt::format(" {:<{}} |", cells[r][shown[k]], width[k]);
    text += "\n";
    if (r > 0) continue;
    text += "|";
    for (const std::size_t w : width) text += std::string(w + 2, '-') + "|";
    text += "\n";
  }
  return text;
}

std::string markdown(const std::vector<Row>& rows, const std::vector<Order>& orders) {
  std::vector<std::string> quantities;
  std::set<std::string> studies, failures, doubts;
  for (const Row& row : rows) {
    studies.insert(row.study);
    if (std::find(quantities.begin(), quantities.end(), row.quantity) == quantities.end())
      quantities.push_back(row.quantity);
    if (!row.limit_doubt.empty() && row.failure.empty())
      doubts.insert(fmt::format("- {} {}{}: {}\n", row.study, row.quantity,
                                row.scene.empty() ? "" : " in " + row.scene, in_cell(row.limit_doubt)));
    if (!row.failure.empty())
      failures.insert(fmt::format("- {} {} {}: {}\n", row.study, row.case_name, row.method, row.failure));
  }
  std::string text;
  for (const std::string& quantity : quantities) {
    std::vector<const Row*> shown;
    for (const Row& row : rows)
      if (row.quantity == quantity && row.failure.empty()) shown.push_back(&row);
    if (!shown.empty()) text += quantity_table(shown, studies.size() > 1) + "\n";
  }
  if (!orders.empty()) text += order_table(orders) + "\n";
  if (!doubts.empty()) {
    text += "**No limit to compare with**\n\n";
    for (const std::string& doubt : doubts) text += doubt;
    text += "\n";
  }
  if (!failures.empty()) {
    text += "**No result**\n\n";
    for (const std::string& failure : failures) text += failure;
  }
  return text;
}

}  // namespace femsph::compare
