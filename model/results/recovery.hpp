#pragma once
// How stress and strain are read at a point p, by the same rule for all methods: a weighted least-squares fit
// to the units (cells or particles) near p, after the idea of Zienkiewicz & Zhu, Int. J. Numer. Meth. Engng
// 33 (1992). The steps are explained, with measured orders, in model/results/README.md.
//
// 1. z = L^-1 (x - p) with L L^T = J J^T of the unit nearest to p: distances in cells, whatever their aspect
//    ratio.
// 2. The units with |z| < R are used. R = 2 is increased by factors of 1.25 until they are enough (there are
//    two units more than coefficients) and spread in every direction (smallest eigenvalue of the weighted
//    covariance of z/R above 0.02), or until a larger R adds no direction, because the body is one cell
//    thick.
// 3. w_c = q_c V_c (1 - |z_c|^2/R^2)^2, scaled to sum 1; q_c is the quality of the unit.
// 4. P of degree 2 in z/R minimises
//      sum_c w_c [ (mean s - mean P)^2 + 1e-3 sum_q (V_q/V_c) ((s_q - mean s) - (P_q - mean P))^2 ]
//        + 1e-4 |second degree of P|^2.
//    Means of units are what elements compute most accurately. The variation within a unit has a small
//    weight; it gives the slope in a body that is one cell thick.
// 5. The value is P(p): a sum of the values of points, with weights that do not depend on these values.
//    Linear fields are reproduced exactly.
// 6. Limits of the yield surface: flow_limit.hpp.

#include <array>
#include <vector>

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/point_grid.hpp"

namespace femsph {

class Recovery {
 public:
  /// For one body. Throws std::logic_error if it has no material_units().
  explicit Recovery(MaterialUnits units);

  /// Weights of material points for the value at p, in the order of the points; sum 1. Throws Refusal if no
  /// unit is near.
  std::vector<Weight> weights(const Point& p) const;
  /// Weights of units, if only the means of units are known: step 4 without the variation within a unit.
  std::vector<Weight> unit_weights(const Point& p) const;

 private:
  static constexpr int most = 10;        ///< coefficients of degree 2 in space
  using Factor = std::array<double, 6>;  ///< the lower triangle L, xx yx yy zx zy zz
  using Basis = std::array<double, most>;
  struct Patch;
  Point scaled(const Factor& L, const Point& x, const Point& p) const;
  Basis basis(const Point& z) const;
  const Factor& factor(std::size_t unit) const { return factor_[factor_.size() > 1 ? unit : 0]; }
  /// Of the volume of its unit.
  double share(std::size_t point) const {
    return units_.points_per_unit > 1 ? units_.volume[point] / volume_[point / units_.points_per_unit] : 1.0;
  }

  std::size_t nearest(const Point& p) const;
  Patch patch_of_nearest(const Point& p) const;
  Patch around(const Point& p, bool deviations) const;
  void collect(Patch& patch, const Point& p, double radius) const;
  void fill_matrix(Patch& patch, const Point& p, bool deviations) const;
  int spread_directions(const Patch& patch) const;
  Patch fit(const Point& p, bool deviations) const;
  double value(const Patch& patch, const Basis& q) const;

  MaterialUnits units_;
  std::size_t coefficients_;
  std::vector<Factor> factor_;  ///< L of each unit, or one for all
  std::vector<Point> centre_;   ///< of each unit: mean place of its points by volume
  std::vector<double> volume_;  ///< of each unit
  Point extent_{};              ///< half the box around the ellipsoid |z| < 1 of the widest unit
  PointGrid centres_;           ///< centre_, by bins
};

}  // namespace femsph
