// No error is given against a reference that does not exist: limits whose refinements do not converge,
// ladders without an order of convergence, infinite values. Values that converge keep their limit.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/measure/reduce.hpp"
#include "compare/price/advise.hpp"
#include "compare/study/study_limits.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::AllOf, ::testing::HasSubstr, ::testing::IsEmpty, ::testing::Not;
using namespace test;

/// The paper's cantilever at rest: loaded on the corner x+ y+, read at mid height ("tip") and under the load
/// ("under").
Scene corner_loaded() {
  Scene scene = cantilever();
  scene.loads[0].place.sides = {"x+", "y+"};
  scene.settling.emplace();
  scene.probes.push_back({"tip", 0, quantity_named("displacement"), {1, 0.05, 0}});
  scene.probes.push_back({"under", 0, quantity_named("displacement"), {1, 0.1, 0}});
  scene.sections.push_back({"inner", 0, quantity_named("stress"), {0.1, 0, 0}, {0.1, 0.1, 0}, 3});
  scene.sections.push_back({"root", 0, quantity_named("stress"), {0, 0, 0}, {0, 0.1, 0}, 3});
  return scene;
}
QuantitySpec tip(const std::string& probe = "tip") {
  QuantitySpec q;
  q.name = probe + "_y";
  q.observed = {probe, "", "", "", "y", {"mm", 1e-3}};
  return q;
}
fem::StaticLimit limit_of(double y) {
  fem::StaticLimit limit;
  limit.probes["tip"] = limit.probes["under"] = {0, y, 0};
  limit.sections["inner"] = limit.sections["root"] = {{-1e8 * y}, {0}, {1e8 * y}};
  return limit;
}
KnownLimit known(double coarse, double middle, double fine) {
  return {limit_of(fine), {}, {limit_of(coarse), limit_of(middle)}, 0.7};
}

TEST(Reference, ALimitIsDoubtedWhenItsRefinementsDoNotConverge) {
  const Scene scene = corner_loaded();
  // A quarter of the change with each halving (order 2), and the change of a logarithm, the same each time.
  EXPECT_EQ(doubt_of(tip(), scene, known(-4.6e-3, -4.75e-3, -4.7875e-3)), "");
  const std::string doubt = doubt_of(tip(), scene, known(-4.79e-3, -4.80e-3, -4.81e-3));
  EXPECT_THAT(doubt, AllOf(HasSubstr("refinement changes it by 0.21 %, then by 0.21 %"),
                           HasSubstr("the changes do not decrease as they do towards a limit")));
  // 1/h, as under a force on a point in space: the change doubles.
  EXPECT_THAT(doubt_of(tip(), scene, known(-1e-3, -2e-3, -4e-3)), HasSubstr("by 25 %, then by 50 %"));
  // The slowest that converges here, r^2 lambda with lambda = 0.758 of the clamped corner: 0.35 each time.
  // And changes of 1e-5, which no table shows.
  EXPECT_EQ(doubt_of(tip(), scene, known(-4.7e-3, -4.76e-3, -4.781e-3)), "");
  EXPECT_EQ(doubt_of(tip(), scene, known(-4.79e-3, -4.79002e-3, -4.79004e-3)), "");
  EXPECT_EQ(doubt_of(tip(), scene, KnownLimit{limit_of(-4.79e-3), {}, {}, 0}), "")
      << "nothing coarser to look at";
  // A profile by its norm, and a moment by its value, are judged alike.
  QuantitySpec l2;
  l2.name = "l2", l2.observed = {"", "inner", "", "", "xx", {"%", 1}}, l2.reduce = Reduce::l2;
  EXPECT_THAT(doubt_of(l2, scene, known(1, 2, 3)), HasSubstr("by 33 %, then by 33 %"));
  EXPECT_EQ(doubt_of(l2, scene, known(1, 2, 2.25)), "");
  l2.reduce = Reduce::moment;
  EXPECT_THAT(doubt_of(l2, scene, known(1, 2, 3)), HasSubstr("by 33 %, then by 33 %"));
}

