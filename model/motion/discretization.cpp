#include "model/motion/discretization.hpp"

#include <algorithm>
#include <cmath>

namespace femsph {

double von_mises(const std::array<double, 6>& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

void Discretization::damping_matrix(const double*, double* y) const { std::fill_n(y, layout().size, 0.0); }

}  // namespace femsph
