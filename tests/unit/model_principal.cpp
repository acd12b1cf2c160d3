// Principal values: they have the invariants of the tensor, they are sorted, and equal ones are equal.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/principal.hpp"

namespace femsph {
namespace {

TEST(Principal, KnownStates) {
  const auto shear = principal_values({0, 0, 0, 5, 0, 0});
  EXPECT_EQ(shear, (std::array<double, 3>{5, 0, -5}));
  EXPECT_EQ(principal_values({-1, -2, 3, 0, 0, 0}),
            (std::array<double, 3>{3, -1, -2}));            // the one across a plane may be the largest
  const auto other = principal_values({0, 0, 0, 0, 3, 4});  // shear over z, along (4, 3)/5
  EXPECT_NEAR(other[0], 5, 1e-15 * 5);
  EXPECT_NEAR(other[1], 0, 1e-15 * 5);
  EXPECT_NEAR(other[2], -5, 1e-15 * 5);
}

TEST(Principal, InvariantsOfRandomTensors) {
  std::mt19937 any(7);
  std::uniform_real_distribution<double> pick(-1, 1);
  for (int k = 0; k < 1000; ++k) {
    std::array<double, 6> t;
    for (double& x : t) x = pick(any);
    if (k % 3 == 0) t[1] = t[0], t[3] *= 1e-9, t[5] *= 1e-9;  // nearly equal ones
    const auto p = principal_values(t);
    EXPECT_GE(p[0], p[1]);
    EXPECT_GE(p[1], p[2]);
    const double second = t[0] * t[1] + t[1] * t[2] + t[2] * t[0] - t[3] * t[3] - t[4] * t[4] - t[5] * t[5];
    const double det = t[0] * (t[1] * t[2] - t[4] * t[4]) - t[3] * (t[3] * t[2] - t[4] * t[5]) +
                       t[5] * (t[3] * t[4] - t[1] * t[5]);
    EXPECT_NEAR(p[0] + p[1] + p[2], t[0] + t[1] + t[2], 1e-14);
    EXPECT_NEAR(p[0] * p[1] + p[1] * p[2] + p[2] * p[0], second, 1e-14);
    EXPECT_NEAR(p[0] * p[1] * p[2], det, 1e-14);
    EXPECT_NEAR(von_mises({p[0], p[1], p[2], 0, 0, 0}), von_mises(t), 1e-14);
  }
}

}  // namespace
}  // namespace femsph