TEST(Reference, WhereTheExactValueIsInfiniteThereIsNone) {
  const Scene scene = corner_loaded();
  const KnownLimit smooth = known(-4.6e-3, -4.75e-3, -4.7875e-3);
  EXPECT_THAT(doubt_of(tip("under"), scene, smooth),
              AllOf(HasSubstr("a force on a point"), HasSubstr("\"under\" reads there")));
  QuantitySpec fibre;
  fibre.name = "fibre", fibre.observed = {"", "root", "", "", "xx", {"MPa", 1e6}},
  fibre.reduce = Reduce::fibre_upper;
  EXPECT_THAT(doubt_of(fibre, scene, smooth), HasSubstr("where this held side ends"));
  fibre.observed.section = "inner";
  EXPECT_EQ(doubt_of(fibre, scene, smooth), "");
  fibre.observed.section = "root",
  fibre.reduce = Reduce::l2;  // the profile's norm is finite: r^-0.24 squared can be integrated
  EXPECT_EQ(doubt_of(fibre, scene, smooth), "");
}

class ReferenceOfAStudy : public ::testing::Test {
 protected:
  Folder folder{"reference"};
  std::vector<std::string> lines;
  double change_ratio = 0.25;  ///< ratio of one change to the one before, as the cells are halved

  StudyOutcome run(const std::string& limit, const std::string& probe_height = "50 mm") {
    std::string scene = cantilever_toml;
    const auto at = scene.find("\"50 mm\"");
    scene.replace(at, 7, "\"" + probe_height + "\"");
    folder.write("beam/scene.toml", scene);
    const Study study = read_study(folder.write("beam/study.toml", "title = \"A study\"\n" + limit + R"(
[[runs]]
methods = ["fem-full"]
spacing = ["40 mm", "20 mm", "10 mm"]
)" + tip_quantity("tip")));
    Engine engine;
    engine.run = [](const Scene&, const BodyMethods&, const Resolution& resolution, const RunOptions&) {
      return result(-0.005 * (1 + 0.01 * std::log(1 / resolution.spacing)), 1, resolution.spacing);
    };
    engine.limit = [this](const Scene&, const std::array<int, 3>& divisions, int) {
      const double halvings = std::log2(divisions[0] / 10.0);
      fem::StaticLimit limit;
      limit.probes["tip"] = {
          0, -0.005 * (1 + 0.01 * (change_ratio == 1 ? halvings : -std::pow(change_ratio, halvings))), 0};
      limit.sections["inner"] = {{0}, {0}, {0}};
      return limit;
    };
    StudyOptions options;
    options.log = [this](const std::string& line) { lines.push_back(line); };
    return run_study(study, engine, options);
  }
};

TEST_F(ReferenceOfAStudy, AConvergedLimitIsComparedWith) {
  const auto outcome = run("[limit]\ndivisions = \"40x4\"\n");
  ASSERT_EQ(outcome.rows.size(), 3u);
  EXPECT_TRUE(outcome.rows[0].limit && outcome.rows[0].error_vs_limit_percent);
  EXPECT_EQ(outcome.rows[0].limit_doubt, "");
}

TEST_F(ReferenceOfAStudy, ALimitThatGrowsAsALogarithmIsNot) {
  change_ratio = 1;
  const auto outcome = run("[limit]\ndivisions = \"40x4\"\n");
  EXPECT_FALSE(outcome.rows[0].limit || outcome.rows[0].error_vs_limit_percent);
  EXPECT_TRUE(outcome.rows[0].value);
  EXPECT_THAT(lines[0], HasSubstr("no limit: table.md says why"));
  EXPECT_THAT(markdown(outcome.rows, orders_of(outcome.rows)),
              AllOf(HasSubstr("**No limit to compare with**"),
                    HasSubstr("- beam tip in scene.toml: refinement changes it by"),
                    Not(HasSubstr("error vs limit"))));
  // A claim about such an error has no answer.
  Claim claim;
  claim.kind = Claim::Kind::below, claim.bound = 100, claim.reference = Reference::limit,
  claim.rows.quantity = "tip";
  const auto verdict = judge({claim}, outcome.rows)[0];
  EXPECT_EQ(verdict.holds, Verdict::Holds::unknown);
  EXPECT_THAT(verdict.note, HasSubstr("no limit: refinement"));
}

// The rows of the fake runs grow as a logarithm: Richardson finds an order near 0.
TEST_F(ReferenceOfAStudy, ALadderWithoutAnOrderGivesNoLimit) {
  const auto outcome = run("[[limits]]\nscene = \"scene.toml\"\nladder = \"fem-full\"\n");
  EXPECT_EQ(outcome.failures, 1);
  EXPECT_FALSE(outcome.rows[0].limit);
  EXPECT_THAT(lines.back(), HasSubstr("limit of tip in scene.toml"));
  EXPECT_THAT(outcome.rows[0].limit_doubt, Not(IsEmpty()));
}

/// Advice about a tip whose value is limit (1 + c d^2 + g ln d); a run takes 1e-6 d^-3 s.
class ReferenceOfAdvice : public ::testing::Test {
 protected:
  Scene scene = corner_loaded();
  Question question;
  double logarithm = 0;
  int runs = 0;

