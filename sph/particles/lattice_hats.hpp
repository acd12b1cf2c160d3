#pragma once

#include <cmath>

#include "sph/particles/particles.hpp"

namespace femsph::sph {

/// Calls take(place, phi) for the corners of the lattice's cell around x: phi is the multilinear hat function
/// of that place at x. Those below 1e-12 are left out.
template <class Take>
void each_hat(const Lattice& lattice, int dim, const Point& x, Take&& take) {
  std::array<int, 3> cell{};
  Point part{};
  for (int a = 0; a < dim; ++a) {
    const double t = (x[a] - lattice.origin[a]) / lattice.spacing[a];
    cell[a] = int(std::floor(t));
    part[a] = t - cell[a];
  }
  for (int v = 0; v < 1 << dim; ++v) {
    double phi = 1;
    std::array<int, 3> at = cell;
    for (int a = 0; a < dim; ++a) phi *= v >> a & 1 ? part[a] : 1 - part[a], at[a] += v >> a & 1;
    if (phi > 1e-12) take(at, phi);
  }
}

}  // namespace femsph::sph
