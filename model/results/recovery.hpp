#pragma once
// One rule for reading stress and strain at a point p, whatever the method: a weighted least-squares patch
// around p (Zienkiewicz & Zhu, Int. J. Numer. Meth. Engng 33, 1992, for the idea). Equations and measured
// orders: README.md.
//   1  z = L^-1 (x - p), with L L^T = J J^T of the unit (cell, particle) nearest to p: distances in cells of
//   that place, whatever their aspect. 2  The units within |z| < R = 2; R grows by 1.25 until they are enough
//   (coefficients + 2) and spread in every direction (smallest
//      eigenvalue of the weighted covariance of z/R above 0.02), or until growing no longer helps: the body
//      is one cell across.
//   3  w_c = q_c V_c (1 - |z_c|^2/R^2)^2, sum 1; q_c the quality of the unit.
//   4  P of degree 2 in z/R minimises
//        sum_c w_c [ (mean s - mean P)^2 + 1e-3 sum_q (V_q/V_c) ((s_q - mean s) - (P_q - mean P))^2 ] + 1e-4
//        |P's second degree|^2
//      over the units' means, in which every element here is most accurate, and, faintly, what varies within
//      a cell: it tells the slope where one cell is all there is across the body.
//   5  The value is P(p): a sum of the points' values with weights that do not depend on these. It is exact
//   for linear fields.
// limit() is step 6: what is read of a plastic law does not pass its yield surface.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "model/motion/discretization.hpp"

namespace femsph {

class Recovery {
 public:
  /// Of one body. Throws std::logic_error if it has no units.
  explicit Recovery(MaterialUnits units);

  /// Weights of material points for the value at p, by points; sum 1. Throws Refusal if no unit is near.
  std::vector<Weight> weights(const Point& p) const;
  /// The same of units, for fields known by their means alone: without what varies within a cell.
  std::vector<Weight> unit_weights(const Point& p) const;

 private:
  static constexpr int most = 10;        ///< coefficients of degree 2 in space
  using Factor = std::array<double, 6>;  ///< L of a symmetric matrix, xx yx yy zx zy zz
  using Basis = std::array<double, most>;
  struct Patch;
  Point scaled(const Factor& L, const Point& x, const Point& p) const;
  Basis basis(const Point& z) const;
  const Factor& factor(std::size_t unit) const { return factor_[factor_.size() > 1 ? unit : 0]; }
  double share(std::size_t point) const {
    return units_.points_per_unit > 1 ? units_.volume[point] / volume_[point / units_.points_per_unit] : 1.0;
  }

  std::size_t nearest(const Point& p) const;
  std::vector<std::size_t> within(const Point& p, const Point& half) const;
  Patch around(const Point& p, bool deviations) const;
  void look(Patch& patch, const Point& p, double radius, bool deviations) const;
  Patch fit(const Point& p, bool deviations) const;

  MaterialUnits units_;
  int coefficients_;
  std::vector<Factor> factor_;  ///< of each unit's shape, or of all
  std::vector<Point> centre_;   ///< of each unit: mean place of its points by volume
  std::vector<double> volume_;  ///< of each unit
  Point extent_{};              ///< the widest unit's reach along each axis
  // Units by the bins of a grid over their centres.
  Point lower_{}, bin_{};
  std::array<std::size_t, 3> count_{1, 1, 1};
  std::vector<std::size_t> begin_, in_bin_;
  std::array<std::size_t, 3> bin_of(const Point& p) const;
};

/// What a point's law lets the stress be, read by the weights of its stress and kept within the range of the
/// points used.
struct StressBound {
  double yield, tensile, strength;  ///< of von Mises' stress; the same where the mean stress is tension; of
                                    ///< the principal stresses
};
/// None if the law has none.
std::optional<StressBound> recovered_bound(std::span<const Weight> weights, const MaterialState& state);
/// The stress (xx yy zz xy yz zx) brought back to the yield surface: its deviator scaled, in plane stress all
/// of it, so that nothing arises across; then principal stresses cut at the strength.
std::array<double, 6> limited(const std::array<double, 6>& stress, const StressBound& bound, Plane plane);

/// State of one place from those of the points behind the weights.
struct Recovered {
  std::array<double, 6> stress{}, strain{};
  double plastic = 0;  ///< within the range of the points used
};
Recovered recovered(std::span<const Weight> weights, const MaterialState& state, Plane plane);

}  // namespace femsph
