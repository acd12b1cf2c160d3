// Claims on rows made by hand.

#include <gmock/gmock.h>

#include "compare/study/reader/claims.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;
using Holds = Verdict::Holds;
using Kind = Claim::Kind;

Row row(const std::string& method, const std::string& case_name, double spacing, double error) {
  Row r;
  r.study = "s", r.case_name = case_name, r.method = method, r.quantity = "tip", r.unit = "mm";
  r.spacing_mm = spacing, r.value = 1 + error / 100, r.theory = 1, r.error_percent = error,
  r.error_vs_limit_percent = error - 1;
  return r;
}

// Uncorrected SPH: e = -2 d % (d in mm); FEM: -5 % at 25 mm.
std::vector<Row> rows() {
  return {row("sph", "d=20", 20, -40), row("sph", "d=10", 10, -20), row("sph", "d=5", 5, -10),
          row("sph", "d=2.5", 2.5, -5), row("fem", "1_2", 25, -5)};
}

RowFilter filter(const std::string& method, std::vector<std::string> cases = {}) {
  RowFilter f;
  f.method = method;
  f.cases = std::move(cases);
  return f;
}

Claim claim(Kind kind, RowFilter of) {
  Claim c;
  c.id = "id", c.source = "fig 1", c.text = "text", c.note = "our reading";
  c.kind = kind, c.rows = std::move(of);
  return c;
}

Verdict judged(const Claim& c) {
  static std::vector<Claim> kept(1);
  kept[0] = c;
  return judge(kept, rows())[0];
}

TEST(Claims, ValueWithinItsTolerance) {
  Claim c = claim(Kind::value, filter("sph", {"d=10"}));
  c.paper = 22, c.tolerance = 3;  // the paper's error has no sign
  EXPECT_EQ(judged(c).holds, Holds::yes);
  c.tolerance = 1;
  EXPECT_EQ(judged(c).holds, Holds::no);
  EXPECT_EQ(judged(c).note, "our reading");
  EXPECT_EQ(judged(c).ours, "-20 %");
  c.of_value = true, c.paper = 0.8, c.tolerance = 0.001;
  EXPECT_EQ(judged(c).holds, Holds::yes);
  EXPECT_EQ(judged(c).note, "");
}

TEST(Claims, BoundsOfSeveralRowsMayHoldPartly) {
  Claim c = claim(Kind::below, filter("sph"));
  c.bound = 50;
  EXPECT_EQ(judged(c).holds, Holds::yes);
  c.bound = 15;
  EXPECT_EQ(judged(c).holds, Holds::partly);
  c.bound = 1;
  EXPECT_EQ(judged(c).holds, Holds::no);
  c.kind = Kind::above;
  EXPECT_EQ(judged(c).holds, Holds::yes);
}

TEST(Claims, Signs) {
  EXPECT_EQ(judged(claim(Kind::smaller, filter("sph"))).holds, Holds::yes);
  EXPECT_EQ(judged(claim(Kind::larger, filter("sph"))).holds, Holds::no);
}

TEST(Claims, Ratio) {
  Claim c = claim(Kind::ratio, filter("sph", {"d=10"}));
  c.other = filter("fem"), c.paper = 3, c.factor = 1.5;  // 20/5 = 4
  EXPECT_EQ(judged(c).holds, Holds::yes);
  c.factor = 1.1;
  EXPECT_EQ(judged(c).holds, Holds::no);
  c.rows = filter("sph");
  EXPECT_EQ(judged(c).holds, Holds::unknown);
  EXPECT_THAT(judged(c).note, HasSubstr("more than one row"));
}

TEST(Claims, Order) {
  Claim c = claim(Kind::order, filter("sph"));
  c.low = 0.9, c.high = 1.1;
  EXPECT_EQ(judged(c).holds, Holds::yes);
  EXPECT_EQ(judged(c).ours, "order 1.00");
  c.high = 0.95;
  EXPECT_EQ(judged(c).holds, Holds::no);
}

// FEM's 5 % at 25 mm is reached by SPH at 2.5 mm: ten times finer.
TEST(Claims, Finer) {
  Claim c = claim(Kind::finer, filter("sph"));
  c.other = filter("fem"), c.paper = 10, c.factor = 1.05;
  const Verdict v = judged(c);
  EXPECT_EQ(v.holds, Holds::yes);
  EXPECT_THAT(v.ours, HasSubstr("10 times (2.5 mm for -5 % at 25 mm)"));
  c.reference = Reference::limit;  // errors one percent larger
  c.other = filter("sph", {"d=10"});
  EXPECT_THAT(judged(c).ours, HasSubstr("1 times"));
}

TEST(Claims, UnknownWithoutRows) {
  Claim c = claim(Kind::below, filter("sph-virtual"));
  EXPECT_EQ(judged(c).holds, Holds::unknown);
  EXPECT_THAT(judged(c).note, HasSubstr("no row for sph-virtual"));
}

TEST(Claims, UnknownWhenARunFailed) {
  std::vector<Row> failed = rows();
  failed[0].value.reset();
  failed[0].error_percent.reset();
  Claim c = claim(Kind::below, filter("sph"));
  c.bound = 100;
  const std::vector<Claim> claims = {c};
  const Verdict v = judge(claims, failed)[0];
  EXPECT_EQ(v.holds, Holds::unknown);
  EXPECT_THAT(v.note, HasSubstr("1 row without a result"));
}

TEST(Claims, AreWritten) {
  Claim c = claim(Kind::below, filter("sph"));
  c.text = "errors, all of them, \"small\"";
  c.bound = 15;
  const std::vector<Claim> claims = {c};
  const auto verdicts = judge(claims, rows());
  EXPECT_THAT(csv(verdicts), HasSubstr("id,fig 1,\"errors, all of them, \"\"small\"\"\",below 15 %,\"-40 %, "
                                       "-20 %, -10 %, -5 %\",partly,our reading"));
  EXPECT_THAT(markdown(verdicts), HasSubstr("| partly | our reading |"));
}

}  // namespace
}  // namespace femsph::compare
