// Recovery of stress and strain on units made here, and its limit to the yield surface.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "model/input/faults.hpp"
#include "model/numerics/principal.hpp"
#include "model/numerics/vectors.hpp"
#include "model/results/flow_limit.hpp"
#include "model/results/recovery.hpp"

namespace femsph::test {
namespace {

/// n0 x n1 (x n2) unit cells with two Gauss points along each axis, or one, turned about z.
MaterialUnits cells(int dim, std::array<int, 3> n, bool one_point, double angle = 0) {
  MaterialUnits units;
  units.dim = dim;
  units.points_per_unit = one_point ? 1 : dim == 2 ? 4 : 8;
  const double c = std::cos(angle), s = std::sin(angle);
  for (int k = 0; k < (dim == 3 ? n[2] : 1); ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        for (std::size_t q = 0; q < units.points_per_unit; ++q) {
          const auto at = [&](int cell, std::size_t bit) {
            return cell + 0.5 + (one_point ? 0.0 : (q >> bit & 1 ? 0.5 : -0.5) / std::sqrt(3.0));
          };
          const double x = at(i, 0), y = at(j, 1), z = dim == 3 ? at(k, 2) : 0.0;
          units.place.push_back({c * x - s * y, s * x + c * y, z});
          units.volume.push_back(1.0 / double(units.points_per_unit));
        }
  units.shape = {{1, 1, dim == 3 ? 1.0 : 0.0, 0, 0, 0}};
  return units;
}

std::map<std::size_t, double> by_point(const std::vector<Weight>& weights) {
  std::map<std::size_t, double> out;
  for (const Weight& w : weights) out[w.point] = w.weight;
  return out;
}

/// A body that is turned as a whole has the same recovered values: the rule has no preferred axes.
TEST(Recovery, TurnsWithTheBody) {
  for (const int dim : {2, 3})
    for (const Point& p : {Point{0, 0, 0}, Point{2.3, 0, 1}, Point{2.6, 2.1, 1.3}}) {
      const double c = std::cos(0.7), s = std::sin(0.7);
      const auto straight = by_point(Recovery(cells(dim, {5, 4, 3}, false)).weights(p));
      const auto turned = by_point(Recovery(cells(dim, {5, 4, 3}, false, 0.7))
                                       .weights({c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]}));
      ASSERT_EQ(straight.size(), turned.size());
      for (const auto& [point, weight] : straight) EXPECT_NEAR(weight, turned.at(point), 1e-11);
    }
}

/// A beam of one cell over its height, or a bar of one by one: there is no second layer at any distance, and
/// the reading stays where it is read. Across it the Gauss points tell the slope; one point a cell cannot,
/// and is constant.
TEST(Recovery, OfABodyOneCellThickIsLocal) {
  for (const int dim : {2, 3})
    for (const bool one_point : {false, true}) {
      const MaterialUnits units = cells(dim, {200, 1, 1}, one_point);
      const Recovery rule(units);
      for (const Point& p : {Point{0, 0, 0}, Point{100.3, 1, 0.2}}) {
        double along = 0, across = 0, sum = 0;
        for (const Weight& w : rule.weights(p)) {
          EXPECT_LT(std::abs(units.place[w.point][0] - p[0]), 6);
          sum += w.weight, along += w.weight * units.place[w.point][0],
              across += w.weight * units.place[w.point][1];
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        EXPECT_NEAR(along, p[0], 1e-10);
        EXPECT_NEAR(across, one_point ? 0.5 : p[1], 1e-9);
      }
    }
}

/// A curved field: inside nearly exact. On a surface R = 2 sees two layers, which determine no curvature
/// across it: x^2 continued by the line through its values at 1/2 and 3/2 cells is off by 3/4, and no more
/// than that.
TEST(Recovery, QuadraticFields) {
  for (const int dim : {2, 3}) {
    const MaterialUnits units = cells(dim, {8, 7, 6}, false);
    const auto field = [](const Point& x) { return x[0] * x[0] - 2 * x[1] * x[0] + 3; };
    const Recovery rule(units);
    const auto error = [&](const Point& p) {
      double value = 0;
      for (const Weight& w : rule.weights(p)) value += w.weight * field(units.place[w.point]);
      return std::abs(value - field(p));
    };
    const double z = dim == 3 ? 2.9 : 0;
    EXPECT_LT(error({4.2, 3.3, z}), 0.03);
    EXPECT_LT(error({4.2, 0, z}), 0.03);  // no curvature across
    EXPECT_LT(error({8, 3.1, z}), 0.75);
    EXPECT_GT(error({8, 3.1, z}), 0.4);
  }
}

/// On a graded mesh distances are measured in the cells at p: points of small cells do not reach across
/// larger ones.
TEST(Recovery, FindsTheNearestUnitByItsOwnMeasure) {
  MaterialUnits units;
  units.dim = 2;
  double left = 0;
  for (int i = 0; i < 12; ++i) {  // columns of widths 1, 1.5, 2.25, ..
    const double width = std::pow(1.5, i);
    for (int j = 0; j < 6; ++j) {
      units.place.push_back({left + 0.5 * width, j + 0.5, 0});
      units.volume.push_back(width);
      units.shape.push_back({width * width, 1, 0, 0, 0, 0});
    }
    left += width;
  }
  const Recovery rule(units);
  for (const double x : {0.0, 3.0, 20.0, 90.0, left}) {
    double value = 0, furthest = 0;
    for (const Weight& w : rule.weights({x, 3, 0}))
      value += w.weight * units.place[w.point][0],
          furthest = std::max(furthest, std::abs(units.place[w.point][0] - x));
    EXPECT_NEAR(value, x, 1e-12 * left);
    EXPECT_LT(furthest, 2 + 1.3 * x);
  }
}

TEST(Recovery, RefusesWhatIsFarFromTheBody) {
  const Recovery rule(cells(2, {4, 4, 1}, true));
  EXPECT_NO_THROW(rule.weights({4.5, 2, 0}));
  try {
    rule.weights({6, 2, 0});
    ADD_FAILURE();
  } catch (const Refusal& e) {
    EXPECT_STREQ(e.what(),
                 "stress is read at (6, 2, 0) m, where the body has no cell or particle within two spacings; "
                 "take a finer spacing");
  }
}

const double none = std::numeric_limits<double>::infinity();

TEST(Recovery, LimitKeepsTheMeanAndTheYieldStress) {
  const std::array<double, 6> s{5, -2, 1, 3, -1, 2};
  const auto out = limited(s, {2, 2, none}, Plane::none);
  EXPECT_NEAR(von_mises(out), 2, 1e-14);
  EXPECT_NEAR(out[0] + out[1] + out[2], 4, 1e-14);
  EXPECT_NEAR(out[3] / s[3], 2 / von_mises(s), 1e-14);
  EXPECT_EQ(limited(s, {20, 20, none}, Plane::none), s);
}

TEST(Recovery, LimitInPlaneStressLeavesNothingAcross) {
  const auto out = limited({5, -2, 0, 3, 0, 0}, {2, 2, none}, Plane::stress);
  EXPECT_NEAR(von_mises(out), 2, 1e-14);
  EXPECT_EQ(out[2], 0);
}

/// By the sign rule the surface is that of the place's own mean stress; by Rankine's no principal stress
/// passes, and von Mises' stays.
TEST(Recovery, LimitOfConcrete) {
  EXPECT_NEAR(von_mises(limited({5, 1, 0, 0, 0, 0}, {30, 3, none}, Plane::stress)), 3, 1e-14);
  EXPECT_NEAR(von_mises(limited({-5, -1, 0, 0, 0, 0}, {30, 3, none}, Plane::stress)), std::sqrt(21.0), 1e-14);
  const auto cut = limited({5, -40, 0, 9, 0, 0}, {30, 30, 3}, Plane::stress);
  EXPECT_NEAR(principal_values(cut)[0], 3, 1e-12);
  EXPECT_LE(von_mises(cut), 30 + 1e-12);
  EXPECT_NEAR(cut[2], 0, 1e-12);
}

/// Weights that extrapolate do not carry what belongs to the material beyond the range of its points, and
/// laws without return mapping know no bound.
TEST(Recovery, HistoryStaysWithinItsPoints) {
  const std::vector<Weight> weights{{0, 1.5}, {1, -0.5}};
  MaterialState state;
  state.stress = {{3, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0}};
  state.strain = {{3, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0}};
  state.plastic = {0.2, 0.1};
  state.flow_stress = {2.4, 2.2};
  const Recovered held = recovered(weights, state, Plane::stress);
  EXPECT_EQ(held.plastic, 0.2);
  EXPECT_NEAR(held.stress[0], 2.4, 1e-14);
  EXPECT_NEAR(held.strain[0], 4, 1e-14);
  state.flow_stress = {none, none};
  EXPECT_NEAR(recovered(weights, state, Plane::stress).stress[0], 4, 1e-14);
}

}  // namespace
}  // namespace femsph::test
