// How a scene says by which rule stress is read.

#include <gtest/gtest.h>

#include "model/scene/reader/reader.hpp"

namespace femsph::test {
namespace {

std::string scene(const std::string& output, const std::string& of_probe,
                  const std::string& quantity = "stress") {
  return R"(title = "bar"
[model]
plane = "stress"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
[bodies.bar]
shape = "box"
size = ["300 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[[loads]]
at = "x+"
force = ["1 kN", "0 N"]
)" + output +
         R"([[probes]]
name = "centre"
quantity = ")" +
         quantity + "\"\npoint = [\"150 mm\", \"50 mm\"]\n" + of_probe + R"([[sections]]
name = "middle"
quantity = "stress"
from = ["150 mm", "0 mm"]
to = ["150 mm", "100 mm"]
[time]
duration = "1 ms"
)";
}

TEST(StressReading, IsTheRuleUnlessSaid) {
  const Scene plain = parse_scene(scene("", ""), "bar.toml");
  EXPECT_EQ(plain.probes[0].reading, StressReading::recovered);
  EXPECT_EQ(plain.sections[0].reading, StressReading::recovered);
  EXPECT_FALSE(plain.recovered_fields);
  const Scene one = parse_scene(scene("", "reading = \"raw\"\n"), "bar.toml");
  EXPECT_EQ(one.probes[0].reading, StressReading::raw);
  EXPECT_EQ(one.sections[0].reading, StressReading::recovered);
  const Scene all = parse_scene(
      scene("[output]\nreading = \"raw\"\nfields = \"both\"\n", "reading = \"recovered\"\n"), "bar.toml");
  EXPECT_EQ(all.probes[0].reading, StressReading::recovered);
  EXPECT_EQ(all.sections[0].reading, StressReading::raw);
  EXPECT_TRUE(all.recovered_fields);
}

void expect_fault(const std::string& text, const std::string& fault) {
  try {
    parse_scene(text, "bar.toml");
    ADD_FAILURE() << "no fault";
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()), "bar.toml:" + fault);
  }
}

TEST(StressReading, WrongWordsAreTold) {
  expect_fault(scene("", "reading = \"row\"\n"),
               R"(21:11: "reading" is "row"; expected "recovered" or "raw"; did you mean "raw"?)");
  expect_fault(scene("[output]\nfields = \"bot\"\n", ""),
               R"(18:10: "fields" is "bot"; expected "raw" or "both"; did you mean "both"?)");
  expect_fault(
      scene("[output]\nreadings = \"raw\"\n", ""),
      R"(18:1: unknown key "readings" in [output]; expected "reading" or "fields"; did you mean "reading"?)");
  expect_fault(
      scene("", "reading = \"raw\"\n", "displacement"),
      R"(21:11: "reading" says how stress and strain are read, and this reads neither; expected no such key)");
}

}  // namespace
}  // namespace femsph::test
