#include "model/numerics/principal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace femsph {

namespace {

/// Of the two in the plane xy: (xx + yy)/2 +- sqrt((xx - yy)^2/4 + xy^2).
std::array<double, 2> in_plane(double xx, double yy, double xy) {
  const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
  return {mean + radius, mean - radius};
}

/// Jacobi's rotations: to round-off of the largest, equal values included, where the cubic's closed solution
/// loses half the digits.
std::array<double, 3> by_rotations(double a[3][3]) {
  for (int sweep = 0; sweep < 20; ++sweep) {
    const double off = a[0][1] * a[0][1] + a[1][2] * a[1][2] + a[2][0] * a[2][0];
    const double all = off + a[0][0] * a[0][0] + a[1][1] * a[1][1] + a[2][2] * a[2][2];
    if (!(off > 1e-34 * all)) break;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0)),
                     c = 1 / std::hypot(t, 1.0), s = t * c;
        const int r = 3 - p - q;
        const double rp = a[r][p], rq = a[r][q], pq = a[p][q];
        a[p][p] -= t * pq;
        a[q][q] += t * pq;
        a[p][q] = a[q][p] = 0;
        a[r][p] = a[p][r] = c * rp - s * rq;
        a[r][q] = a[q][r] = s * rp + c * rq;
      }
  }
  return {a[0][0], a[1][1], a[2][2]};
}

}  // namespace

std::array<double, 3> principal_values(const std::array<double, 6>& t) {
  const auto [xx, yy, zz, xy, yz, zx] = t;
  std::array<double, 3> values{};
  if (yz == 0 && zx == 0) {
    const auto [more, less] = in_plane(xx, yy, xy);
    values = {more, less, zz};
  } else {
    double a[3][3] = {{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}};
    values = by_rotations(a);
  }
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

double von_mises(const std::array<double, 6>& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace femsph
