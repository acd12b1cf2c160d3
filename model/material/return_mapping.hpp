#pragma once
// Backward Euler: the trial stress is brought back to the yield surface that the step itself hardens.

#include "model/material/point_stress.hpp"

namespace femsph::plastic {

/// Radial return (Wilkins 1964; Simo & Hughes, Computational Inelasticity, 3.3) in space and plane strain. `yield`: Y at the step's start.
/// q falls by 3G dp while Y grows by H dp: dp = (q_trial - Y) / (3G + H), and the deviator keeps its direction.
template <class T, int dim>
FEMSPH_INLINE Flow<T> radial_return(const LinearElastic& elastic, double hardening, const T& yield, PointStress<T, dim>& s) {
  const double stiffness = 3 * elastic.mu;
  const T q = von_mises(s), mean = s.mean();
  const T dp = larger(q - yield, T{}) * (1.0 / (stiffness + hardening));
  const T take = select(dp > 0.0, stiffness * dp / q, T{});
  for (int k = 0; k < symmetric_size<dim>; ++k) s.in[k] -= take * (k < dim ? s.in[k] - mean : s.in[k]);
  if constexpr (dim == 2) s.across -= take * (s.across - mean);
  return {dp, T{}};
}

/// Projected return in plane stress (Simo & Hughes, 3.4.2). With x = 2G dgamma, where d eps^p = dgamma s, the sum and the difference of
/// the normal stresses fall at their own rates:
///   sxx + syy = (..)_trial / (1 + c x),   syy - sxx and sxy = (..)_trial / (1 + x),   c = E/(3(1-nu)) / 2G = (1+nu)/(3(1-nu)),
///   q(x)^2 = 1/4 (sxx+syy)^2 + 3/4 (syy-sxx)^2 + 3 sxy^2,    dp = x q / 3G,    q = Y + H dp.
/// The last, divided by q Y, reads 1/q - (1 - x H/3G)/Y = 0. Here 1/q is a power mean (exponent -2) of two linear functions, so it is
/// concave and almost linear: Newton's steps from x = 0 rise to the root, each lane on its own, without a safeguard. Five of them leave an
/// error below 1e-13 for nu >= -0.5 and trial stresses up to 1000 Y (eight for nu >= -0.9).
template <class T>
FEMSPH_INLINE Flow<T> projected_return(const LinearElastic& elastic, double hardening, const T& yield, PointStress<T, 2>& s) {
  const double three_g = 3 * elastic.mu, k = hardening / three_g, c = (1 + elastic.poisson) / (3 * (1 - elastic.poisson));
  const auto yielding = von_mises(s) > yield;
  if (!any(yielding)) return {T{}, T{}};
  const T sum = s.in[0] + s.in[1], difference = s.in[1] - s.in[0], shear = s.in[2];
  const T a = 0.25 * sum * sum, b = 0.75 * difference * difference + 3.0 * shear * shear, softness = 1.0 / yield;
  const int turns = elastic.poisson < -0.5 ? 8 : 5;
  T x{};
  for (int turn = 0; turn < turns; ++turn) {
    const T u = 1.0 / (1.0 + c * x), w = 1.0 / (1.0 + x);
    const T au = a * u * u, bw = b * w * w, r = 1.0 / square_root(au + bw);
    x += ((1.0 - k * x) * softness - r) / ((c * au * u + bw * w) * r * r * r + k * softness);
  }
  x = select(yielding, x, T{});
  const T u = 0.5 * sum / (1.0 + c * x), w = 1.0 / (1.0 + x), half = 0.5 * w * difference;
  s.in[0] = select(yielding, u - half, s.in[0]);
  s.in[1] = select(yielding, u + half, s.in[1]);
  s.in[2] = select(yielding, w * shear, s.in[2]);
  return {x * von_mises(s) * (1.0 / three_g), x * u * (-1.0 / three_g)};
}

}  // namespace femsph::plastic
