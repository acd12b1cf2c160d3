#include "model/numerics/principal.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>

namespace femsph {

std::array<double, 3> principal_values(const std::array<double, 6>& t) {
  const auto [xx, yy, zz, xy, yz, zx] = t;
  std::array<double, 3> values{};
  if (yz == 0 && zx == 0) {
    const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);  // Mohr's circle
    values = {mean + radius, mean - radius, zz};
  } else {
    // By iteration, which is accurate to round-off of the largest value even for equal values. Eigen's
    // computeDirect (the closed solution of the cubic) loses half of the digits for nearly equal values.
    Eigen::Matrix3d a;
    a << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a, Eigen::EigenvaluesOnly);
    std::copy_n(solver.eigenvalues().data(), 3, values.begin());
  }
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

double von_mises(const std::array<double, 6>& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace femsph
