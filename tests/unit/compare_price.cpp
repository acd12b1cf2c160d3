// The cost of accuracy, on ladders of a known law: e = C d^p, CPU = c d^-3.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/price/price_tables.hpp"
#include "compare/study/study_runner.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::AllOf, ::testing::EndsWith, ::testing::HasSubstr, ::testing::StartsWith;
using namespace test;
using Basis = PricedLadder::Cost::Basis;

/// In a plane: 1e6 / d^2 units, 1e4 / d steps, 1e-8 s each.
PricedRung rung(double spacing, double error) {
  PricedRung r{spacing, error, 100 / std::pow(spacing, 3)};
  r.steps = 1e4 / spacing, r.units = 1e6 / (spacing * spacing), r.dof = 2 * r.units,
  r.cpu_min = r.cpu_max = r.cpu;
  return r;
}

PricedLadder ladder(const std::vector<std::pair<double, double>>& rungs, double known_to = 0) {
  std::vector<PricedRung> all;
  for (const auto& [spacing, error] : rungs) all.push_back(rung(spacing, error));
  return PricedLadder(all, 2, known_to);
}

TEST(PricedLadder, InterpolatesAndExtrapolatesAPower) {
  const PricedLadder l = ladder({{1, 0.5}, {8, 32}, {4, 8}, {2, 2}});  // 0.5 d^2, in any order
  EXPECT_NEAR(*l.order(), 2, 1e-9);
  EXPECT_NEAR(*l.error_over_cpu(), -2.0 / 3, 1e-9);
  EXPECT_NEAR(*l.cpu_over_dof(), 1.5, 1e-9);
  const auto within = l.cost_of(4.5);
  EXPECT_EQ(within.basis, Basis::interpolated);
  EXPECT_NEAR(within.spacing, 3, 1e-9);
  EXPECT_NEAR(within.cpu, 100.0 / 27, 1e-9);
  const auto beyond = l.cost_of(0.02);
  EXPECT_EQ(beyond.basis, Basis::extrapolated);
  EXPECT_NEAR(beyond.spacing, 0.2, 1e-9);
  EXPECT_NEAR(beyond.cpu, 100 / std::pow(0.2, 3), 1e-6);
  EXPECT_EQ(l.cost_of(50).basis, Basis::coarsest);
  EXPECT_EQ(l.cost_of(50).spacing, 8);
  EXPECT_NEAR(*l.error_at(0.5), 0.125, 1e-9);
  EXPECT_NEAR(*l.spacing_for(100 / std::pow(0.7, 3)), 0.7, 1e-9);
  EXPECT_FALSE(l.spacing_for(1e-3));
}

// Errors of 9, 0.01, 2 and 0.5 %, where the second is small by chance: 1 % is reached between the last two
// spacings, and not at the second.
TEST(PricedLadder, AnErrorNearAChangeOfSignDoesNotCount) {
  const PricedLadder l = ladder({{8, 9}, {4, 0.01}, {2, -2}, {1, -0.5}});
  EXPECT_EQ(l.credited(), (std::vector<double>{9, 2, 2, 0.5}));
  EXPECT_NEAR(l.cost_of(1).spacing, std::sqrt(2.0), 1e-9);  // between the two finest
  EXPECT_EQ(l.cost_of(5).basis, Basis::interpolated);
  EXPECT_GT(l.cost_of(5).spacing, 4);
  EXPECT_EQ(l.cost_of(0.1).basis, Basis::not_reached);
}

// The error changes its sign between two spacings, at an unknown place: the finer one counts.
TEST(PricedLadder, NoInterpolationAcrossZero) {
  const PricedLadder l = ladder({{8, 9}, {4, -4}, {2, -2}, {1, -1}});
  EXPECT_EQ(l.cost_of(5).spacing, 4);
}

TEST(PricedLadder, AChangeOfSignAtTheFinestSpacingIsNoConvergence) {
  const PricedLadder l = ladder({{4, 9}, {2, 3}, {1, -0.001}});
  EXPECT_GE(l.credited().back(), 3);
  const auto cost = l.cost_of(1);
  EXPECT_EQ(cost.basis, Basis::not_reached);
  EXPECT_THAT(cost.reason, HasSubstr("changes its sign"));
}

// An error of 6 d - 2 percent: it passes through zero and tends to -2.
TEST(PricedLadder, AnErrorThatPassesThroughZeroCountsByItsLimit) {
  const PricedLadder l = ladder({{2, 10}, {1, 4}, {0.5, 1}});
  EXPECT_NEAR(*l.error_at_zero(), -2, 1e-9);
  EXPECT_NEAR(l.credited().back(), 2, 1e-9);
  EXPECT_EQ(l.cost_of(1.5).basis, Basis::not_reached);
  EXPECT_THAT(l.cost_of(1.5).reason, HasSubstr("extrapolate to an error of -2 %"));
}

