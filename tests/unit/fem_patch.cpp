// Patch test (Irons): under a linear displacement field the strain at every material point must be exactly
// its gradient, and with the constant stress that follows the forces on every inner node must cancel, on
// cells of any shape. Forces are measured against the largest nodal force, which sits on the boundary and
// balances the traction. Cells are distorted by up to 20 % of their edges.

#include <gtest/gtest.h>

#include "fem_support.hpp"

namespace femsph::test {
namespace {

struct Case {
  Element element;
  Plane plane;
  bool large;
};

class Patch : public testing::TestWithParam<Case> {
 protected:
  Patch() {
    const bool solid = GetParam().plane == Plane::none;
    scene_ = box_scene(GetParam().plane, {1.2, 0.8, solid ? 0.9 : 0.0});
    scene_.large_motion = GetParam().large;
    fem::Options options;
    options.element = GetParam().element;
    options.divisions = solid ? std::array<int, 3>{4, 3, 3} : std::array<int, 3>{7, 5, 0};
    options.distortion = 0.2;
    fem_ = fem::discretize(scene_, 0, options);
  }

  std::vector<double> linear(const std::array<Point, 3>& H) const {
    return field(*fem_, [&](const Point& x) {
      Point u{0.01, -0.02, 0.03};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) u[i] += H[i][j] * x[j];
      return u;
    });
  }

  /// Largest force on an inner node over the largest force on any.
  double unbalanced(const std::vector<double>& u) const {
    const std::vector<double> f = force(*fem_, u);
    std::vector<double> inner = f;
    for (const std::string side : {"x-", "x+", "y-", "y+", "z-", "z+"}) {
      if (fem_->layout().dim == 2 && side[0] == 'z') continue;
      for (const Weight& w : fem_->points_of({0, {side}, {}, {}}))
        for (int c = 0; c < fem_->layout().dim; ++c) inner[fem_->layout().at(w.point, c)] = 0;
    }
    return largest(inner) / largest(f);
  }

  Scene scene_;
  std::unique_ptr<Discretization> fem_;
};

class SmallPatch : public Patch {};
class LargePatch : public Patch {};

TEST_P(SmallPatch, GradientIsExact) {
  const std::array<Point, 3> H{Point{2e-3, 1e-3, -3e-3}, Point{-4e-3, 5e-3, 2e-3}, Point{1e-3, 6e-3, -2e-3}};
  const auto u = linear(H);
  const MaterialState state = state_of(*fem_, u);
  for (const auto& e : state.strain) {
    EXPECT_NEAR(e[0], H[0][0], 1e-15);
    EXPECT_NEAR(e[1], H[1][1], 1e-15);
    EXPECT_NEAR(e[3], 0.5 * (H[0][1] + H[1][0]), 1e-15);
    if (GetParam().plane != Plane::none) continue;
    EXPECT_NEAR(e[2], H[2][2], 1e-15);
    EXPECT_NEAR(e[4], 0.5 * (H[1][2] + H[2][1]), 1e-15);
    EXPECT_NEAR(e[5], 0.5 * (H[2][0] + H[0][2]), 1e-15);
  }
  EXPECT_LT(unbalanced(u), 1e-12);
  EXPECT_LT(fem_->energies(u.data()).hourglass, 1e-20 * fem_->energies(u.data()).strain);
}

TEST_P(LargePatch, ConstantStressIsBalanced) {
  // Rotation by about 50 degrees, stretches of 0.8 to 1.3: the same constant stress everywhere.
  const auto u = linear({Point{-0.3, -0.8, 0.1}, Point{0.9, -0.2, 0.05}, Point{-0.1, 0.1, 0.15}});
  const MaterialState state = state_of(*fem_, u);
  for (const auto& s : state.stress)
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(s[k], state.stress[0][k], 1e-11 * 210e9);
  EXPECT_LT(unbalanced(u), 1e-11);
}

std::vector<Case> cases(bool large) {
  std::vector<Case> r;
  for (const Element e : all_elements)
    for (const Plane p : {Plane::stress, Plane::strain, Plane::none}) r.push_back({e, p, large});
  return r;
}
INSTANTIATE_TEST_SUITE_P(Fem, SmallPatch, testing::ValuesIn(cases(false)));
INSTANTIATE_TEST_SUITE_P(Fem, LargePatch, testing::ValuesIn(cases(true)));

}  // namespace
}  // namespace femsph::test
