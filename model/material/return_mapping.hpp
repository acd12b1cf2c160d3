#pragma once
// Backward Euler: the trial stress is brought back to the yield surface that the step itself hardens.

#include "model/material/linear_elastic.hpp"
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
///   sxx + syy = (..)_trial / A,   syy - sxx and sxy = (..)_trial / B,   A = 1 + c x,  B = 1 + x,  c = E/(3(1-nu)) / 2G = (1+nu)/(3(1-nu)),
///   q(x)^2 = a/A^2 + b/B^2,  a = 1/4 (sxx+syy)^2,  b = 3/4 (syy-sxx)^2 + 3 sxy^2,    dp = x q / 3G,    q = Y + H dp.
/// The last, divided by q Y, reads h(x) - (1 - k x)/Y = 0 with h = 1/q, k = H/3G. Here h is a power mean (exponent -2) of two linear
/// functions, so it is concave and almost linear: Newton's steps from x = 0 rise to the root, each lane on its own, without a safeguard.
/// Written with N = a B^2 + b A^2 (so that h = A B / sqrt N), a step takes one root and one division.
///
/// When to stop: with w the share of a/A^2 in q^2, h''/h' = -3 w (1 - w) (1/B - c/A)^2 / (w c/A + (1 - w)/B), whose largest value over w
/// gives |h''| <= 3 (1 - sqrt c)^2 h' / B. So a step dx leaves an error of at most 3/2 dx^2 / B (c <= 1), and 1e-7 B leaves 1.5e-14 B.
template <class T>
FEMSPH_INLINE Flow<T> projected_return(const LinearElastic& elastic, double hardening, const T& yield, PointStress<T, 2>& s) {
  const double three_g = 3 * elastic.mu, k = hardening / three_g, c = (1 + elastic.poisson) / (3 * (1 - elastic.poisson));
  const T sum = s.in[0] + s.in[1], difference = s.in[1] - s.in[0], shear = s.in[2];
  const T a = 0.25 * sum * sum, b = 0.75 * difference * difference + 3.0 * shear * shear;
  const auto yielding = a + b > yield * yield;
  if (!any(yielding)) return {T{}, T{}};
  T x{};
  for (int turn = 0; turn < 16; ++turn) {  // from 1000 Y at nu = -0.9 it takes eight
    const T A = 1.0 + c * x, B = 1.0 + x, A2 = A * A, B2 = B * B, N = a * B2 + b * A2, root = square_root(N);
    const T step = N * ((1.0 - k * x) * root - yield * A * B) / (yield * (c * a * B2 * B + b * A2 * A) + k * N * root);
    x += step;
    if (!any(yielding & (step > 1e-7 * B))) break;
  }
  x = select(yielding, x, T{});
  const T A = 1.0 + c * x, B = 1.0 + x, rest = 1.0 - k * x, r = 1.0 / (A * B * rest);  // one division for 1/A, 1/B and q = Y / (1 - k x)
  const T u = 0.5 * sum * (B * rest * r), w = A * rest * r, half = 0.5 * w * difference;
  s.in[0] = select(yielding, u - half, s.in[0]);
  s.in[1] = select(yielding, u + half, s.in[1]);
  s.in[2] = select(yielding, w * shear, s.in[2]);
  return {x * yield * (A * B * r) * (1.0 / three_g), x * u * (-1.0 / three_g)};
}

}  // namespace femsph::plastic
