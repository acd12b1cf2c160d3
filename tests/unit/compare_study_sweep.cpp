// What no run of a study can give is refused when the study is read: windows beyond the run, theories in
// another unit, two numbers of one name, bounds of no row; and a claim whose rows are missing stays
// undecided.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/study/reader/study.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;
using namespace test;

class StudySweep : public ::testing::Test {
 protected:
  Folder folder{"sweep"};
  StudySweep() { folder.write("beam/scene.toml", cantilever_toml); }

  std::string faults(const std::string& rest) const {
    try {
      parse_study(
          "title = \"A study\"\n[[runs]]\nmethods = [\"fem-full\", \"fem-sri\"]\nspacing = [\"20 mm\", \"10 "
          "mm\"]\n" +
              rest,
          folder / "beam/study.toml");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }
  static std::string tip(const std::string& more) { return tip_quantity("tip", more); }
  static std::string inner(const std::string& more) {
    return "[[quantities]]\nname = \"inner\"\nsection = \"inner\"\n" + more;
  }
};

TEST_F(StudySweep, Windows) {
  EXPECT_EQ(faults(tip("reduce = \"mean\"\nwindow = [\"0 ms\", \"50 ms\"]\n")), "");
  EXPECT_THAT(
      faults(tip("reduce = \"mean\"\nwindow = [\"40 ms\", \"60 ms\"]\n")),
      HasSubstr(
          "\"window\" ends at 60 ms, and the run of scene.toml at 50 ms; expected a window within the run"));
  EXPECT_THAT(
      faults(inner(
          "component = \"xx\"\nunit = \"MPa\"\nreduce = \"fibre_upper\"\nwindow = [\"0 ms\", \"50 ms\"]\n")),
      HasSubstr("\"window\" with a section or a scalar"));
}

TEST_F(StudySweep, TheoriesInTheUnitOfWhatIsRead) {
  EXPECT_EQ(faults(tip("theory = \"cantilever_tip\"\n")), "");
  EXPECT_THAT(faults(tip("theory = \"cantilever_stress\"\n")),
              HasSubstr("cantilever_stress is in Pa, and what is read is in m"));
  EXPECT_THAT(faults(inner("component = \"xx\"\nreduce = \"l2\"\ntheory = \"cantilever_strain\"\n")),
              HasSubstr("cantilever_strain is in 1, and what is read is in Pa"));
  EXPECT_EQ(faults(inner("component = \"xx\"\nreduce = \"l2\"\ntheory = \"cantilever_stress\"\n")), "");
  EXPECT_THAT(faults("[[quantities]]\nname = \"f\"\nprobe = \"tip\"\ncomponent = \"y\"\nreduce = "
                     "\"frequency\"\ntheory = \"cantilever_tip\"\n"),
              HasSubstr("is in m, and what is read is in Hz"));
}

TEST_F(StudySweep, ReductionsThatDoNotFit) {
  EXPECT_THAT(faults(inner("component = \"yy\"\nreduce = \"moment\"\nunit = \"kN m\"\n")),
              HasSubstr("a moment is of the stress xx, and the component is \"yy\""));
  EXPECT_THAT(
      faults(inner(
          "component = \"xx\"\nreduce = \"l2\"\ntheory = \"cantilever_stress\"\nsign = \"reversed\"\n")),
      HasSubstr("l2 is a distance from theory or limit"));
  EXPECT_THAT(
      faults("[[quantities]]\nname = \"i\"\nprobe = \"tip\"\ncomponent = \"y\"\nreduce = \"integral\"\n"),
      HasSubstr("the integral over time is that of a force, in N s; what is read is in m"));
  EXPECT_THAT(faults("[[quantities]]\nname = \"s\"\nscalar = \"critical_step\"\nreduce = \"mean\"\n"),
              HasSubstr("a scalar is one number of the whole run"));
  EXPECT_THAT(faults("[[quantities]]\nname = \"k\"\ncolumn = \"kinetic_energy\"\nunit = \"mm\"\n"),
              HasSubstr("expected a unit of the same kind as \"J\""));
}

TEST_F(StudySweep, OneNameForOneNumber) {
  EXPECT_THAT(faults(tip("") + tip("reduce = \"peak\"\n")),
              HasSubstr("two quantities of the run d=20mm fem-full are called \"tip\""));
  EXPECT_EQ(faults(tip("methods = [\"fem-full\"]\n") + tip("methods = [\"fem-sri\"]\n")), "");
}

TEST_F(StudySweep, BoundsAndExpectationsOfSomeRow) {
  const std::string only = tip("methods = [\"fem-full\"]\nreference = \"-4.8 mm\"\n");
  EXPECT_EQ(
      faults(only + "[[bounds]]\nmethods = [\"fem-full\"]\nquantity = \"tip\"\nerror_percent = 1\n"), "");
  EXPECT_THAT(faults(only + "[[bounds]]\nmethods = [\"fem-sri\"]\nquantity = \"tip\"\nlow = 0\n"),
              HasSubstr("no run gives these cases, methods and quantity together"));
  EXPECT_THAT(faults(tip("") + "[[bounds]]\nerror_percent = 1\n"),
              HasSubstr("no quantity of this bound has a theory or a reference, which an error needs"));
}

Row row(const std::string& name, double error) {
  Row r;
  r.study = "s", r.case_name = name, r.method = "m", r.quantity = "q", r.value = 1, r.error_percent = error;
  return r;
}

TEST(ClaimSweep, EveryCaseMustBeThere) {
  Claim claim;
  claim.kind = Claim::Kind::below, claim.bound = 5, claim.rows.cases = {"a", "b"};
  EXPECT_EQ(judge({claim}, {row("a", 1), row("b", 1)})[0].holds, Verdict::Holds::yes);
  const auto half = judge({claim}, {row("a", 1)})[0];
  EXPECT_EQ(half.holds, Verdict::Holds::unknown);
  EXPECT_THAT(half.note, HasSubstr("no row of \"b\""));
  EXPECT_EQ(judge({claim}, {row("a", 1), row("b", std::nan(""))})[0].holds, Verdict::Holds::unknown);
}

TEST(ClaimSweep, ARowThatDidNotSettleIsNoted) {
  Claim claim;
  claim.kind = Claim::Kind::below, claim.bound = 5;
  Row r = row("a", 1);
  r.settled = false;
  const auto verdict = judge({claim}, {r})[0];
  EXPECT_EQ(verdict.holds, Verdict::Holds::yes);
  EXPECT_THAT(verdict.note, HasSubstr("1 row not settled"));
}

TEST(OrderSweep, RowsWithoutANumberOrNotSettledTakeNoPart) {
  std::vector<Row> rows;
  for (const double d : {40.0, 20.0, 10.0, 5.0}) {
    rows.push_back(row("c", d));
    rows.back().spacing_mm = d, rows.back().value = 100 + d, rows.back().theory = 100;
  }
  rows.back().settled = false, rows.back().error_percent = 1e3;
  EXPECT_NEAR(*orders_of(rows)[0].observed, 1, 1e-9);
  rows.back().settled.reset(), rows.back().error_percent = std::nan("");
  EXPECT_NEAR(*orders_of(rows)[0].observed, 1, 1e-9);
  // Values that grow as a logarithm are not extrapolated.
  rows.pop_back();
  for (Row& r : rows) r.value = 100 - 3.001 * std::log2(*r.spacing_mm);
  EXPECT_FALSE(orders_of(rows)[0].extrapolated);
}

TEST(VerdictSweep, AnErrorThatIsNotKnownBreaksItsBound) {
  Bound bound;
  bound.error_percent = 1;
  Row r = row("a", 0.5);
  EXPECT_EQ(judge({bound}, {}, {r})[0].verdict, JudgedRow::Verdict::stable);
  r.error_percent.reset();
  const auto judged = judge({bound}, {}, {r})[0];
  EXPECT_EQ(judged.verdict, JudgedRow::Verdict::failed);
  EXPECT_THAT(judged.reason, HasSubstr("the error of q is not known"));
}

}  // namespace
}  // namespace femsph::compare
