// Quantities as users write them. Expected values are the definitions of the units.

#include <gtest/gtest.h>

#include <stdexcept>

#include "model/input/units.hpp"

using namespace femsph;

namespace {

std::string complaint(const std::string& quantity, const Dimension& dimension) {
  try {
    to_si(quantity, dimension);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(Units, QuantitiesBecomeSi) {
  EXPECT_DOUBLE_EQ(to_si("1000 mm", dimension::length), 1.0);
  EXPECT_DOUBLE_EQ(to_si("1 inch", dimension::length), 0.0254);
  EXPECT_DOUBLE_EQ(to_si("210 GPa", dimension::pressure), 210e9);
  EXPECT_DOUBLE_EQ(to_si("210000 N/mm^2", dimension::pressure), 210e9);
  EXPECT_DOUBLE_EQ(to_si("-25 kN", dimension::force), -25e3);
  EXPECT_DOUBLE_EQ(to_si("50 ms", dimension::time), 0.05);
  EXPECT_DOUBLE_EQ(to_si("7.85 g/cm^3", dimension::density), 7850);
  EXPECT_DOUBLE_EQ(to_si("7.85e-9 t/mm^3", dimension::density), 7850);
  EXPECT_DOUBLE_EQ(to_si("9.81 m/s²", dimension::acceleration), 9.81);
  EXPECT_DOUBLE_EQ(to_si("1/s", dimension::rate), 1);
  EXPECT_DOUBLE_EQ(to_si("100 1/s", dimension::rate), 100);
  EXPECT_DOUBLE_EQ(to_si("2 /min", dimension::rate), 2.0 / 60);
}

TEST(Units, ZeroSignsAndBlanks) {
  EXPECT_EQ(to_si("0 N", dimension::force), 0.0);
  EXPECT_DOUBLE_EQ(to_si("+5mm", dimension::length), 0.005);
  EXPECT_DOUBLE_EQ(to_si("  5   mm ", dimension::length), 0.005);
}

TEST(Units, FaultsSayWhatWasExpected) {
  const std::string expected = "; expected a length with its unit, such as \"10 mm\"";
  EXPECT_EQ(complaint("10", dimension::length), "\"10\" has no unit" + expected);
  EXPECT_EQ(complaint("mm", dimension::length), "\"mm\" does not start with a number" + expected);
  EXPECT_EQ(complaint("", dimension::length), "\"\" does not start with a number" + expected);
  EXPECT_EQ(complaint("10 kg", dimension::length), "\"10 kg\" is not a length" + expected);
  EXPECT_EQ(complaint("10 mmm", dimension::length), "unknown unit \"mmm\" in \"10 mmm\"" + expected);
  EXPECT_EQ(complaint("nan mm", dimension::length), "\"nan mm\" does not start with a number" + expected);
  EXPECT_EQ(complaint("inf mm", dimension::length), "\"inf mm\" does not start with a number" + expected);
  EXPECT_EQ(
      complaint("1e999 mm", dimension::length), "\"1e999 mm\" is beyond the range of numbers" + expected);
  EXPECT_EQ(complaint("1e300 mm", dimension::length),
            "\"1e300 mm\" is too large or too small to compute with" + expected);
  EXPECT_EQ(complaint("10 m @ 5", dimension::length), "\"10 m @ 5\" holds a second number" + expected)
      << "a shifted origin is no factor";
}

// UDUNITS-2 would multiply: half a metre for one and a half, -2 mm for a range, 0.36 mm for a version number.
TEST(Units, OneNumberAQuantity) {
  const std::string expected = " holds a second number; expected a length with its unit, such as \"10 mm\"";
  for (const char* quantity : {"1 500 mm", "1,500 mm", "1'500 mm", "1\u00a0500 mm", "1.2.3 mm", "1-2 mm",
                               "1 +2 mm", "10 mm 2", "2*10 mm", "1/2 inch"})
    EXPECT_EQ(complaint(quantity, dimension::length), "\"" + std::string(quantity) + "\"" + expected);
  EXPECT_DOUBLE_EQ(to_si("5 kg/m3", dimension::density), 5);
  EXPECT_DOUBLE_EQ(to_si("5 kg m-3", dimension::density), 5);
  EXPECT_DOUBLE_EQ(to_si("5 kg m^-3", dimension::density), 5);
  EXPECT_DOUBLE_EQ(to_si("5 m s**-2", dimension::acceleration), 5);
  EXPECT_DOUBLE_EQ(to_si("5 (1/s)", dimension::rate), 5);
}

// A "ton" is 2000 pounds to UDUNITS-2, and 1000 kg to people who compute in mm, t and s.
TEST(Units, TonsAreRefused) {
  const std::string why =
      " can be read in two ways: \"ton\" is the short ton of 907.18 kg here and 1000 kg elsewhere; expected "
      "\"t\" or \"tonne\" for 1000 kg, "
      "\"short_ton\" for 907.18 kg";
  EXPECT_EQ(complaint("5 ton", dimension::mass), "\"5 ton\"" + why);
  EXPECT_EQ(complaint("7.85e-9 ton/mm^3", dimension::density), "\"7.85e-9 ton/mm^3\"" + why);
  EXPECT_EQ(complaint("3 kton", dimension::mass), "\"3 kton\"" + why);
  EXPECT_DOUBLE_EQ(to_si("1 t", dimension::mass), 1000);
  EXPECT_DOUBLE_EQ(to_si("1 tonne", dimension::mass), 1000);
  EXPECT_DOUBLE_EQ(to_si("1 short_ton", dimension::mass), 907.18474) << "2000 pounds of 0.45359237 kg";
}

TEST(Units, FaultsKeepTheTerminalQuiet) {
  testing::internal::CaptureStderr();
  complaint("10 ((m^99999999999", dimension::length);
  complaint("10 m^999", dimension::length);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// A turn is 2 pi rad. "1/s" can mean radians or turns.
TEST(Units, ASpinNeedsAnAngle) {
  const double pi = 3.14159265358979323846;
  EXPECT_DOUBLE_EQ(to_si("50 rad/s", dimension::rotation), 50);
  EXPECT_DOUBLE_EQ(to_si("60 rpm", dimension::rotation), 2 * pi);
  EXPECT_DOUBLE_EQ(to_si("2 revolutions/s", dimension::rotation), 4 * pi);
  EXPECT_DOUBLE_EQ(to_si("180 degree/s", dimension::rotation), pi);
  EXPECT_DOUBLE_EQ(to_si("1 krad/min", dimension::rotation), 1000.0 / 60);
  for (const char* text : {"1 Hz", "1 kHz", "60 1/min", "1/s", "1 hertz", "2 s^-1", "0 Hz"})
    EXPECT_EQ(complaint(text, dimension::rotation),
              "\"" + std::string(text) +
                  "\" is a frequency, of which one per second may mean 1 rad/s or one turn, 2 pi rad/s; "
                  "expected a rate of "
                  "rotation with its unit, such as \"50 rad/s\" or \"3000 rpm\" (turns a minute)");
  EXPECT_NE(complaint("1 m/s", dimension::rotation), "");
  EXPECT_NE(complaint("1 rad", dimension::rotation), "");
}

TEST(Units, ARateCountsNoTurns) {
  EXPECT_DOUBLE_EQ(to_si("10 %/s", dimension::rate), 0.1);
  for (const char* text : {"5 Hz", "5 kHz", "5 hertz", "5 rad/s", "5 rpm"})
    EXPECT_EQ(complaint(text, dimension::rate),
              "\"" + std::string(text) +
                  "\" counts turns or angles, which may or may not bring a factor of 2 pi; expected a rate "
                  "with its unit, such as \"100 1/s\"");
}
