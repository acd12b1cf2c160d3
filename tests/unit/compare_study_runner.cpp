// Runs of a study with fake solvers, the numbers taken from them, and the data behind figures.

#include <gmock/gmock.h>

#include "compare/measure/reduce.hpp"
#include "compare/report/figures.hpp"
#include "compare/study/series.hpp"
#include "compare/study/study_runner.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace test;

const std::string runner_study =
    R"(title = "A study"
[limit]
divisions = "40x4"
[[runs]]
methods = ["fem-full", "sph-corrected"]
spacing = ["20 mm", "10 mm"]
quick = ["d=20mm"]
)" + tip_quantity("tip_displacement", reversed + cantilever_tip) +
    tip_quantity("tip_peak", "reduce = \"peak\"\n") +
    inner_quantity("fibre", "unit = \"MPa\"\nreduce = \"fibre_upper\"\ntheory = \"cantilever_stress\"\n") +
    inner_quantity("stress_l2", "reduce = \"l2\"\ntheory = \"cantilever_stress\"\n") + R"([[paper]]
cases = ["d=20mm"]
method = "fem-full"
quantity = "tip_displacement"
value = "5.2380952380952 mm"
source = "fig 1"
[[series]]
file = "error.csv"
kind = "error"
quantity = "tip_displacement"
[[series]]
file = "cases.csv"
kind = "cases"
quantity = "tip_displacement"
cases = ["d=10mm", "d=20mm"]
[[series]]
file = "tip.csv"
kind = "history"
cases = ["d=20mm"]
probe = "tip"
component = "y"
unit = "mm"
theory = "cantilever_tip"
[[series]]
file = "profile.csv"
kind = "profile"
methods = ["fem-full"]
section = "inner"
component = "xx"
unit = "MPa"
theory = "cantilever_stress"
)";

constexpr double static_tip = -25e3 / (3 * 2.1e11 * 1e-4 / 12);  // 4.7619 mm down

class StudyRunner : public ::testing::Test {
 protected:
  Folder folder{"runner"};
  Study study;
  std::vector<std::string> lines;
  Engine engine;

  void SetUp() override {
    folder.write("beam/scene.toml", cantilever_toml);
    study = read_study(folder.write("beam/study.toml", runner_study));
    // The error of the tip is as many percent as the spacing has centimetres; that of the stress is -10 %.
    engine.run = [](const Scene&, const BodyMethods& method, const Resolution& resolution,
                    const RunOptions&) {
      if (!method.all_fem() && resolution.spacing < 0.015) throw std::runtime_error("the step was too long");
      return result(static_tip * (1 + resolution.spacing), 0.9 * 135e6, resolution.spacing);
    };
    engine.limit = [](const Scene&, const std::array<int, 3>& divisions, int degree) {
      EXPECT_TRUE(divisions[0] == 40 || divisions[0] == 20 || divisions[0] == 10)
          << "the limit, and what tells that it is one";
      EXPECT_EQ(degree, 4);
      fem::StaticLimit limit;
      limit.probes["tip"] = {0, 1.01 * static_tip, 0};
      limit.sections["inner"] = {{-135e6}, {0}, {135e6}};
      return limit;
    };
  }

  StudyOutcome run(bool quick = false) {
    StudyOptions options;
    options.quick = quick;
    options.log = [this](const std::string& line) { lines.push_back(line); };
    return run_study(study, engine, options);
  }
};

