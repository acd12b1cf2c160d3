// `femsph advise`: the advised run has the error that was asked for.

#include "compare/price/advise.hpp"

#include <gmock/gmock.h>

#include "support.hpp"

namespace femsph::test {
namespace {

using compare::Question;

Question tip(const std::vector<const char*>& methods) {
  Question q;
  q.quantity.name = "tip_y";
  q.quantity.observed = {"tip", "", "", "", "y", {"mm", 1e-3}};
  for (const char* name : methods) q.methods.push_back(compare::method_named(name));
  q.budget = 3;
  return q;
}

/// Runs as they are, at a price of 10 ns a unit and step: how far the ladders climb within their budget does
/// not depend on the machine.
compare::Engine priced_alike() {
  return {[](const Scene& scene, const compare::BodyMethods& method, const compare::Resolution& resolution,
             const compare::RunOptions& options) {
            compare::RunResult r = compare::run_scene(scene, method, resolution, options);
            r.price.total_cpu = 1e-8 * double(r.price.steps) * double(r.price.units);
            return r;
          },
          fem::static_limit};
}

// The tip of the paper's cantilever moves by 4.7901 mm (elastic limit by FEM of degree 4, which is not used
// by the advice).
TEST(Advise, TheAdvisedRunHasTheErrorThatWasAsked) {
  const Scene scene = cantilever(25e3, settle);
  const double limit = 1e3 * fem::static_limit(scene, {100, 10, 1}, 4).probes.at("tip")[1];
  for (const auto& methods : {std::vector<const char*>{"fem-full", "fem-sri", "sph-corrected"},
                              std::vector<const char*>{"sph-corrected", "fem-one-point"}}) {
    Question q = tip(methods);
    q.error = 2;
    const compare::Engine engine = priced_alike();
    const auto advice = compare::advise(scene, q, engine);
    ASSERT_TRUE(advice.best) << compare::describe(scene, q, advice);
    EXPECT_GE(advice.meeting, 2);
    EXPECT_TRUE(advice.both_kinds);
    EXPECT_NEAR(*advice.methods[*advice.reference].limit / limit, 1, 0.005);
    const auto made = compare::follow(scene, q, advice, engine);
    EXPECT_LE(std::abs(error(made.value, limit)), 2.0) << compare::describe(scene, q, advice);
    fmt::print("{}{}", compare::describe(scene, q, advice), compare::describe(advice, q, made));
  }
}

// Uncorrected SPH approaches a limit of its own; with a single element beside it no two limits agree, and
// advice is refused.
TEST(Advise, ClassicSphDoesNotConfirmAnElement) {
  const Scene scene = cantilever(25e3, settle);
  Question q = tip({"fem-full", "sph-classic-share"});
  q.error = 1;
  const auto advice = compare::advise(scene, q, priced_alike());
  EXPECT_FALSE(advice.best) << compare::describe(scene, q, advice);
  EXPECT_THAT(advice.refusal, testing::HasSubstr("no two methods"));
}

}  // namespace
}  // namespace femsph::test
