// Rows, orders of convergence, and the tables that are written.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/report/readme.hpp"
#include "compare/report/table.hpp"

namespace femsph::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// A reader of CSV by RFC 4180, as spreadsheets have.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = lines.back().back();
    if (quoted && text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"')
      cell += text[++i];
    else if (text[i] == '"')
      quoted = !quoted;
    else if (!quoted && text[i] == ',')
      lines.back().emplace_back();
    else if (!quoted && text.compare(i, 2, "\r\n") == 0)
      lines.push_back({""}), ++i;
    else
      cell += text[i];
  }
  lines.pop_back();
  return lines;
}

Row row(const std::string& method, double spacing, double value, double theory) {
  Row r;
  r.study = "s", r.case_name = "c", r.method = method, r.quantity = "tip", r.unit = "mm";
  r.spacing_mm = spacing, r.value = value, r.theory = theory, r.error_percent = 100 * (value / theory - 1);
  return r;
}

TEST(Table, CsvRoundTrip) {
  Row r = row("a \"new\", method", 2.5, 4.765123456789, 4.762);
  r.failure = "line one\r\nline two";
  r.settled = false;
  const auto lines = read_csv(csv(std::vector<Row>{r}));
  ASSERT_EQ(lines.size(), 2u);
  ASSERT_EQ(lines[0].size(), lines[1].size());
  const auto cell = [&](const std::string& name) {
    return lines[1][std::find(lines[0].begin(), lines[0].end(), name) - lines[0].begin()];
  };
  EXPECT_EQ(cell("method"), r.method);
  EXPECT_EQ(cell("failure"), r.failure);
  EXPECT_EQ(cell("settled"), "no");
  EXPECT_EQ(cell("limit"), "");
  EXPECT_NEAR(std::stod(cell("value")), *r.value, 1e-9);
}

TEST(Table, ColumnsAreTheOnesPromised) {
  EXPECT_THAT(
      read_csv(csv(std::vector<Row>{}))[0],
      ElementsAre("study", "case", "method", "spacing_mm", "cells_over_height", "quantity", "value", "unit",
                  "theory", "error_percent", "limit", "error_vs_limit_percent", "paper",
                  "paper_error_percent", "steps", "dt_s", "cpu_s", "wall_s", "threads", "points",
                  "ns_per_unit_step", "dof", "memory_mb", "total_cpu_s", "total_cpu_min_s", "total_cpu_max_s",
                  "repeats", "energy_imbalance_percent", "momentum_error", "settled", "failure"));
}

TEST(Table, NotANumberIsAnEmptyCell) { EXPECT_EQ(csv_number(std::nan("")), ""); }

// e = d^2 percent over the ladder; a second method with one spacing has no order.
TEST(Table, OrdersOfALadder) {
  std::vector<Row> rows;
  for (const double d : {4.0, 2.0, 1.0}) rows.push_back(row("a", d, 1 + 0.01 * d * d, 1));
  rows.push_back(row("b", 4, 1.1, 1));
  const auto orders = orders_of(rows);
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].reference, "theory");
  EXPECT_NEAR(*orders[0].observed, 2, 1e-9);
  EXPECT_NEAR(*orders[0].extrapolated, 1, 1e-9);
  EXPECT_THAT(orders[0].spacings_mm, ElementsAre(4, 2, 1));
}

// Two meshes of one spacing (10x10 and 20x10, say) are no ladder.
TEST(Table, NoOrderWithoutRefinement) {
  EXPECT_TRUE(orders_of({row("a", 10, 1.1, 1), row("a", 10, 1.2, 1)}).empty());
}

TEST(Table, LaddersOfDifferentRunsDoNotMix) {
  std::vector<Row> rows = {row("a", 4, 1.1, 1), row("a", 2, 1.05, 1)};
  rows[1].ladder = 1;
  EXPECT_TRUE(orders_of(rows).empty());
}

TEST(Table, MarkdownIsRoundedAndSaysWhatFailed) {
  Row failed = row("b", 5, 1, 1);
  failed.value.reset();
  failed.failure = "the step was too long";
  const std::string text = markdown({row("a|b", 2.5, 4.76512345, 4.762), failed}, {});
  EXPECT_THAT(text, HasSubstr("**tip** (mm), theory 4.762"));
  EXPECT_THAT(text, HasSubstr("4.765"));
  EXPECT_THAT(text, HasSubstr("a\\|b"));
  EXPECT_THAT(text, HasSubstr("- s c b: the step was too long"));
  EXPECT_THAT(text, Not(HasSubstr("paper")));  // no column without a value
}

TEST(Table, Rounding) {
  EXPECT_EQ(rounded(4.76512), "4.765");
  EXPECT_EQ(rounded(-0.00021429), "-0.0002143");
  EXPECT_EQ(rounded(2.1429e-7), "2.143e-07");
  EXPECT_EQ(rounded(150.02), "150.0");
  EXPECT_EQ(rounded(0), "0");
}

TEST(Readme, TableIsReplacedBetweenItsMarkers) {
  const std::string before = "# T\n\n<!-- femsph:table -->\nold\n<!-- /femsph:table -->\nend\n";
  const std::string after = with_table(before, "| new |\n");
  EXPECT_EQ(after, "# T\n\n<!-- femsph:table -->\n\n| new |\n\n<!-- /femsph:table -->\nend\n");
  EXPECT_EQ(with_table(after, "| new |\n"), after);
}

TEST(Readme, RefusesWithoutMarkers) {
  EXPECT_THROW(with_table("# T\n", "x"), std::runtime_error);
  EXPECT_THROW(with_table("<!-- /femsph:table --> <!-- femsph:table -->", "x"), std::runtime_error);
  EXPECT_THROW(with_table("<!-- femsph:table --> <!-- femsph:table --> <!-- /femsph:table -->", "x"),
               std::runtime_error);
}

}  // namespace
}  // namespace femsph::compare