TEST_F(StudyRunner, TakesItsNumbers) {
  const StudyOutcome outcome = run();
  ASSERT_EQ(outcome.rows.size(), 16u);  // two spacings, two methods, four quantities
  const Row& tip = outcome.rows[0];
  EXPECT_EQ(tip.study, "beam");
  EXPECT_EQ(tip.case_name, "d=20mm");
  EXPECT_NEAR(*tip.value, 4.7619 * 1.02, 1e-4);  // shown as the paper does: positive downwards
  EXPECT_NEAR(*tip.theory, 4.7619, 1e-4);
  EXPECT_NEAR(*tip.error_percent, 2, 1e-9);
  EXPECT_NEAR(*tip.limit, 1.01 * 4.7619, 1e-4);
  EXPECT_NEAR(*tip.error_vs_limit_percent, 100 * (1.02 / 1.01 - 1), 1e-9);
  EXPECT_NEAR(*tip.paper_error_percent, 10, 1e-6);  // 5.238 is 1.1 times theory
  EXPECT_EQ(*tip.steps, 1000);
  EXPECT_EQ(*tip.cells_over_height, 5);
  EXPECT_NEAR(*tip.ns_per_unit_step, 5000, 1e-9);       // 0.5 s for 1e5 unit-steps
  EXPECT_NEAR(*tip.energy_imbalance_percent, 1, 1e-9);  // 10 J in, 9.9 J found
  EXPECT_EQ(tip.settled, true);
  const Row &peak = outcome.rows[1], &fibre = outcome.rows[2], &l2 = outcome.rows[3];
  EXPECT_NEAR(*peak.value, -1.5 * 4.7619 * 1.02, 1e-3);  // the largest magnitude, with the sign of the scene
  EXPECT_FALSE(peak.theory || peak.limit);               // a static limit says nothing about a peak
  EXPECT_NEAR(*fibre.value, 121.5, 1e-9);
  EXPECT_NEAR(*fibre.error_percent, -10, 1e-9);
  EXPECT_NEAR(*l2.value, 10, 1e-9);
  EXPECT_NEAR(*l2.error_vs_limit_percent, 10, 1e-9);
  EXPECT_EQ(l2.unit, "%");
}

TEST_F(StudyRunner, GoesOnWhenARunFails) {
  const StudyOutcome outcome = run();
  EXPECT_EQ(outcome.failures, 1);
  EXPECT_EQ(outcome.runs.size(), 3u);
  const Row& failed = outcome.rows.back();
  EXPECT_EQ(failed.failure, "the step was too long");
  EXPECT_FALSE(failed.value);
  EXPECT_EQ(*failed.spacing_mm, 10);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_THAT(lines[0], HasSubstr("d=20mm fem-full 20 mm  tip_displacement 4.857 mm (+2.00 %)"));
  EXPECT_EQ(lines[3], "beam d=10mm sph-corrected failed: the step was too long");
}

TEST_F(StudyRunner, QuickFormRunsItsPart) {
  const StudyOutcome outcome = run(true);
  EXPECT_EQ(outcome.runs.size(), 2u);
  EXPECT_EQ(outcome.failures, 0);
}

TEST_F(StudyRunner, WithoutALimitTheRunsStillCount) {
  engine.limit = [](const Scene&, const std::array<int, 3>&, int) -> fem::StaticLimit {
    throw std::runtime_error("out of memory");
  };
  const StudyOutcome outcome = run(true);
  EXPECT_EQ(outcome.failures, 1);
  EXPECT_THAT(lines[0], HasSubstr("limit of scene.toml: out of memory"));
  EXPECT_TRUE(outcome.rows[0].error_percent && !outcome.rows[0].limit);
}

TEST_F(StudyRunner, AMissingProbeIsARowWithAReason) {
  engine.run = [](const Scene&, const BodyMethods&, const Resolution& resolution, const RunOptions&) {
    RunResult r = result(static_tip, 1, resolution.spacing);
    r.history.columns.erase(r.history.columns.begin() + 1);
    r.profiles.at("inner").columns[0].values[2] = std::nan("");
    return r;
  };
  const StudyOutcome outcome = run(true);
  EXPECT_THAT(outcome.rows[0].failure, HasSubstr("no values of tip y"));
  EXPECT_THAT(outcome.rows[2].failure, HasSubstr("not a finite number"));
  EXPECT_EQ(outcome.failures, 2);
}

TEST_F(StudyRunner, SeriesOfErrors) {
  const StudyOutcome outcome = run();
  EXPECT_EQ(series_csv(study.series[0], study, outcome),
            "spacing_mm,fem-full,sph-corrected\r\n20,2,2\r\n10,1,\r\n");
  EXPECT_EQ(series_csv(study.series[1], study, outcome),
            "case,fem-full,sph-corrected\r\nd=10mm,1,\r\nd=20mm,2,2\r\n");
}

