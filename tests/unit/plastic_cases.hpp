#pragma once
// Uniform stretch of a plastic body, by either method: what its material points must show.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/material/point.hpp"
#include "model/numerics/array.hpp"
#include "state_of.hpp"

namespace femsph::test {

/// Displacement of the stretch diag(1 + a, 1 + b, 1 + c) and then a turn by `angle` about z.
inline AlignedVector<double> stretched(const Discretization& d, double a, double b, double c, double angle) {
  const double k = std::cos(angle), s = std::sin(angle);
  const double A[3][3] = {{k * (1 + a) - 1, -s * (1 + b), 0}, {s * (1 + a), k * (1 + b) - 1, 0}, {0, 0, c}};
  AlignedVector<double> u(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (int row = 0; row < d.layout().dim; ++row)
      for (int col = 0; col < d.layout().dim; ++col)
        u[d.layout().at(i, row)] += A[row][col] * d.position(i)[std::size_t(col)];
  return u;
}

/// The body goes to the displacement u, at rest: its laws see the step from where it was.
inline void move_to(Discretization& d, const AlignedVector<double>& u) {
  AlignedVector<double> f(d.layout().size, 0.0), v(d.layout().size, 0.0);
  d.internal_force(u.data(), v.data(), 0, f.data(), nullptr);
}

/// In ten steps to a strain well beyond yield. Small strain: Cauchy stress is the law's. In large motion the
/// law sees the steps dU / Umid, which add up to ln U, and gives the Kirchhoff stress tau = J sigma.
inline void expect_stress_of_law(Discretization& d, const Law& given, Plane plane, bool large,
                                 double volume) {
  const double a = 0.008, b = -0.002, c = -0.001;
  MaterialPoint point(given);
  PointState law;
  std::array<double, 6> seen{};
  for (int k = 1; k <= 10; ++k) {
    move_to(d, stretched(d, a * k / 10, b * k / 10, c * k / 10, 0));
    const std::array<double, 3> full{a, b, plane == Plane::none ? c : 0};
    for (std::size_t i = 0; i < 3; ++i) seen[i] += full[i] / 10 / (large ? 1 + full[i] * (k - 0.5) / 10 : 1);
    law = point.advance(seen);
  }
  const double across = plane == Plane::none ? c : large ? std::expm1(law.strain_across) : law.strain_across;
  const std::array<double, 3> U{1 + a, 1 + b, 1 + across};
  const auto u = stretched(d, a, b, c, 0);
  const MaterialState state = state_of(d, u);
  ASSERT_GT(law.plastic_strain, 0.004);
  for (std::size_t i = 0; i < state.stress.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(
          state.stress[i][k], law.stress[k] / (large ? U[0] * U[1] * U[2] : 1), 1e-10 * law.equivalent);
      ASSERT_NEAR(state.strain[i][k], U[k] - 1, 1e-12);
    }
    ASSERT_NEAR(state.plastic[i], law.plastic_strain, 1e-12);
  }
  const Energies e = d.energies(u.data());
  EXPECT_NEAR(e.strain, law.stored_energy * volume, 1e-9 * law.stored_energy * volume);
  EXPECT_NEAR(e.plastic, law.plastic_work * volume, 1e-9 * law.plastic_work * volume);
}

/// A body in large motion, beyond yield, turns ten times: its stress turns with it and nothing flows.
inline void expect_turning_changes_nothing(Discretization& d) {
  const double a = 0.008, b = -0.002, c = -0.001, turn = 2 * std::numbers::pi;
  const auto turned = [&](double angle) {
    const auto u = stretched(d, a, b, c, angle);
    move_to(d, u);
    return u;
  };
  const MaterialState start = state_of(d, turned(0)), quarter = state_of(d, turned(0.25 * turn));
  for (int k = 1; k < 73; ++k) turned(10 * turn * k / 73);
  const MaterialState end = state_of(d, turned(10 * turn));
  const double scale = start.stress[0][0];
  for (std::size_t i = 0; i < start.stress.size(); ++i) {
    ASSERT_NEAR(quarter.stress[i][0], start.stress[i][1], 1e-10 * scale);
    ASSERT_NEAR(quarter.stress[i][1], start.stress[i][0], 1e-10 * scale);
    for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(end.stress[i][k], start.stress[i][k], 1e-10 * scale);
    ASSERT_NEAR(end.plastic[i], start.plastic[i], 1e-12);
  }
}

}  // namespace femsph::test
