#pragma once
// Smoothing kernels W(r, h) with support radius 2 h, normalised in 2D or 3D.

#include <cmath>
#include <numbers>

#include "model/numerics/simd.hpp"
#include "sph/options.hpp"

namespace femsph::sph {

/// Cubic B-spline, eq. 4 of the paper (Monaghan & Lattanzio 1985): 2D factor 15/(7 pi h^2), 3D factor 3/(2 pi
/// h^3). q = r/h.
struct CubicSpline {
  static constexpr double factor(int dim) {
    return dim == 2 ? 15 / (7 * std::numbers::pi) : 3 / (2 * std::numbers::pi);
  }
  static double value(double q) {
    if (q < 1) return 2.0 / 3 - q * q + 0.5 * q * q * q;
    return q < 2 ? (2 - q) * (2 - q) * (2 - q) / 6 : 0.0;
  }
  /// -(dW/dq) / q, finite at q = 0. T is double or Pack.
  template <class T>
  FEMSPH_INLINE static T steepness(const T& q) {
    const T left = select(q < 2.0, 2.0 - q, T{});
    return select(q < 1.0, 2.0 - 1.5 * q, 0.5 * left * left / q);
  }
};

/// Wendland C2 (1995): 2D factor 7/(4 pi h^2), 3D factor 21/(16 pi h^3); (1 - q/2)^4 (2 q + 1).
struct WendlandC2 {
  static constexpr double factor(int dim) {
    return dim == 2 ? 7 / (4 * std::numbers::pi) : 21 / (16 * std::numbers::pi);
  }
  static double value(double q) {
    if (q >= 2) return 0;
    const double s = 1 - 0.5 * q;
    return s * s * s * s * (2 * q + 1);
  }
  template <class T>
  FEMSPH_INLINE static T steepness(const T& q) {
    const T s = select(q < 2.0, 1.0 - 0.5 * q, T{});
    return 5.0 * s * s * s;
  }
};

/// A kernel of given kind, dimension and smoothing length h (m).
class Kernel {
 public:
  Kernel(KernelKind kind, int dim, double h)
      : kind_(kind), h_(h), scale_(std::pow(h, -dim) * factor(kind, dim)) {}
  KernelKind kind() const { return kind_; }
  double h() const { return h_; }
  double radius() const { return 2 * h_; }
  /// W(r), m^-dim.
  double value(double r) const {
    const double q = r / h_;
    return scale_ * (kind_ == KernelKind::cubic_spline ? CubicSpline::value(q) : WendlandC2::value(q));
  }
  /// -(dW/dr)/r >= 0, m^-(dim+2): grad_i W_ij = steepness(r) (x_j - x_i).
  double steepness(double r) const {
    const double q = r / h_;
    return steepness_factor() *
           (kind_ == KernelKind::cubic_spline ? CubicSpline::steepness(q) : WendlandC2::steepness(q));
  }

  /// steepness(r) over the steepness of the kernel as a function of q = r/h, m^-(dim+2).
  double steepness_factor() const { return scale_ / (h_ * h_); }

 private:
  static double factor(KernelKind kind, int dim) {
    return kind == KernelKind::cubic_spline ? CubicSpline::factor(dim) : WendlandC2::factor(dim);
  }
  KernelKind kind_;
  double h_, scale_;
};

}  // namespace femsph::sph
