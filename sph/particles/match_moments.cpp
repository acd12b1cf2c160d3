#include <algorithm>
#include <cmath>

#include "model/numerics/semidefinite.hpp"
#include "sph/particles/partial_volumes.hpp"

namespace femsph::sph {

void match_moments(const Shape& shape, const std::vector<MirrorPlane>& planes, const std::vector<Point>& at,
                   const std::vector<char>& which, std::vector<double>& volume) {
  const std::size_t n = std::size_t(shape.dim()) + 1;
  const Point centroid = shape.centroid(), lower = shape.lower(), upper = shape.upper();
  const double measure = shape.measure();
  /// Basis functions of the unknowns a and b: 1 and x - c, each component divided by the length of the
  /// bounding box along its axis.
  const auto basis = [&](const Point& x) {
    std::array<double, 4> q{1, 0, 0, 0};
    for (std::size_t a = 1; a < n; ++a) q[a] = (x[a - 1] - centroid[a - 1]) / (upper[a - 1] - lower[a - 1]);
    return q;
  };
  std::vector<double> matrix(n * n, 0.0), lacking(n, 0.0);
  lacking[0] = measure;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto q = basis(at[i]);
    for (std::size_t a = 0; a < n; ++a) {
      lacking[a] -= volume[i] * q[a];
      for (std::size_t b = 0; which[i] && b < n; ++b) matrix[a * n + b] += volume[i] * q[a] * q[b];
    }
  }
  for (const MirrorPlane& m : planes) {
    const std::size_t across = std::size_t(m.axis) + 1;
    for (std::size_t a = 0; a < n; ++a) matrix[across * n + a] = matrix[a * n + across] = 0;
    lacking[across] = 0;
  }
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  if (std::abs(*std::max_element(lacking.begin(), lacking.end(), larger)) <= 1e-13 * measure) return;
  const std::vector<double> x = solve_semidefinite(matrix, lacking, 1e-12 * matrix[0]).x;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!which[i]) continue;
    const auto q = basis(at[i]);
    double scale = 1;
    for (std::size_t a = 0; a < n; ++a) scale += x[a] * q[a];
    volume[i] *= scale;
  }
}

}  // namespace femsph::sph
