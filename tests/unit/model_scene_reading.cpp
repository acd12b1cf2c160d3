// The key "reading": whether stress is recovered or raw.

#include <gtest/gtest.h>

#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph::test {
namespace {

/// A bar with a probe of `quantity` and a section of stress; `output` is a table, `of_probe` further lines of
/// the probe.
std::string scene(const std::string& output, const std::string& of_probe,
                  const std::string& quantity = "stress") {
  using namespace scene_text;
  return "title = \"bar\"\n" + model("stress") + steel() + box("bar", "300 100 mm", thick("100 mm")) +
         load("x+", "1 0 kN") + output + probe("centre", quantity, "150 50 mm", of_probe) +
         section("middle", "stress", "150 0 mm", "150 100 mm") + scene_text::time("1 ms");
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
