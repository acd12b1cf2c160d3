// The law of bars in one dimension, the rows that carry them, and how a scene names bars, symmetry planes and
// mean supports.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/motion/bodies/bars.hpp"
#include "model/motion/effects/catalogue.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph {
namespace {

// E = 200 GPa, yield 400 MPa, H = 50 GPa: loading to strain e > yield/E gives sigma = yield + E H/(E + H) (e
// - yield/E); E H/(E + H) = 40 GPa. Back to zero strain it yields in compression, isotropically, at the
// stress reached.
TEST(BarLaw, BilinearPathAndItsWork) {
  const BarLaw law{200e9, 400e6, 50e9, 7850};
  BarState s;
  EXPECT_DOUBLE_EQ(law.advance(0.001, s), 200e6);
  EXPECT_DOUBLE_EQ(s.dissipated, 0);
  EXPECT_NEAR(law.advance(0.01, s), 400e6 + 40e9 * 0.008, 1);
  EXPECT_NEAR(law.advance(0.01, s), 720e6, 1);
  EXPECT_NEAR(law.advance(0.01 - 1.44e9 / 200e9, s), -720e6, 1);  // elastic down to minus the stress reached
  EXPECT_NEAR(law.advance(0, s), -720e6 - 40e9 * (0.01 - 0.0072), 1);
  // The trapezoid of stress over the path in small steps is the stored and the dissipated energy, step by
  // step.
  BarState t;
  double work = 0, before = 0;
  for (int n = 1; n <= 300; ++n) {
    const double e = 0.01 * std::sin(0.05 * n), old = 0.01 * std::sin(0.05 * (n - 1)),
                 now = law.advance(e, t);
    work += 0.5 * (before + now) * (e - old);
    before = now;
    ASSERT_NEAR(work, law.stored(e, t) + t.dissipated, 1e-9 * work + 1e-6);
  }
  EXPECT_GT(t.dissipated, 0);
}

TEST(BarLaw, ElasticWithoutYieldAndPerfectWithoutHardening) {
  BarState s, p;
  EXPECT_DOUBLE_EQ(BarLaw::make(200e9, 7850, {}).advance(1.0, s), 200e9);
  Plasticity plastic;
  plastic.yield = 400e6;
  EXPECT_NEAR(BarLaw::make(200e9, 7850, Plastic::bar(plastic)).advance(0.02, p), 400e6, 1);
}

using namespace scene_text;

const std::string beam = "title = \"half beam\"\n" + model("stress") +
                         material("concrete", "elastic", "25 GPa", "0.2", "2400 kg/m^3") +
                         box("beam", "1000 250 mm", thick("150 mm"), "concrete") + R"([[symmetry]]
at = "x-"
[[supports]]
at = "y-"
within = [["900 mm", "0 mm"], ["950 mm", "0 mm"]]
fix = ["y"]
mode = "mean"
[bars.bottom]
from = ["0 mm", "42 mm"]
to = ["1000 mm", "42 mm"]
area = "253.4 mm^2"
material = "concrete"
)" + scene_text::time("1 ms");

TEST(SceneParts, AreRead) {
  const Scene s = parse_scene(beam, "beam.toml");
  ASSERT_EQ(s.symmetries.size(), 1u);
  EXPECT_EQ(s.symmetries[0].axis(), 0);
  EXPECT_FALSE(s.symmetries[0].upper());
  EXPECT_TRUE(s.supports.at(0).mean);
  EXPECT_NEAR(s.supports[0].place.within->upper[0], 0.95, 1e-15);
  ASSERT_EQ(s.bars.size(), 1u);
  EXPECT_NEAR(s.bars[0].area, 253.4e-6, 1e-15);
  EXPECT_EQ(s.bars[0].axis(), 0);
  ASSERT_EQ(s.holds().size(), 2u);
  EXPECT_THAT(s.holds()[1].fixed, testing::ElementsAre(true, false, false));
  EXPECT_THAT(effects_on(s), testing::ElementsAre("supports", "symmetry", "bars"));
}

std::string with(const std::string& old, const std::string& instead) { return replaced(beam, old, instead); }

void expect_fault(const std::string& text, const char* message) {
  EXPECT_THAT([&] { parse_scene(text, "beam.toml"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr(message)));
}

TEST(SceneParts, FaultsAreNamed) {
  expect_fault(with("at = \"x-\"", "at = \"left\""), "unknown side \"left\"");
  expect_fault(with("[[symmetry]]", "[[symmetry]]\nat = \"x-\"\n[[symmetry]]"),
               "side \"x-\" is a symmetry plane already");
  expect_fault(with("to = [\"1000 mm\", \"42 mm\"]", "to = [\"1000 mm\", \"50 mm\"]"), "runs along no axis");
  expect_fault(
      with("area = \"253.4 mm^2\"\nmaterial = \"concrete\"", "area = \"253.4 mm^2\"\nmaterial = \"steel\""),
      "unknown material \"steel\"");
  expect_fault(with("[\"950 mm\", \"0 mm\"]]", "[\"850 mm\", \"0 mm\"]]"), "lies above the second along x");
  expect_fault(with("mode = \"mean\"", "mode = \"middle\""), "expected");
}

// Points every 20 mm: the bar at 42 mm belongs to the rows at 40 and 60 mm by 90 % and 10 %; its length is
// shared out exactly.
TEST(BarRows, ShareABarBetweenTwoRows) {
  const Scene s = parse_scene(beam, "beam.toml");
  std::vector<Point> points;
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i <= 50; ++i) points.push_back({0.02 * i, 0.02 * j, 0});
  const auto rows = bar_rows(s, 0, points, 1e-8);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[0].area, 0.9 * s.bars[0].area, 1e-12);
  EXPECT_NEAR(rows[1].area, 0.1 * s.bars[0].area, 1e-12);
  EXPECT_NEAR(rows[0].at[1], 0.04, 1e-12);
  for (const BarRow& row : rows) {
    double points_hold = 0, segments_hold = 0;
    for (double l : row.length) points_hold += l;
    for (double l : row.segment) segments_hold += l;
    EXPECT_NEAR(points_hold, 1, 1e-12);
    EXPECT_NEAR(segments_hold, 1, 1e-12);
    EXPECT_NEAR(row.length[0], 0.01, 1e-12);
  }
  EXPECT_EQ(describe(rows, s), ", bar bottom at y = 40 mm (90 %) and y = 60 mm (10 %)");
  for (Point& p : points) p[1] += 1e-3 * std::sin(1e3 * p[0]);
  EXPECT_THROW(bar_rows(s, 0, points, 1e-8), std::runtime_error);
}

}  // namespace
}  // namespace femsph
