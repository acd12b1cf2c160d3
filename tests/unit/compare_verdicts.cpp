// Verdicts on runs: bounds, failures that must occur, and the table they make.

#include <gmock/gmock.h>

#include "compare/program/commands.hpp"
#include "compare/study/reader/verdicts.hpp"
#include "compare/study/study_runner.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Is = JudgedRow::Verdict;
using namespace test;

Row kept() {
  Row row;
  row.case_name = "spin", row.method = "fem-full", row.quantity = "turn", row.unit = "rad";
  row.value = 10.1, row.theory = 10, row.error_percent = 1;
  row.energy_drift = 1e-4, row.momentum_drift = 1e-14, row.angular_momentum_drift = 1e-13,
  row.hourglass_share = 0;
  row.steps = 1000, row.cpu_s = 0.25;
  return row;
}

Bound all_bounds() {
  Bound b;
  b.energy_drift = 0.01, b.momentum_drift = 1e-10, b.angular_momentum_drift = 1e-10, b.hourglass_share = 0.1,
  b.error_percent = 3;
  return b;
}

JudgedRow judged(const Row& row, const std::vector<Bound>& bounds,
                 const std::vector<Expectation>& expectations = {}) {
  return judge(bounds, expectations, {row}).at(0);
}

TEST(Verdicts, ARowThatKeepsEveryBoundIsStable) {
  EXPECT_EQ(judged(kept(), {all_bounds()}).verdict, Is::stable);
  EXPECT_EQ(judged(kept(), {all_bounds()}).reason, "");
}

TEST(Verdicts, EveryBoundCanBreakAndSaysSo) {
  const auto breaks = [](auto&& change, const char* words) {
    Row row = kept();
    change(row);
    const std::vector<Row> rows{row};
    const JudgedRow j = judge({all_bounds()}, {}, rows).at(0);
    EXPECT_EQ(j.verdict, Is::failed) << words;
    EXPECT_THAT(j.reason, HasSubstr(words));
  };
  breaks([](Row& r) { r.energy_drift = 0.02; }, "energy drift 0.0200 is above 0.01");
  breaks([](Row& r) { r.energy_drift = std::nan(""); }, "energy drift");
  breaks([](Row& r) { r.momentum_drift = 1e-9; }, "momentum drift");
  breaks([](Row& r) { r.angular_momentum_drift = 1e-9; }, "angular momentum drift");
  breaks([](Row& r) { r.hourglass_share = 0.2; }, "hourglass share");
  breaks([](Row& r) { r.error_percent = -4; }, "turn is off by -4 %, more than 3 %");
  breaks([](Row& r) { r.settled = false; }, "not settled");
  breaks([](Row& r) { r.failure = "stopped at step 7"; }, "stopped at step 7");
  breaks([](Row& r) { r.energy_drift.reset(); }, "energy drift is not known");
}

TEST(Verdicts, ALaterBoundOverridesForItsOwnRows) {
  Row row = kept();
  row.error_percent = 8;
  Bound wide;
  wide.methods = {"fem-full"}, wide.error_percent = 10;
  EXPECT_EQ(judged(row, {all_bounds(), wide}).verdict, Is::stable);
  wide.methods = {"sph-corrected"};
  EXPECT_EQ(judged(row, {all_bounds(), wide}).verdict, Is::failed);
  wide.methods = {}, wide.quantity = "another";
  EXPECT_EQ(judged(row, {all_bounds(), wide}).verdict, Is::failed);
  Bound range;
  range.low = 10.2;
  EXPECT_THAT(judged(kept(), {range}).reason, HasSubstr("turn is below 10.2 rad"));
}

TEST(Verdicts, AnExpectedFailureMustOccurAndForTheReasonGiven) {
  const Expectation locks{{"spin"}, {"fem-full"}, {"off by -"}, "it locks"};
  Row row = kept();
  row.error_percent = -40;
  const auto as_expected = judged(row, {all_bounds()}, {locks});
  EXPECT_EQ(as_expected.verdict, Is::expected_failure);
  EXPECT_THAT(as_expected.reason, HasSubstr("(expected: it locks)"));
  const auto did_not = judged(kept(), {all_bounds()}, {locks});
  EXPECT_EQ(did_not.verdict, Is::failed);
  EXPECT_EQ(did_not.reason, "did not fail, although it locks");
  row.failure = "a displacement is not a finite number";
  const auto otherwise = judged(row, {all_bounds()}, {locks});
  EXPECT_EQ(otherwise.verdict, Is::failed);
  EXPECT_THAT(otherwise.reason, HasSubstr("expected a failure that says \"off by -\""));
}

