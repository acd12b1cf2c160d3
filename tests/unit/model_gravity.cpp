// Weight and its power in both layouts, against the sum written out; for a number of points that is not a
// multiple of eight.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/motion/effects/gravity.hpp"

namespace femsph {
namespace {

Layout side_by_side(std::size_t points, int dim) {
  return {points, dim, std::size_t(dim), 1, 0, points * std::size_t(dim) + 3};
}
Layout rows(std::size_t points, int dim) {
  return {points, dim, 1, points + 29, 16, (points + 29) * std::size_t(dim)};
}

void expect_weight(const Layout& at) {
  const Point g{0.3, -9.81, at.dim == 3 ? 2.5 : 0.0};
  std::vector<double> mass(at.points), v(at.size, 7.0),
      f(at.size, 5.0);  // padding must not count, nor change
  double power = 0, size = 0;
  for (std::size_t i = 0; i < at.points; ++i) {
    mass[i] = 1 + 0.5 * std::sin(double(i));
    for (int c = 0; c < at.dim; ++c) {
      v[at.at(i, c)] = std::cos(0.3 * double(i) + c);
      f[at.at(i, c)] = double(i) + c;
      const double part = mass[i] * g[std::size_t(c)] * v[at.at(i, c)];
      power += part;
      size += std::abs(part);
    }
  }
  std::vector<double> expected = f;
  for (std::size_t i = 0; i < at.points; ++i)
    for (int c = 0; c < at.dim; ++c)
      expected[at.at(i, c)] = std::fma(mass[i], g[std::size_t(c)], expected[at.at(i, c)]);
  add_weight(at, mass, g, f.data());
  for (std::size_t k = 0; k < f.size(); ++k)
    EXPECT_NEAR(f[k], expected[k], 1e-15 * (10 + std::abs(expected[k]))) << k;
  EXPECT_NEAR(power_of_weight(at, mass, g, v.data()), power, 1e-15 * size);
}

TEST(Gravity, WeightAndItsPower) {
  for (const int dim : {2, 3})
    for (const std::size_t points : {std::size_t{1}, std::size_t{8}, std::size_t{4099}}) {
      expect_weight(side_by_side(points, dim));
      expect_weight(rows(points, dim));
    }
}

}  // namespace
}  // namespace femsph
