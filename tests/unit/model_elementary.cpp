// The lane-wise logarithm and exponential against the library's, an ulp or two apart.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/numerics/elementary.hpp"

namespace femsph {
namespace {

template <class Of, class Library>
void expect_like_the_library(Of&& of, Library&& library, const std::vector<double>& samples) {
  for (std::size_t k = 0; k + lanes <= samples.size(); k += lanes) {
    const Pack y = of(load_unaligned<Pack>(&samples[k]));
    for (std::size_t l = 0; l < lanes; ++l) {
      const double want = library(samples[k + l]);
      ASSERT_NEAR(y[l], want, 4e-16 * std::abs(want)) << samples[k + l];
    }
  }
}

std::vector<double> spread(double from, double to, bool logarithmic) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<double> all;
  for (int k = 0; k < 80000; ++k) {
    const double t = share(engine);
    all.push_back(logarithmic ? from * std::pow(to / from, t) : from + t * (to - from));
  }
  return all;
}

TEST(Elementary, LikeTheLibrary) {
  const auto log1p_pack = [](Pack x) { return log_of_1_plus(x); };
  const auto log1p_one = [](double x) { return std::log1p(x); };
  expect_like_the_library(log1p_pack, log1p_one, spread(-0.999, 3, false));
  expect_like_the_library(log1p_pack, log1p_one, spread(1e-18, 1e12, true));
  std::vector<double> negative = spread(1e-18, 0.9999, true);
  for (double& x : negative) x = -x;
  expect_like_the_library(log1p_pack, log1p_one, negative);
  expect_like_the_library([](Pack x) { return natural_log(x); }, [](double x) { return std::log(x); },
                          spread(1e-300, 1e300, true));
  expect_like_the_library(
      [](Pack x) { return natural_log(x); }, [](double x) { return std::log(x); }, spread(0.5, 2, false));
  expect_like_the_library(
      [](Pack x) { return exponential(x); }, [](double x) { return std::exp(x); }, spread(-650, 650, false));
  expect_like_the_library(
      [](Pack x) { return exponential(x); }, [](double x) { return std::exp(x); }, spread(1e-18, 2, true));
}

TEST(Elementary, AtTheEnds) {
  const Pack x{0.0, -1.0, -1.5, 1e-320, std::nan(""), -0.0, 5.0, -1e300};
  const Pack y = log_of_1_plus(x), z = natural_log(x), w = exponential(x);
  EXPECT_EQ(y[0], 0.0);
  EXPECT_EQ(y[5], 0.0);
  for (int l : {1, 2, 4, 7}) EXPECT_TRUE(std::isnan(y[l])) << l;
  EXPECT_LT(z[0], -700);
  for (int l : {1, 2, 4, 7}) EXPECT_TRUE(std::isnan(z[l])) << l;
  EXPECT_EQ(w[0], 1.0);
  EXPECT_TRUE(std::isnan(w[4]));
  EXPECT_LT(w[7], 1e-300);
  for (int l = 0; l < lanes; ++l) {  // the scalar forms have the same ends
    EXPECT_EQ(std::isnan(log_of_1_plus(double(x[l]))), std::isnan(y[l])) << l;
    EXPECT_EQ(std::isnan(natural_log(double(x[l]))), std::isnan(z[l])) << l;
    EXPECT_EQ(std::isnan(exponential(double(x[l]))), std::isnan(w[l])) << l;
  }
}

}  // namespace
}  // namespace femsph
