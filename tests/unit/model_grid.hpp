#pragma once
// A discretization with points, masses and cells alone, for tests of what acts on boundaries.

#include <algorithm>

#include "model/numerics/vectors.hpp"
#include "model_results_fake.hpp"

namespace femsph::test {

/// n x m cells of `size` with unit thickness and lumped mass, from `origin`.
class Grid : public FakeBody {
 public:
  static constexpr double rho = 2.0, speed = 3.0;

  Grid(Point origin, double width, double height, int n, int m) {
    const std::size_t points = std::size_t(n + 1) * (m + 1);
    layout_ = {points, 2, 2, 1, 0, 2 * points};
    mass_.assign(points, 0.0);
    topology_.kind = Topology::Kind::quadrilaterals;
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) points_.push_back(origin + Point{width * i / n, height * j / m, 0});
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const std::size_t a = std::size_t(j * (n + 1) + i), b = a + std::size_t(n) + 1;
        topology_.cells.push_back({a, a + 1, b + 1, b});
        for (std::size_t p : {a, a + 1, b, b + 1}) mass_[p] += rho * width * height / (4 * n * m);
      }
    spacing_ = std::min(width / n, height / m);
  }
  std::span<const double> mass() const override { return mass_; }
  double spacing() const override { return spacing_; }
  double wave_speed() const override { return speed; }

 private:
  std::vector<double> mass_;
  double spacing_;
};

}  // namespace femsph::test