TEST(Verdicts, TheTableHasItsColumns) {
  Row row = kept(), stopped = kept();
  stopped.failure = "stopped, at once";
  stopped.value.reset(), stopped.error_percent.reset();
  const std::vector<Row> rows{row, stopped};
  const auto all = judge({all_bounds()}, {}, rows);
  const std::string text = csv(all);
  EXPECT_THAT(
      text, StartsWith("case,method,verdict,reason,energy_drift,momentum_drift,angular_momentum_drift,"
                       "hourglass_share,quantity,value,reference,"
                       "error_percent,steps,cpu_s\r\n"
                       "spin,fem-full,stable,,0.0001,1e-14,1e-13,0,turn (rad),10.1,10,1,1000,0.25\r\n"));
  EXPECT_THAT(text, HasSubstr("spin,fem-full,failed,\"stopped, at once\",0.0001,"));
  EXPECT_THAT(markdown(all), StartsWith("2 rows: 1 stable, 0 fail as expected, 1 failed.\n"));
}

// A study from its files: bounds and expectations are read, a run that stops is a row, and only `failed` is
// an exit code.
TEST(Verdicts, AStudyWithBounds) {
  const Folder folder("verdicts");
  folder.write("studies/hard/scene.toml", cantilever_toml);
  const std::string runs =
      "title = \"Hard\"\n[[runs]]\nmethods = [\"fem-full\", \"sph-corrected\"]\nspacing = [\"20 "
      "mm\"]\n[[quantities]]\nname = \"tip\"\nprobe = \"tip\"\n"
      "component = \"y\"\nunit = \"mm\"\nreference = \"-4.8 mm\"\n[[bounds]]\nenergy_drift = "
      "0.01\nerror_percent = 2\n";
  folder.write("studies/hard/study.toml", runs +
                                              "[[expectations]]\nmethods = [\"sph-corrected\"]\nmessages = "
                                              "[\"no luck\"]\nreason = \"it never has\"\n");
  Engine engine;
  engine.run = [](const Scene&, const BodyMethods& method, const Resolution& resolution,
                  const RunOptions& options) {
    EXPECT_TRUE(options.scalars.contains("energy_drift"));
    RunResult r = result(-4.75e-3, 1, resolution.spacing);
    r.scalars = {
        {"energy_drift", 1e-5}, {"momentum_drift", 0}, {"angular_momentum_drift", 0}, {"hourglass_share", 0}};
    if (method.all_fem()) return r;
    *options.partial = r;
    throw std::runtime_error("no luck");
  };
  StudyCommand command;
  command.name = folder / "studies/hard";
  command.out = folder / "results";
  EXPECT_EQ(study_command(command, engine), 0);
  EXPECT_THAT(folder.read("results/hard/table.csv"),
              HasSubstr("d=20mm,fem-full,stable,,1e-05,0,0,0,tip (mm),-4.75,-4.8,-1.041666667,1000,0.5\r\n"));
  EXPECT_THAT(
      folder.read("results/hard/table.csv"),
      HasSubstr(
          "d=20mm,sph-corrected,expected-failure,no luck (expected: it never has),1e-05,0,0,0,tip (mm),,"));
  EXPECT_THAT(folder.read("results/hard/details.csv"), StartsWith("study,case,method,"));
  folder.write("studies/hard/study.toml", runs);
  EXPECT_EQ(study_command(command, engine), 3);
}

TEST(Verdicts, FaultsOfBoundsAndReferences) {
  const Folder folder("bounds");
  folder.write("hard/scene.toml", cantilever_toml);
  const auto faults = [&](const std::string& rest) -> std::string {
    try {
      parse_study("title = \"Hard\"\n[[runs]]\nmethods = [\"fem-full\"]\nspacing = [\"20 mm\"]\n" + rest,
                  folder / "hard/study.toml");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const std::string tip =
      "[[quantities]]\nname = \"tip\"\nprobe = \"tip\"\ncomponent = \"y\"\nunit = \"mm\"\n";
  EXPECT_EQ(faults(tip + "reference = \"4 mm\"\n[[bounds]]\nerror_percent = 1\n"), "");
  EXPECT_THAT(
      faults(tip + "reference = \"4 MPa\"\n"), HasSubstr("expected a number with the unit of the quantity"));
  EXPECT_THAT(faults(tip + "reference = \"4 mm\"\ntheory = \"cantilever_tip\"\n"),
              HasSubstr("both \"theory\" and \"reference\""));
  EXPECT_THAT(
      faults(tip + "[[bounds]]\nmethods = [\"fem-fall\"]\n"), HasSubstr("did you mean \"fem-full\"?"));
  EXPECT_THAT(faults(tip + "[[bounds]]\nenergy_drift = -1\n"), HasSubstr("expected a number not below 0"));
  EXPECT_THAT(faults(tip + "[[bounds]]\nquantity = \"tap\"\n"), HasSubstr("did you mean \"tip\"?"));
  EXPECT_THAT(faults(tip + "[[expectations]]\nmessages = [\"x\"]\nreason = \"y\"\n"),
              HasSubstr("[[expectations]] without [[bounds]]"));
  EXPECT_THAT(faults("[[quantities]]\nname = \"step\"\nscalar = \"critical_step\"\nunit = \"us\"\nreference "
                     "= \"4 us\"\n"),
              "");
  EXPECT_THAT(faults("[[quantities]]\nname = \"drift\"\nscalar = \"energy_drft\"\n"),
              HasSubstr("did you mean \"energy_drift\"?"));
}

}  // namespace
}  // namespace femsph::compare