// An error of 2 + d^2 percent: it falls at first and tends to 2.
TEST(PricedLadder, AnotherLimitIsReported) {
  const PricedLadder l = ladder({{8, 66}, {4, 18}, {2, 6}, {1, 3}});
  const auto cost = l.cost_of(0.5);
  EXPECT_EQ(cost.basis, Basis::not_reached);
  EXPECT_THAT(cost.reason, HasSubstr("extrapolate to an error of +2 %, not to zero"));
}

TEST(PricedLadder, RefusesWhatItCannotKnow) {
  EXPECT_THAT(ladder({{4, 4}, {2, 1}}).cost_of(0.1).reason, HasSubstr("fewer than three"));
  EXPECT_THAT(ladder({{4, 4}}).cost_of(5).reason, HasSubstr("fewer than two"));
  EXPECT_THAT(ladder({{4, 4}, {2, 5}, {1, 6}}).cost_of(1).reason, HasSubstr("does not fall"));
  EXPECT_THAT(ladder({{4, 16}, {2, 4}, {1, 1}}).cost_of(1e-4).reason, HasSubstr("times finer"));
  EXPECT_THAT(ladder({{4, 16}, {2, 4}, {1, 1}}, 0.5).cost_of(0.1).reason,
              HasSubstr("the reference is known to 0.5 %"));
}

// A fixed part of every step shows in small runs and vanishes in large ones.
TEST(PricedLadder, CostOfAStepHasAFixedPart) {
  std::vector<PricedRung> rungs;
  for (const double d : {4.0, 2.0, 1.0}) {
    PricedRung r = rung(d, d * d);
    r.cpu = r.steps * (1e-3 + 1e-8 * r.units);
    rungs.push_back(r);
  }
  const PricedLadder l(rungs, 2);
  EXPECT_NEAR(l.cpu_at(0.25), 4e4 * (1e-3 + 1e-8 * 1.6e7), 1e-6);
}

const char* const priced_study = R"(title = "A study"
repeat = 3
[[limits]]
scene = "scene.toml"
ladder = "limit"
[[runs]]
methods = ["fem-full"]
spacing = ["20 mm", "10 mm", "5 mm"]
[[runs]]
methods = ["sph-corrected"]
smoothing_lengths = [1.0, 1.2]
spacing = ["20 mm", "10 mm", "5 mm"]
[[runs]]
methods = ["fem-sri"]
label = "limit"
spacing = ["4 mm", "2 mm", "1 mm"]
[[quantities]]
name = "tip"
probe = "tip"
component = "y"
unit = "mm"
sign = "reversed"
[[price]]
name = "beam"
quantity = "tip"
errors = [2, 0.5]
spacing = "10 mm"
base = "fem-full"
)";

class Prices : public ::testing::Test {
 protected:
  Folder folder{"prices"};
  Study study;
  Engine engine;
  int calls = 0;