TEST_F(StudyRunner, SeriesOfHistoriesAndProfiles) {
  const StudyOutcome outcome = run();
  const std::string history = series_csv(study.series[2], study, outcome);
  EXPECT_THAT(history, StartsWith("time_ms,fem-full,sph-corrected,theory\r\n0,0,0,-4.7619"));
  EXPECT_THAT(history, HasSubstr("\r\n20,-4.857142857,-4.857142857,-4.761904762\r\n"));
  const std::string profile = series_csv(study.series[3], study, outcome);
  EXPECT_THAT(profile, StartsWith("distance_mm,d=20mm,d=10mm,theory\r\n0,-121.5,-121.5,-135\r\n50,0,0,"));
  EXPECT_THAT(profile, EndsWith("\r\n100,121.5,121.5,135\r\n"));
}

// A run that settled early leaves empty cells, and does not shorten the others.
TEST_F(StudyRunner, SeriesOfUnequalLength) {
  engine.run = [](const Scene&, const BodyMethods& method, const Resolution& resolution, const RunOptions&) {
    RunResult r = result(static_tip, 1, resolution.spacing);
    if (method.all_fem()) r.history.columns[0].values = {0, 0.005, 0.01};
    return r;
  };
  const std::string history = series_csv(study.series[2], study, run(true));
  EXPECT_THAT(history, HasSubstr("\r\n20,,-4.761904762,"));
  EXPECT_THAT(history, HasSubstr("\r\n10,-4.761904762,"));
}

TEST(Reduce, FrequencyOfAnUndampedTip) {
  RunResult r = result(1, 1, 0.01);
  for (auto& column : r.history.columns) column.values.clear();
  for (int i = 0; i <= 400; ++i) {
    r.history.columns[0].values.push_back(0.05 * i / 400);
    r.history.columns[1].values.push_back(-1e-3 * (1 - std::cos(2 * M_PI * 83.552 * 0.05 * i / 400)));
  }
  QuantitySpec quantity;
  quantity.name = "frequency";
  quantity.observed = {"tip", "", "", "", "y", {"Hz", 1}};
  quantity.reduce = Reduce::frequency;
  quantity.theory = "cantilever_frequency";
  const Reduced reduced = reduce(quantity, r, cantilever(), nullptr);
  EXPECT_NEAR(reduced.value, 83.552, 0.05);
  EXPECT_NEAR(*reduced.error_percent, 0, 0.1);
}

// A length is the first one plus a displacement, after the sign rule; the error is that of the length.
TEST(Reduce, AnOffsetIsAddedToTheValue) {
  RunResult r = result(1, 1, 0.01);
  for (auto& column : r.history.columns) column.values.assign(2, -0.01);
  QuantitySpec quantity;
  quantity.name = "length";
  quantity.observed = {"tip", "", "", "", "y", {"mm", 1e-3}};
  quantity.offset = 32;
  quantity.reference = 20;
  EXPECT_NEAR(reduce(quantity, r, cantilever(), nullptr).value, 22, 1e-12);
  EXPECT_NEAR(*reduce(quantity, r, cantilever(), nullptr).error_percent, 10, 1e-9);
  quantity.sign = SignRule::reversed;
  EXPECT_NEAR(reduce(quantity, r, cantilever(), nullptr).value, 42, 1e-12);
}

TEST(Reduce, DurationIsFromTheFirstToTheLastSampleThatIsNotZero) {
  RunResult r = result(1, 1, 0.01);
  r.history.columns[0].values = {0, 1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6};
  r.history.columns[1].values = {0, 0, 3, 0, -1, 0, 0};  // with a gap inside
  QuantitySpec quantity;
  quantity.name = "contact";
  quantity.observed = {"tip", "", "", "", "y", {"us", 1e-6}};
  quantity.reduce = Reduce::duration;
  quantity.reference = 2.5;
  const Reduced reduced = reduce(quantity, r, cantilever(), nullptr);
  EXPECT_DOUBLE_EQ(reduced.value, 2);
  EXPECT_NEAR(*reduced.error_percent, -20, 1e-9);
  r.history.columns[1].values.assign(7, 0);
  EXPECT_THAT([&] { reduce(quantity, r, cantilever(), nullptr); },
              ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("has no duration")));
}

// gnuplot itself may be missing; either way the reason is one message.
TEST(Figures, AFailingScriptIsOneClearMessage) {
  const Folder folder("figures");
  const std::string script = folder.write("plot.gp", "load style\nplot nonsense with\n");
  folder.write("style.gp", "set terminal dumb\n");
  try {
    make_figures(script, folder / "style.gp", folder / "", folder / "");
    FAIL() << "expected an error";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), StartsWith("figures: "));
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace femsph::compare
