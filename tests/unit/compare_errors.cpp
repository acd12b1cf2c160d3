// Errors on functions whose distance is known.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/measure/errors.hpp"

namespace femsph::compare {
namespace {

TEST(Errors, PercentIsPositiveWhenLargerInMagnitude) {
  EXPECT_NEAR(*percent_error(1.1, 1.0), 10, 1e-12);
  EXPECT_NEAR(*percent_error(-1.1, -1.0), 10, 1e-12);
  EXPECT_NEAR(*percent_error(-0.9, -1.0), -10, 1e-12);
  EXPECT_FALSE(percent_error(1, 0));
}

// v = 1.1 r is off by 10 % whatever r and however uneven the points.
TEST(Errors, L2OfAScaledProfile) {
  const std::vector<double> x = {0, 0.1, 0.4, 1}, r = {-1, 2, 0, 5}, v = {-1.1, 2.2, 0, 5.5};
  EXPECT_NEAR(*percent_l2(x, v, r), 10, 1e-12);
  EXPECT_FALSE(percent_l2(x, v, std::vector<double>(4, 0.0)));
  EXPECT_THROW(percent_l2(x, v, std::vector<double>(3, 1.0)), std::invalid_argument);
}

// One unequal end of an interval of three points: the trapezoid rule weighs it by a quarter of the length
// against all.
TEST(Errors, L2WeighsByTheTrapezoidRule) {
  const std::vector<double> x = {0, 1, 2}, r = {1, 1, 1}, v = {2, 1, 1};
  EXPECT_NEAR(*percent_l2(x, v, r), 100 * std::sqrt(0.5 / 2), 1e-12);
}

TEST(Errors, ResamplingIsExactOnLinesAndEmptyBeyondTheEnds) {
  const std::vector<double> x = {0, 1, 3}, v = {0, 2, 6};
  const auto at = resample(x, v, std::vector<double>{0, 0.5, 2, 3, 3.1, -0.1});
  EXPECT_DOUBLE_EQ(at[1], 1);
  EXPECT_DOUBLE_EQ(at[2], 4);
  EXPECT_DOUBLE_EQ(at[3], 6);
  EXPECT_TRUE(std::isnan(at[4]) && std::isnan(at[5]));
}

std::vector<double> times(double end, int count) {
  std::vector<double> t(count + 1);
  for (int i = 0; i <= count; ++i) t[i] = end * i / count;
  return t;
}

// 4.18 periods of 1 - cos with a second mode of 1/39 of the amplitude: the step response of a cantilever. 400
// samples.
TEST(Errors, FrequencyOfAStepResponse) {
  const double f = 83.552;
  const auto t = times(0.05, 400);
  std::vector<double> v;
  for (const double s : t) {
    const double w = 2 * std::numbers::pi * f * s;
    v.push_back(-(1 - std::cos(w)) - 0.0255 * (1 - std::cos(6.267 * w)));
  }
  EXPECT_NEAR(*dominant_frequency(t, v), f, 0.01 * f);
}

TEST(Errors, FrequencyDoesNotNeedWholePeriodsOrAZeroMean) {
  const auto t = times(1, 5000);
  for (const double periods : {2.3, 3.7, 10.1}) {
    std::vector<double> v;
    for (const double s : t) v.push_back(5 + std::sin(2 * std::numbers::pi * periods * s));
    EXPECT_NEAR(*dominant_frequency(t, v), periods, 1e-3 * periods);
  }
}

TEST(Errors, NoFrequencyWithoutOscillation) {
  const auto t = times(1, 100);
  EXPECT_FALSE(dominant_frequency(t, t));
  EXPECT_FALSE(dominant_frequency(t, std::vector<double>(t.size(), 1.0)));
}

}  // namespace
}  // namespace femsph::compare
