// What holds for every rule of tension and every integration: lanes are independent, the axes do not matter,
// energy is accounted for.

#include "model/material/kinematics.hpp"
#include "model_law_support.hpp"

namespace femsph::test {
namespace {

template <int dim>
Symmetric<double, dim> tensor(const Strain& e) {
  if constexpr (dim == 2)
    return {e[0], e[1], 0.5 * e[3]};
  else
    return {e[0], e[1], e[2], 0.5 * e[3], 0.5 * e[4], 0.5 * e[5]};
}

// Eight points on the path at eight sizes, some of which never yield: each lane is the scalar law.
template <int dim>
void lanes_are_scalars(const Plastic& law) {
  constexpr int n = point_state_size<Plastic, dim>;
  double scalar[lanes][n] = {};
  Pack pack[n] = {};
  double worst = 0;
  for (const Strain& e : crooked_path(law.base.plane)) {
    const Symmetric<double, dim> strain = tensor<dim>(e);
    Symmetric<Pack, dim> strains;
    for (int k = 0; k < symmetric_size<dim>; ++k)
      for (int l = 0; l < lanes; ++l) strains[k][l] = strain[k] * 0.16 * (l + 0.5);
    const auto stresses = advance_law<Plastic, Pack, dim>(law, strains, pack);
    for (int l = 0; l < lanes; ++l) {
      Symmetric<double, dim> one;
      for (int k = 0; k < symmetric_size<dim>; ++k) one[k] = strains[k][l];
      const auto stress = advance_law<Plastic, double, dim>(law, one, scalar[l]);
      for (int k = 0; k < symmetric_size<dim>; ++k)
        worst = std::max(worst, std::abs(stress[k] - stresses[k][l]) / yield_stress);
      for (int k = 2 * symmetric_size<dim>; k < n; ++k)
        worst = std::max(
            worst, std::abs(scalar[l][k] - pack[k][l]) / (1e-6 * yield_stress + std::abs(scalar[l][k])));
    }
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(Plastic, EachLaneIsTheScalarLaw) {
  for (const Plasticity& p : all_parameters())
    for (Plane plane : planes) {
      SCOPED_TRACE(testing::Message() << "plane " << int(plane) << " tension " << int(p.tension)
                                      << " integration " << int(p.integration));
      if (plane == Plane::none)
        lanes_are_scalars<3>(plastic_law(plane, p));
      else
        lanes_are_scalars<2>(plastic_law(plane, p));
    }
}

// A step in which no lane yields takes a shorter branch, with the same result to round-off.
template <int dim>
void short_way_is_the_long_one(const Plastic& law) {
  constexpr int n = symmetric_size<dim>, history = Plastic::history_size<dim>;
  Symmetric<Pack, dim> a{}, b{}, increment;
  Pack of_a[history]{}, of_b[history]{};
  Strain before{};
  int elastic = 0, yielding = 0;
  for (const Strain& e : crooked_path(law.base.plane, 4000)) {
    Strain change;
    for (std::size_t k = 0; k < 6; ++k) change[k] = e[k] - before[k];
    before = e;
    const Symmetric<double, dim> one = tensor<dim>(change);
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < lanes; ++l) increment[k][l] = one[k] * (1 + 0.03 * l);
    const double p = horizontal_sum(of_a[Plastic::equivalent_strain]);
    law.update(increment, a, of_a);
    law.flow(increment, b, of_b);
    ++(horizontal_sum(of_a[Plastic::equivalent_strain]) > p ? yielding : elastic);
    for (int l = 0; l < lanes; ++l) {
      for (int k = 0; k < n; ++k) ASSERT_NEAR(a[k][l], b[k][l], 1e-12 * yield_stress);
      for (int k = 0; k < history; ++k) {
        const bool stress = k == Plastic::excess ||  // which agrees as `a` and `b` do
                            (law.base.plane == Plane::strain && k == Plastic::across);
        const double one = stress ? yield_stress : k == Plastic::work ? 1e-3 * yield_stress : 1e-3;
        ASSERT_NEAR(of_a[k][l], of_b[k][l], 1e-12 * (one + std::abs(of_b[k][l])));
      }
    }
  }
  EXPECT_GT(elastic, 20);
  EXPECT_GT(yielding, 20);
}

TEST(Plastic, TheElasticBranchEqualsTheFullUpdate) {
  for (const Plane plane : planes) {
    if (plane == Plane::none)
      short_way_is_the_long_one<3>(plastic_law(plane));
    else
      short_way_is_the_long_one<2>(plastic_law(plane));
  }
}

using Matrix = std::array<std::array<double, 3>, 3>;
Matrix full(const std::array<double, 6>& s, double share) {
  return {{{s[0], share * s[3], share * s[5]},
           {share * s[3], s[1], share * s[4]},
           {share * s[5], share * s[4], s[2]}}};
}
std::array<double, 6> turned(const std::array<double, 6>& s, double share, double angle) {
  const double c = std::cos(angle), d = std::sin(angle);
  const Matrix R{{{c, -d, 0}, {d, c, 0}, {0, 0, 1}}}, A = full(s, share);
  Matrix B{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) B[i][j] += R[i][k] * A[k][l] * R[j][l];
  return {B[0][0], B[1][1], B[2][2], B[0][1] / share, B[1][2] / share, B[2][0] / share};
}

// The path turned by 30 degrees about z gives the stress turned by 30 degrees.
TEST(Plastic, AxesDoNotMatter) {
  const double angle = std::acos(-1.0) / 6;
  for (const Plasticity& p : all_parameters())
    for (Plane plane : planes) {
      SCOPED_TRACE(testing::Message() << "plane " << int(plane) << " tension " << int(p.tension)
                                      << " integration " << int(p.integration));
      MaterialPoint one(plastic_law(plane, p)), other(plastic_law(plane, p));
      double worst = 0;
      for (const Strain& e : crooked_path(plane)) {
        const PointState a = one.advance(e), b = other.advance(turned(e, 0.5, angle));
        const auto expected = turned(a.stress, 1, angle);
        for (int c = 0; c < 6; ++c)
          worst = std::max(worst, std::abs(b.stress[c] - expected[c]) / yield_stress);
        worst = std::max(worst, std::abs(a.plastic_strain - b.plastic_strain));
        worst = std::max(worst, std::abs(a.strain_across - b.strain_across));
      }
      EXPECT_LT(worst, 1e-9);
    }
}

// The work of the stress over a step, by the trapezoidal rule as in the energy balance of the march, is
// stored energy and plastic work, to round-off. With return mapping plastic work is positive under every rule
// of tension.
TEST(Plastic, WorkIsStoredOrPlastic) {
  for (const Plasticity& p : all_parameters())
    for (Plane plane : planes) {
      SCOPED_TRACE(testing::Message() << "plane " << int(plane) << " tension " << int(p.tension)
                                      << " integration " << int(p.integration));
      MaterialPoint point(plastic_law(plane, p));
      Strain before{};
      PointState last;
      double work = 0, size = 0, worst = 0;
      for (const Strain& e : crooked_path(plane)) {
        const PointState now = point.advance(e);
        for (int c = 0; c < 6; ++c) work += 0.5 * (now.stress[c] + last.stress[c]) * (e[c] - before[c]);
        size = std::max(size, std::abs(work));
        worst = std::max(worst, std::abs(work - now.stored_energy - now.plastic_work));
        before = e, last = now;
      }
      EXPECT_LT(worst, 1e-12 * size);
      if (p.integration == Integration::return_mapping) {
        EXPECT_GT(last.plastic_work, 0);
      }
    }
}

// Proportional loading: the plastic work is the integral of Y dp = sigma_y p + H p^2/2, to the order of the
// step.
TEST(Plastic, PlasticWorkIsYieldTimesPlasticStrain) {
  const auto error = [](int steps) {
    MaterialPoint point(plastic_law(Plane::none));
    PointState s;
    for (int k = 1; k <= steps; ++k)
      s = point.advance({0.02 * k / steps, -0.01 * k / steps, -0.01 * k / steps, 0, 0, 0});
    const double p = s.plastic_strain;
    return std::abs(s.plastic_work / (yield_stress * p + 0.5 * hardening * p * p) - 1);
  };
  EXPECT_LT(error(1000), 1e-5);
}

}  // namespace
}  // namespace femsph::test
