// The fast loop against slower ones: deal.II's FEValues (nothing shared but the mesh), the same kernel with
// one double, and the same loop on two threads (equal to the last bit, since borders and sums do not depend
// on the thread count).

#include <gtest/gtest.h>

#include "fem_scalar_loop.hpp"
#include "fem_support.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph::test {
namespace {

Scene block(int dim, bool large = false) {
  Scene s = box_scene(dim == 3 ? Plane::none : Plane::stress, {1.1, 0.9, dim == 3 ? 0.7 : 0.0}, 210e9, 0.3,
                      dim == 3 ? 1.0 : 0.2);
  s.large_motion = large;
  return s;
}

void expect_equal(const std::vector<double>& a, const std::vector<double>& b, double relative) {
  ASSERT_EQ(a.size(), b.size());
  const double scale = largest(b);
  ASSERT_GT(scale, 0);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], relative * scale);
}

class Dimension : public testing::TestWithParam<int> {};

TEST_P(Dimension, FullElementIsThatOfDealII) {
  fem::Options options;
  options.divisions = {9, 7, 5};
  options.distortion = 0.2;
  const Scene scene = block(GetParam());
  const auto fast = fem::discretize(scene, 0, options), oracle = fem::discretize_oracle(scene, 0, options);
  const auto u = random_field(*fast, 1e-3);
  expect_equal(force(*fast, u), force(*oracle, u), 1e-12);
  expect_equal(stiffness(*fast, u), stiffness(*oracle, u), 1e-12);
  EXPECT_NEAR(fast->energies(u.data()).strain / oracle->energies(u.data()).strain, 1, 1e-12);
}

TEST_P(Dimension, OneCellAtATimeEqualsEight) {
  for (const Element element : all_elements)
    for (const bool large : {false, true}) {
      fem::Options options;
      options.element = element;
      options.divisions = {5, 3, 3};  // 15 or 45 cells: the last batch is not full
      options.distortion = 0.2;
      const auto packed = fem::discretize(block(GetParam(), large), 0, options);
      options.loop = make_scalar_loop;
      const auto scalar = fem::discretize(block(GetParam(), large), 0, options);
      const auto u = random_field(*packed, 0.02);
      expect_equal(force(*packed, u), force(*scalar, u), 1e-12);
      expect_equal(stiffness(*packed, u), stiffness(*scalar, u), 1e-12);
    }
}

// Forth and back by a percent or two: some lanes yield, some do not.
TEST_P(Dimension, OneYieldingCellAtATimeEqualsEight) {
  for (const Element element : all_elements)
    for (const bool large : {false, true}) {
      Scene scene = block(GetParam(), large);
      scene.materials.at("m").parameters = Plasticity{300e6, 2.1e9};
      fem::Options options;
      options.element = element;
      options.divisions = {5, 3, 3};
      options.distortion = 0.2;
      const auto packed = fem::discretize(scene, 0, options);
      options.loop = make_scalar_loop;
      const auto scalar = fem::discretize(scene, 0, options);
      auto u = random_field(*packed, 3e-4);
      for (int turn = 0; turn < 6; ++turn) {
        expect_equal(force(*packed, u), force(*scalar, u), 1e-12);
        for (double& x : u) x *= -1.3;
      }
      const double taken = scalar->energies(u.data()).plastic;
      EXPECT_GT(taken, 0);
      EXPECT_NEAR(packed->energies(u.data()).plastic, taken, 1e-12 * taken);
    }
}

TEST_P(Dimension, ThreadsDoNotChangeABit) {
  fem::Options options;
  options.divisions = GetParam() == 2
                          ? std::array<int, 3>{200, 110, 0}
                          : std::array<int, 3>{30, 29, 25};  // more than 2048 batches, several domains
  options.distortion = 0.1;
  const auto d = fem::discretize(block(GetParam()), 0, options);
  const auto u = random_field(*d, 1e-3);
  set_threads(1);
  const auto one = force(*d, u);
  const double energy = d->energies(u.data()).strain;
  set_threads(2);
  EXPECT_EQ(force(*d, u), one);
  EXPECT_EQ(d->energies(u.data()).strain, energy);
  set_threads(1);
  for (std::size_t i = d->layout().points * static_cast<std::size_t>(d->layout().dim); i < one.size(); ++i)
    ASSERT_EQ(one[i], 0.0);  // padding
}

INSTANTIATE_TEST_SUITE_P(Fem, Dimension, testing::Values(2, 3));

TEST(FemOracle, RefusesWhatItDoesNotKnow) {
  fem::Options options;
  options.divisions = {2, 2, 2};
  EXPECT_THROW(fem::discretize_oracle(block(2, true), 0, options), std::runtime_error);
  options.element = Element::sri;
  EXPECT_THROW(fem::discretize_oracle(block(2), 0, options), std::runtime_error);
}

}  // namespace
}  // namespace femsph::test
