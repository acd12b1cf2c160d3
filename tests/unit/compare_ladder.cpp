// Orders, limits and spacings from ladders of a known law: e = C d^p, v = limit + C d^p.

#include <gtest/gtest.h>

#include <cmath>

#include "compare/measure/ladder.hpp"

namespace femsph::compare {
namespace {

Ladder power(double limit, double c, double p, std::vector<double> spacings) {
  Ladder ladder;
  for (const double d : spacings) ladder.push_back({d, limit + c * std::pow(d, p)});
  return ladder;
}

TEST(LadderOrders, RecoverThePower) {
  for (const double p : {0.5, 1.0, 1.8, 2.0}) {
    const Ladder errors = power(0, -3, p, {2.5, 20, 10, 5});  // in any order, of either sign
    EXPECT_NEAR(*fitted_order(errors), p, 1e-12);
    for (const double q : pairwise_orders(errors)) EXPECT_NEAR(q, p, 1e-12);
  }
}

TEST(LadderOrders, NoneFromTooLittle) {
  EXPECT_FALSE(fitted_order({{10, 1}}));
  EXPECT_FALSE(fitted_order({{10, 1}, {10, 2}}));
  EXPECT_FALSE(fitted_order({{10, 1}, {5, 0}}));
  EXPECT_TRUE(std::isnan(pairwise_orders({{10, 1}, {5, 0}})[0]));
}

// Equal and unequal ratios of spacings alike.
TEST(LadderExtrapolation, FindsLimitAndOrder) {
  for (const auto& spacings : {std::vector<double>{20, 10, 5}, {50, 20, 10}, {40, 20, 10, 5, 2.5}}) {
    const auto found = richardson(power(4.7906, -2e-3, 1.7, spacings));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->limit, 4.7906, 1e-9);
    EXPECT_NEAR(found->order, 1.7, 1e-8);
  }
}

TEST(LadderExtrapolation, NoneWithoutConvergence) {
  EXPECT_FALSE(richardson({{20, 1}, {10, 2}}));
  EXPECT_FALSE(richardson({{20, 1}, {10, 3}, {5, 2}}));  // turns back
  EXPECT_FALSE(richardson({{20, 1}, {10, 2}, {5, 4}}));  // runs away
  EXPECT_FALSE(richardson({{20, 1}, {10, 1}, {5, 1}}));
}

TEST(LadderSpacing, InterpolatesInLogLog) {
  const auto found = spacing_at_error(power(0, 0.04, 2, {20, 10, 5, 2.5}), 2.0);  // 0.04 d^2 = 2
  EXPECT_NEAR(found->spacing, std::sqrt(50.0), 1e-9);
  EXPECT_FALSE(found->extrapolated);
  EXPECT_TRUE(found->monotone);
}

TEST(LadderSpacing, SaysWhenItExtrapolates) {
  const Ladder errors = power(0, 1, 1, {20, 10, 5});
  EXPECT_NEAR(spacing_at_error(errors, 1)->spacing, 1, 1e-9);
  EXPECT_TRUE(spacing_at_error(errors, 1)->extrapolated);
  EXPECT_NEAR(spacing_at_error(errors, 40)->spacing, 40, 1e-9);
  EXPECT_TRUE(spacing_at_error(errors, 40)->extrapolated);
}

// The error passes through zero between 20 and 10 mm, as the tip of uncorrected SPH does: the answer is the
// spacing below which every error is small enough, and not where the error happens to vanish.
TEST(LadderSpacing, SaysWhenTheErrorIsNotMonotone) {
  const Ladder errors = {{20, 1}, {10, -27}, {5, -8}, {2.5, -1.3}};
  const auto found = spacing_at_error(errors, 8);
  EXPECT_NEAR(found->spacing, 5, 1e-9);
  EXPECT_FALSE(found->monotone);
  EXPECT_FALSE(found->extrapolated);
}

TEST(LadderSpacing, NoneWhenTheFineEndGrows) { EXPECT_FALSE(spacing_at_error({{10, 2}, {5, 3}}, 1)); }

}  // namespace
}  // namespace femsph::compare
