// A number is that of the body that its probe or section names, in whatever order the scene lists them. A
// theory of one body refuses other scenes. A value that is missing is reported and not replaced by another.

#include <gmock/gmock.h>

#include <cmath>

#include "compare/measure/errors.hpp"
#include "compare/measure/reduce.hpp"
#include "compare/reference/theory.hpp"
#include "compare_support.hpp"
#include "model/scene/shapes/box.hpp"

namespace femsph::compare {
namespace {

using ::testing::HasSubstr;
using namespace test;

/// A thick beam of hard steel over a thin one of soft steel, in this order or the other.
Scene two_bodies(bool swapped) {
  Scene scene = cantilever();
  scene.supports.clear(), scene.loads.clear();
  scene.settling.reset();
  Plasticity hard{}, soft{};
  hard.yield = 3e8, soft.yield = 1e8;
  scene.materials["hard"] = {"hard", 2.1e11, 0.3, 7850, hard};
  scene.materials["soft"] = {"soft", 2.1e11, 0.3, 7850, soft};
  const Body thick{"thick", std::make_shared<Box>(2, Point{0, 0, 0}, Point{1, 0.1, 0}), 0.3, "hard"};
  const Body thin{"thin", std::make_shared<Box>(2, Point{0, 0.2, 0}, Point{1, 0.1, 0}), 0.1, "soft"};
  scene.bodies = swapped ? std::vector<Body>{thin, thick} : std::vector<Body>{thick, thin};
  const std::size_t of_thick = swapped, of_thin = !swapped;
  scene.sections.push_back({"inner", of_thin, quantity_named("stress"), {0.1, 0.2, 0}, {0.1, 0.3, 0}, 3});
  scene.sections.push_back({"level", of_thin, quantity_named("stress"), {0.1, 0.2, 0}, {0.2, 0.2, 0}, 3});
  scene.probes.push_back({"q", of_thin, quantity_named("equivalent_stress"), {0.5, 0.25, 0}});
  scene.probes.push_back({"p", of_thin, quantity_named("plastic_strain"), {0.5, 0.25, 0}});
  scene.probes.push_back({"other", of_thick, quantity_named("plastic_strain"), {0.5, 0.05, 0}});
  return scene;
}

QuantitySpec of_section(const char* section, Reduce reduce) {
  QuantitySpec q;
  q.name = "quantity", q.observed = {"", section, "", "", "xx", {"N m", 1}}, q.reduce = reduce;
  return q;
}
QuantitySpec of_column(const char* column, Reduce reduce) {
  QuantitySpec q;
  q.name = "quantity", q.observed = {"", "", column, "", "", {"", 1}}, q.reduce = reduce;
  return q;
}
RunResult history(std::vector<double> time, std::vector<double> value) {
  RunResult r;
  r.history.columns = {{"time", "s", std::move(time)},
                       {"q_equivalent", "Pa", value},
                       {"p_equivalent", "1", std::vector<double>(value.size())},
                       {"x", "N", value}};
  return r;
}

// Stress +-30 MPa at the ends of a height of 100 mm, by the trapezoid rule over two halves: 2 (0.05/2) 30e6
// 0.05 b = 75 kN b (the integral is 50 kN b).
TEST(Bodies, AMomentTakesTheThicknessOfItsOwnBody) {
  for (const bool swapped : {false, true}) {
    const Scene scene = two_bodies(swapped);
    EXPECT_NEAR(reduce(of_section("inner", Reduce::moment), result(0, 30e6, 0.01), scene, nullptr).value,
                75e3 * 0.1, 1e-6);
  }
}

TEST(Bodies, AMomentHasOneSignWhicheverEndComesFirst) {
  Scene scene = two_bodies(false);
  const double up = reduce(of_section("inner", Reduce::moment), result(0, 30e6, 0.01), scene, nullptr).value;
  std::swap(scene.sections[0].from, scene.sections[0].to);
  EXPECT_NEAR(
      reduce(of_section("inner", Reduce::moment), result(0, -30e6, 0.01), scene, nullptr).value, up, 1e-6);
}

TEST(Bodies, AMomentIsOfASectionAlongY) {
  Scene scene = two_bodies(false);
  RunResult run = result(0, 30e6, 0.01);
  run.profiles["level"] = run.profiles["inner"];
  EXPECT_THAT(message_of([&] { reduce(of_section("level", Reduce::moment), run, scene, nullptr); }),
              HasSubstr("a moment needs a section of stress along y, and \"level\" is not one"));
  EXPECT_THAT(message_of([&] { reduce(of_section("level", Reduce::fibre_upper), run, scene, nullptr); }),
              HasSubstr("has no upper and no lower end"));
}

// The limit of a moment is a moment, and not the stress of the upper fibre.
TEST(Bodies, TheLimitOfAMomentIsAMoment) {
  Scene scene = two_bodies(false);
  scene.settling.emplace();
  fem::StaticLimit limit;
  limit.sections["inner"] = {{-15e6}, {0}, {15e6}};
  const Reduced reduced = reduce(of_section("inner", Reduce::moment), result(0, 30e6, 0.01), scene, &limit);
  EXPECT_NEAR(*reduced.limit, 75e3 * 0.1 / 2, 1e-6);
  EXPECT_NEAR(*reduced.error_vs_limit_percent, 100, 1e-9);
  scene.settling.reset();  // a motion has no static limit
  EXPECT_FALSE(reduce(of_section("inner", Reduce::moment), result(0, 30e6, 0.01), scene, &limit).limit);
}

// 120 MPa are 20 % over the yield stress of the soft body, and 60 % below that of the hard one.
TEST(Bodies, ExcessIsOverTheYieldCurveOfItsOwnBody) {
  QuantitySpec q = of_column("", Reduce::excess);
  q.observed = {"q", "", "", "", "equivalent", {"%", 0.01}},
  q.along = {"p", "", "", "", "equivalent", {"1", 1}};
  for (const bool swapped : {false, true})
    EXPECT_NEAR(reduce(q, history({0, 1}, {0, 1.2e8}), two_bodies(swapped), nullptr).value, 20, 1e-9);
  q.along.probe = "other";
  EXPECT_THAT(message_of([&] {
                reduce(q, history({0, 1}, {0, 1.2e8}), two_bodies(false), nullptr);
              }),
              HasSubstr("read in two bodies, \"thin\" and \"thick\""));
}

TEST(Sweep, NotANumberIsReported) {
  const Scene scene = two_bodies(false);
  const double nan = std::nan("");
  for (const Reduce reduction : {Reduce::max, Reduce::min, Reduce::peak, Reduce::mean, Reduce::integral,
                                 Reduce::duration, Reduce::frequency})
    EXPECT_THAT(message_of([&] {
                  reduce(of_column("x", reduction), history({0, 1, 2, 3}, {0, nan, 1, 0}), scene, nullptr);
                }),
                HasSubstr("not a finite number in sample 2 of 4"));
}

TEST(Sweep, WindowsAndDurationsThatTheHistoryDoesNotHold) {
  const Scene scene = two_bodies(false);
  QuantitySpec q = of_column("x", Reduce::integral);
  q.window = {0.4, 0.6};
  EXPECT_THAT(message_of([&] {
                reduce(q, history({0, 0.2, 0.5, 1}, {1, 1, 1, 1}), scene, nullptr);
              }),
              HasSubstr("one sample has no integral"));
  q.window = {0.25, 0.45};
  EXPECT_THAT(message_of([&] {
                reduce(q, history({0, 0.2, 0.5, 1}, {1, 1, 1, 1}), scene, nullptr);
              }),
              HasSubstr("no sample in the window"));
  q.window = {0, 5};
  EXPECT_THAT(message_of([&] {
                reduce(q, history({0, 0.2, 0.5, 1}, {1, 1, 1, 1}), scene, nullptr);
              }),
              HasSubstr("the history ends at 1000 ms, before the end of the window at 5000 ms"));
  EXPECT_THAT(message_of([&] {
                reduce(of_column("x", Reduce::duration), history({0, 1, 2}, {0, 1, 1}), scene, nullptr);
              }),
              HasSubstr("not zero at its end"));
  EXPECT_THAT(message_of([&] {
                reduce(of_column("x", Reduce::duration), history({0, 1, 2}, {0, 1, 0}), scene, nullptr);
              }),
              HasSubstr("only one sample of the history is not zero"));
}

TEST(Sweep, AColumnInAnotherUnitIsRefused) {
  QuantitySpec q = of_column("x", Reduce::final);
  q.observed.si = "m";
  EXPECT_THAT(message_of([&] {
                reduce(q, history({0, 1}, {1, 1}), two_bodies(false), nullptr);
              }),
              HasSubstr("the column x is in N, not in m"));
}

TEST(Sweep, RestHasNoFrequency) {
  std::vector<double> time, still;
  for (int i = 0; i < 100; ++i) time.push_back(i), still.push_back(1 + 1e-13 * std::sin(i));
  EXPECT_FALSE(dominant_frequency(time, still));
  still[3] = std::nan("");
  EXPECT_FALSE(dominant_frequency(time, still));
}

TEST(Sweep, L2AgainstAZeroTheoryIsNotTakenFromTheLimitInstead) {
  Scene scene = cantilever();
  scene.settling.emplace();
  scene.sections.push_back(
      {"inner", 0, quantity_named("stress"), {1, 0, 0}, {1, 0.1, 0}, 3});  // theory's stress is zero at the
                                                                           // loaded end
  QuantitySpec q = of_section("inner", Reduce::l2);
  q.theory = "cantilever_stress";
  fem::StaticLimit limit;
  limit.sections["inner"] = {{-1e6}, {0}, {1e6}};
  EXPECT_THAT(message_of([&] { reduce(q, result(0, 30e6, 0.01), scene, &limit); }),
              HasSubstr("the profile of theory is zero all along"));
}

double theory(const char* name, const Scene& scene) { return theory_named(name).value(scene, {0, 0, 0}, 0); }

TEST(Premises, OfTheBarAndTheCantilever) {
  const auto refused = [](const char* name, Scene scene, auto change) {
    change(scene);
    return message_of([&] { theory(name, scene); });
  };
  EXPECT_THAT(refused("bar_stress", bar(),
                      [](Scene& s) {
                        s.loads[0].place.sides = {"x+", "y+"};
                      }),
              HasSubstr("the loads have a moment about the middle of x+"));
  EXPECT_EQ(refused("bar_stress", bar(),
                    [](Scene& s) {
                      s.loads.push_back(s.loads[0]),
                          s.loads[0].place.sides = {"x+", "y+"}, s.loads[1].place.sides = {"x+", "y-"};
                    }),
            "")
      << "two halves on the two corners are centric";
  EXPECT_EQ(refused("cantilever_tip", cantilever(),
                    [](Scene& s) {
                      s.loads[0].place.sides = {"x+", "y+"};
                    }),
            "");
  EXPECT_THAT(refused("cantilever_tip", steel_box(0.3, 0.1, {0, -1, 0}, 0.1),
                      [](Scene& s) {
                        s.loads[0].place.sides = {"x+", "y+", "z+"};
                      }),
              HasSubstr("moment about the middle of x+"));
  EXPECT_THAT(refused("cantilever_tip", cantilever(),
                      [](Scene& s) {
                        s.symmetries.push_back({Place{0, {"y-"}, {}, {}}});
                      }),
              HasSubstr("a plane of symmetry"));
  EXPECT_THAT(refused("cantilever_tip", cantilever(), [](Scene& s) { s.bars.push_back({}); }),
              HasSubstr("this body has reinforcing bars"));
  EXPECT_THAT(
      refused("cantilever_tip", cantilever(), [](Scene& s) { s.initial_displacements.push_back({}); }),
      HasSubstr("an initial displacement"));
  EXPECT_THAT(refused("cantilever_tip", cantilever(),
                      [](Scene& s) {
                        s.supports[0].velocity = {0, 1, 0};
                      }),
              HasSubstr("a support moves"));
  EXPECT_THAT(refused("cantilever_tip", cantilever(), [](Scene& s) { s.supports[0].mean = true; }),
              HasSubstr("not held along x"));
  EXPECT_THAT(refused("cantilever_tip", cantilever(),
                      [](Scene& s) {
                        s.supports[0].place.within = Region{{0, 0, 0}, {0, 0.05, 0}};
                      }),
              HasSubstr("not held along x"));
  EXPECT_THAT(refused("cantilever_tip", cantilever(),
                      [](Scene& s) { s.materials["steel"].parameters = NeoHookean::Parameters{}; }),
              HasSubstr("neo-Hookean"));
  EXPECT_THAT(refused("bar_period", bar(), [](Scene& s) { s.damping = 100; }), HasSubstr("has damping"));
  EXPECT_THAT(refused("cantilever_tip_peak", cantilever(), [](Scene& s) { s.settling.emplace(); }),
              HasSubstr("has damping"));
  // P L (h/2)/I = 25 kN 1 m 50 mm/8.33e-6 m^4 = 150 MPa: elastic at rest up to there, and twice that under a
  // step.
  const auto yields_at = [](double yield) {
    return [yield](Scene& s) { s.materials["steel"].parameters = Plasticity{yield, 0}; };
  };
  EXPECT_EQ(refused("cantilever_tip", cantilever(), yields_at(151e6)), "");
  EXPECT_THAT(refused("cantilever_tip", cantilever(), yields_at(149e6)),
              HasSubstr("its stress reaches 150 MPa, above its yield stress of 149 MPa"));
  EXPECT_THAT(refused("cantilever_tip_peak", cantilever(), yields_at(151e6)),
              HasSubstr("its stress reaches 300 MPa"));
}

TEST(Premises, OfImpactAndThePlasticMoment) {
  Scene scene = bar();
  scene.loads.clear();
  scene.materials["steel"].parameters = Plasticity{3e8, 2e9};
  scene.initial_velocities.push_back({0, {-10, 0, 0}});
  EXPECT_LT(theory("impact_stress", scene), 0);
  const auto refused = [](const char* name, Scene changed, auto change) {
    change(changed);
    return message_of([&] { theory(name, changed); });
  };
  const auto impact = [&](auto change) { return refused("impact_stress", scene, change); };
  EXPECT_THAT(impact([](Scene& s) { s.bodies.push_back(s.bodies[0]); }), HasSubstr("2 bodies"));
  EXPECT_THAT(impact([](Scene& s) { s.initial_velocities[0].velocity[0] = 10; }), HasSubstr("not along -x"));
  EXPECT_THAT(impact([](Scene& s) { s.initial_velocities[0].spin[2] = 1; }), HasSubstr("not along -x"));
  EXPECT_THAT(impact([](Scene& s) { s.initial_velocities.push_back(s.initial_velocities[0]); }),
              HasSubstr("2 initial velocities"));
  EXPECT_THAT(impact([](Scene& s) { s.plane = Plane::strain; }), HasSubstr("plane strain"));
  EXPECT_THAT(
      impact([](Scene& s) { s.supports[0].place.sides = {"x+"}; }), HasSubstr("a support is not on x-"));
  EXPECT_THAT(impact([](Scene& s) { s.supports.clear(); }), HasSubstr("not held along x"));
  EXPECT_THAT(impact([](Scene& s) { s.materials["steel"].parameters = LinearElastic::Parameters{}; }),
              HasSubstr("its material is elastic"));
  scene.initial_velocities.clear();
  EXPECT_THAT(message_of([&] { theory("plastic_moment", scene); }), HasSubstr("its material hardens"));
  scene.materials["steel"].parameters = Plasticity{3e8, 0};
  EXPECT_NEAR(theory("plastic_moment", scene), 3e8 * 0.1 * 0.1 * 0.1 / 4, 1e-3);
  EXPECT_THAT(
      refused("plastic_moment", scene,
              [](Scene& s) { s.bodies.insert(s.bodies.begin(), s.bodies[0]), s.bodies[0].thickness = 7; }),
      HasSubstr("2 bodies"));
  EXPECT_THAT(
      refused("plastic_moment", scene, [](Scene& s) { s.plane = Plane::strain; }), HasSubstr("plane strain"));
}

}  // namespace
}  // namespace femsph::compare