  ReferenceOfAdvice() {
    question.quantity = tip();
    question.methods = {
        method_named("fem-full"), method_named("fem-assumed-strain"), method_named("sph-corrected")};
    question.error = 1;
    question.budget = 50;
  }
  Advice ask() {
    Engine engine;
    engine.run = [this](const Scene&, const BodyMethods& method, const Resolution& resolution,
                        const RunOptions&) {
      ++runs;
      // Assumed strain has hardly any error of its own, so that it shows the logarithm first.
      const double d = resolution.spacing, c = method.name == "fem-assumed-strain" ? 0.01
                                               : method.all_fem()                  ? 10
                                                                                   : 40;
      RunResult r = result(-0.005 * (1 + c * d * d - logarithm * std::log(d)), 1, d);
      r.price.steps = std::lround(1e4 / d), r.price.units = std::size_t(std::lround(10 / (d * d)));
      r.price.total_cpu = r.price.cpu = 1e-6 / (d * d * d);
      return r;
    };
    return advise(scene, question, engine);
  }
};

TEST_F(ReferenceOfAdvice, OfASmoothNumberConfidenceIsGoodAndSaysWhy) {
  const Advice advice = ask();
  ASSERT_TRUE(advice.best) << advice.refusal;
  EXPECT_THAT(
      describe(scene, question, advice),
      AllOf(HasSubstr("3 of 3 methods"), HasSubstr("orders 2.00 to 2.00"), HasSubstr("confidence good"),
            HasSubstr("tip of body box, component y; one of 2 probes (--probe names another)")));
}

TEST_F(ReferenceOfAdvice, ALogarithmIsNotALimit) {
  logarithm = 0.004;
  const Advice advice = ask();
  EXPECT_FALSE(advice.best);
  EXPECT_THAT(advice.refusal,
              AllOf(HasSubstr("the values of fem-assumed-strain keep changing from spacing to spacing"),
                    HasSubstr("there may be no limit")));
  EXPECT_THAT(describe(scene, question, advice), Not(HasSubstr("confidence good")));
}

TEST_F(ReferenceOfAdvice, AnInfiniteNumberIsRefusedBeforeAnyRun) {
  question.quantity = tip("under");
  const Advice advice = ask();
  EXPECT_EQ(runs, 0);
  EXPECT_THAT(
      advice.refusal, HasSubstr("a force on a point: the exact displacement and stress there are infinite"));
  EXPECT_THAT(describe(scene, question, advice),
              AllOf(HasSubstr("none: a force on a point"), Not(HasSubstr("confidence"))));
}

TEST_F(ReferenceOfAdvice, APointSupportLowersTheConfidence) {
  scene.supports[0].place.sides = {"x-", "y-"};  // with the force down it bears a reaction
  const Advice advice = ask();
  ASSERT_TRUE(advice.best) << advice.refusal;
  EXPECT_THAT(describe(scene, question, advice),
              AllOf(HasSubstr("but there is a support on a point: if it bears a reaction"),
                    HasSubstr("confidence low")));
}

}  // namespace
}  // namespace femsph::compare
