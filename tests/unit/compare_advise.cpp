// Advice from ladders of spacings whose errors follow a known law.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/price/advise.hpp"
#include "compare/price/study_advice.hpp"
#include "compare/program/commands.hpp"
#include "compare_support.hpp"

namespace femsph::compare {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace test;

/// Tip = limit (1 + c d^2), d in m; a run takes 1e-6 d^-3 s: 0.1 mm of spacing would take 1e6 s.
class Advise : public ::testing::Test {
 protected:
  Scene scene = cantilever();  // the shortest side is 100 mm
  Question question;
  Engine engine;

  Advise() {
    scene.settling.emplace();
    scene.probes.push_back({"tip", 0, quantity_named("displacement"), {1, 0.05, 0}});
    question.quantity.name = "tip_y";
    question.quantity.observed = {"tip", "", "", "", "y", {"mm", 1e-3}};
    question.methods = {
        method_named("fem-full"), method_named("sph-corrected"), method_named("sph-classic-share")};
    question.budget = 50;
    // At 100 mm FEM has an error of 10 %, corrected SPH of 40 %; the limit of classic SPH is 20 % off.
    engine.run = [](const Scene&, const BodyMethods& method, const Resolution& resolution,
                    const RunOptions&) {
      const double d = resolution.spacing, c = method.all_fem() ? 10 : 40;
      return at(method.name == "sph-classic-share" ? -0.006 : -0.005, c, d);
    };
  }
  static RunResult at(double limit, double c, double d) {
    RunResult r = result(limit * (1 + c * d * d), 1, d);
    r.price.steps = std::lround(1e4 / d), r.price.units = std::size_t(std::lround(10 / (d * d)));
    r.price.total_cpu = r.price.cpu = 1e-6 / (d * d * d);
    return r;
  }
};

TEST_F(Advise, LeastTimeForAnError) {
  question.error = 0.1;
  const Advice advice = advise(scene, question, engine);
  ASSERT_TRUE(advice.best) << advice.refusal;
  EXPECT_EQ(advice.methods[advice.best->method].method.name, "fem-full");
  EXPECT_NEAR(*advice.methods[*advice.reference].limit, -5, 1e-6);
  EXPECT_EQ(advice.meeting, 2);
  EXPECT_TRUE(advice.both_kinds);
  EXPECT_FALSE(advice.methods[2].meets);
  EXPECT_FALSE(advice.choices[2]) << "classic SPH goes elsewhere";
  EXPECT_THAT(advice.why_not[2], HasSubstr("extrapolate to an error of +20 %"));
  // 0.09 % = 1000 d^2 %: d = 9.49 mm; 100 mm over 11 is 9.09.
  EXPECT_EQ(advice.best->divisions, 11);
  EXPECT_NEAR(advice.best->cpu, 1e-6 / std::pow(0.1 / 11, 3), 0.02);
  const Outcome outcome = follow(scene, question, advice, engine);
  EXPECT_NEAR(outcome.cpu / advice.best->cpu, 1, 0.02);
  EXPECT_LT(std::abs(outcome.error), 0.1);
  EXPECT_LE(advice.spent, question.budget);
  EXPECT_THAT(describe(scene, question, advice),
              AllOf(HasSubstr("--solver fem-full --spacing \"9.09091 mm\""), HasSubstr("2 of 3 methods"),
                    HasSubstr("confidence good")));
}

TEST_F(Advise, LeastErrorInATime) {
  question.within = 1000;
  question.budget = 5;
  const Advice advice = advise(scene, question, engine);
  ASSERT_TRUE(advice.best) << advice.refusal;
  EXPECT_EQ(advice.methods[advice.best->method].method.name, "fem-full");
  EXPECT_TRUE(advice.best->extrapolated);
  EXPECT_LE(advice.best->cpu, 1000);
  const Outcome outcome = follow(scene, question, advice, engine);
  EXPECT_NEAR(outcome.cpu / advice.best->cpu, 1, 0.05);
}

TEST_F(Advise, NoTwoMethodsAgree) {
  question.error = 1;
  question.methods = {method_named("sph-corrected"), method_named("sph-classic-share")};
  const Advice advice = advise(scene, question, engine);
  EXPECT_FALSE(advice.best);
  EXPECT_THAT(advice.refusal, HasSubstr("no two methods approach the same limit"));
  EXPECT_THAT(describe(scene, question, advice), HasSubstr("none: no two methods"));
}

// Two runs that have the same method for a body agree in any case.
TEST_F(Advise, AMethodOfTheSameBodyConfirmsNothing) {
  question.error = 1;
  question.methods = {method_named("fem-full"), read_body_methods("box=fem-full", &scene)};
  const Advice advice = advise(scene, question, engine);
  EXPECT_FALSE(advice.best);
  EXPECT_THAT(advice.refusal, HasSubstr("no two methods approach the same limit"));
  question.methods.push_back(read_body_methods("box=sph-corrected", &scene));
  EXPECT_EQ(advise(scene, question, engine).meeting, 2);
}

TEST_F(Advise, ValuesWithoutALimit) {
  question.error = 1;
  engine.run = [](const Scene&, const BodyMethods&, const Resolution& resolution, const RunOptions&) {
    return at(-0.005 * (1 + 0.1 * std::cos(7 / resolution.spacing)), 0, resolution.spacing);
  };
  const Advice advice = advise(scene, question, engine);
  EXPECT_FALSE(advice.best);
  EXPECT_FALSE(advice.refusal.empty());
}

TEST_F(Advise, AMethodThatFailsIsNamedAndOthersGoOn) {
  question.error = 1;
  question.methods.push_back(method_named("sph-virtual"));
  const auto run = engine.run;
  engine.run = [run](const Scene& s, const BodyMethods& method, const Resolution& resolution,
                     const RunOptions& o) {
    if (method.name == "sph-virtual") throw std::runtime_error("virtual particles want a box");
    return run(s, method, resolution, o);
  };
  const Advice advice = advise(scene, question, engine);
  EXPECT_TRUE(advice.best);
  EXPECT_THAT(describe(scene, question, advice), HasSubstr("virtual particles want a box"));
}

TEST_F(Advise, OptionsAreReadWithTheirUnits) {
  AdviseCommand c;
  c.error = "1%";
  c.component = "y";
  EXPECT_NEAR(*question_of(c, scene).error, 1, 1e-12);
  c.error = "0.01";
  EXPECT_NEAR(*question_of(c, scene).error, 1, 1e-12);
  c.error = "";
  c.within = "10min";
  EXPECT_NEAR(*question_of(c, scene).within, 600, 1e-9);
  EXPECT_EQ(question_of(c, scene).quantity.reduce, Reduce::final);
  const auto refused = [&](auto change) {
    AdviseCommand bad = c;
    change(bad);
    try {
      question_of(bad, scene);
    } catch (const BadCommand& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused([](auto& b) { b.error = "1%"; }), HasSubstr("such as --error 1%, or a time"));
  EXPECT_THAT(refused([](auto& b) { b.within = "", b.error = "one"; }), HasSubstr("0.01 or 1%"));
  EXPECT_THAT(refused([](auto& b) { b.within = "", b.error = "1 N"; }), HasSubstr("0.01 or 1%"));
  EXPECT_THAT(refused([](auto& b) { b.within = "", b.error = "0"; }), HasSubstr("0.01 or 1%"));
  EXPECT_THAT(refused([](auto& b) { b.within = "10 mm"; }), HasSubstr("a time above zero"));
  EXPECT_THAT(refused([](auto& b) { b.probe = "tpi"; }), HasSubstr("did you mean \"tip\"?"));
  EXPECT_THAT(refused([](auto& b) { b.reduce = "peek"; }), HasSubstr("did you mean \"peak\"?"));
  EXPECT_THAT(refused([](auto& b) { b.component = "xx"; }), HasSubstr("tip has no \"xx\""));
  EXPECT_THAT(refused([](auto& b) { b.methods = {"fem-ful"}; }), HasSubstr("did you mean \"fem-full\"?"));
  scene.probes.clear();
  EXPECT_THAT(refused([](auto&) {}), HasSubstr("has no probe"));
}

// A study asks for advice, makes the advised run and measures its error.
TEST_F(Advise, AStudyFollowsIt) {
  const Folder folder("advice");
  folder.write("beam/scene.toml", cantilever_toml);
  const Study study = read_study(folder.write("beam/study.toml", R"(title = "A study"
[[runs]]
methods = ["fem-full"]
spacing = ["20 mm"]
)" + tip_quantity("tip") + R"([[advice]]
quantity = "tip"
error = 0.1
methods = ["fem-full", "sph-corrected"]
)"));
  Row row;
  row.scene = "scene.toml", row.quantity = "tip", row.limit = -5.005;
  const auto followed = follow_advice(study, {row}, engine, {});
  ASSERT_EQ(followed.size(), 1u);
  ASSERT_TRUE(followed[0].outcome);
  EXPECT_NEAR(*followed[0].error_vs_limit_percent, followed[0].outcome->error - 0.1, 0.01);
  EXPECT_THAT(csv(followed), HasSubstr("scene.toml,tip,error 0.1 %,fem-full,9.0909"));
  EXPECT_THAT(markdown(followed), HasSubstr("fem-full, 9.09 mm"));
}

}  // namespace
}  // namespace femsph::compare