  void SetUp() override {
    folder.write("beam/scene.toml", cantilever_toml);
    study = read_study(folder.write("beam/study.toml", priced_study));
    // 10 mm (1 + 25 d^2), d in m: an error of 1 % at 20 mm, a quarter of it at 10 mm. SPH has four times the
    // error.
    engine.run = [this](const Scene&, const BodyMethods& method, const Resolution& resolution,
                        const RunOptions&) {
      const double d = resolution.spacing;
      RunResult r = result(-0.01 * (1 + (method.all_fem() ? 25 : 100) * d * d), 1, d);
      r.price.steps = long(1 / d), r.price.units = std::size_t(1 / (d * d));
      r.price.cpu = 1e-6 / (d * d * d);
      r.price.total_cpu =
          r.price.cpu * (1 + 0.1 * (calls++ / 12));  // the second round takes longer, the third longer still
      return r;
    };
  }
  std::string message(const std::string& old, const std::string& instead) {
    std::string text = priced_study;
    const auto at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    try {
      parse_study(text.replace(at, old.size(), instead), folder / "beam/study.toml");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }
};

TEST_F(Prices, RepeatsRunsAndTakesTheLimitOfALadder) {
  const StudyOutcome outcome = run_study(study, engine, {});
  EXPECT_EQ(outcome.failures, 0);
  ASSERT_EQ(outcome.rows.size(), 12u);
  EXPECT_EQ(calls, 36);
  const Row& row = outcome.rows[0];
  EXPECT_EQ(row.method, "fem-full");
  EXPECT_NEAR(*row.limit, 10, 1e-9);
  EXPECT_NEAR(*row.error_vs_limit_percent, 1, 1e-7);
  EXPECT_NEAR(*row.limit_known_percent, 1.25 * 0.0025, 1e-6);  // the finest rung, 1 mm, errs by 0.0025 %
  EXPECT_EQ(*row.repeats, 3);
  EXPECT_NEAR(*row.total_cpu_s / *row.total_cpu_min_s, 1.1, 1e-9);
  EXPECT_NEAR(*row.total_cpu_max_s / *row.total_cpu_min_s, 1.2, 1e-9);
}

TEST_F(Prices, ARepeatedRunMustGiveTheSame) {
  auto once = engine.run;
  engine.run = [this, once](const Scene& scene, const BodyMethods& method, const Resolution& resolution,
                            const RunOptions& options) {
    RunResult r = once(scene, method, resolution, options);
    if (calls == 20) r.history.columns[1].values.back() *= 1 + 1e-12;
    return r;
  };
  EXPECT_EQ(run_study(study, engine, {}).failures, 1);
}

TEST_F(Prices, TablesSayWhatAnErrorCosts) {
  const auto scenes = priced_scenes(study, run_study(study, engine, {}).rows);
  ASSERT_EQ(scenes.size(), 1u);
  ASSERT_EQ(scenes[0].methods.size(), 3u);  // not the ladder that gave the limit
  EXPECT_EQ(scenes[0].methods[1].method, "sph-corrected h=1d");
  const std::string prices = price_csv(scenes);
  EXPECT_THAT(
      prices,
      StartsWith("scene,method,error_percent,cpu_s,spacing_mm,extrapolated,ratio_to_cheapest,basis\r\n"
                 "beam,fem-full,2,"));
  // 0.5 %: FEM at 20/sqrt(2) mm, SPH at half that, at eight times the cost.
  EXPECT_THAT(prices, HasSubstr("beam,fem-full,0.5,0.388908"));
  EXPECT_THAT(prices, HasSubstr("14.1421"));
  EXPECT_THAT(prices, HasSubstr("beam,sph-corrected h=1d,0.5,3.111"));
  const std::string finer = finer_csv(scenes);
  EXPECT_THAT(finer, HasSubstr("beam,sph-corrected h=1d,fem-full,0.5,14.142"));
  EXPECT_THAT(finer, HasSubstr(",2,8,no,1000\r\n"));
  EXPECT_THAT(spacing_csv(scenes),
              AllOf(HasSubstr("beam,fem-full,10,0.25"), HasSubstr("beam,sph-corrected h=1.2d,10,1")));
  EXPECT_THAT(price_markdown(scenes), HasSubstr("8.0x"));
  EXPECT_THAT(front_csv(scenes[0]), StartsWith("method,cpu_s,error_percent\r\nfem-full,0.1375,1"));
}

TEST_F(Prices, FaultsInPrices) {
  EXPECT_THAT(message("quantity = \"tip\"", "quantity = \"tpi\""), HasSubstr("did you mean \"tip\"?"));
  EXPECT_THAT(
      message("base = \"fem-full\"", "base = \"fem-fully\""), HasSubstr("did you mean \"fem-full\"?"));
  EXPECT_THAT(message("errors = [2, 0.5]", "errors = [2, -1]"), HasSubstr("must hold numbers above 0"));
  EXPECT_THAT(message("errors = [2, 0.5]", "reference = \"theory\""), HasSubstr("has no theory"));
  EXPECT_THAT(message("name = \"beam\"", "name = \"a beam\""), HasSubstr("expected a name of letters"));
  EXPECT_THAT(message("ladder = \"limit\"", "ladder = \"limt\""), HasSubstr("did you mean \"limit\"?"));
  EXPECT_THAT(message("[\"4 mm\", \"2 mm\", \"1 mm\"]", "[\"4 mm\", \"2 mm\"]"),
              HasSubstr("at 2 spacings; expected three or more"));
  EXPECT_THAT(message("smoothing_lengths = [1.0, 1.2]", "smoothing_lengths = [0, 1.2]"),
              HasSubstr("a number from 0.6 to 4"));
  EXPECT_THAT(message("methods = [\"fem-full\"]", "methods = [\"fem-full\"]\nsmoothing_lengths = [1.0]"),
              HasSubstr("\"smoothing_lengths\" with fem-full"));
  EXPECT_THAT(
      message("smoothing_lengths = [1.0, 1.2]", "supports = [1.0, 1.2]"),
      EndsWith(":11:12: \"supports\" is the old name of \"smoothing_lengths\"; expected the new name"));
  EXPECT_THAT(message("repeat = 3", "repeat = 0"), HasSubstr("repeat"));
}

}  // namespace
}  // namespace femsph::compare
