#pragma once
// Return mapping by backward Euler: the trial stress is returned to the yield surface at the end of the step.

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/point_stress.hpp"

namespace femsph::plastic {

/// Radial return (Wilkins 1964; Simo & Hughes, Computational Inelasticity, 3.3) in space and plane strain.
/// `yield`: Y at the start of the step. q decreases by 3G dp and Y increases by H dp, so that dp = (q_trial -
/// Y) / (3G + H); the direction of the deviator does not change.
template <class T, int dim>
FEMSPH_INLINE Flow<T> radial_return(const LinearElastic& elastic, double hardening, const T& yield,
                                    PointStress<T, dim>& s) {
  const double stiffness = 3 * elastic.mu;
  const T q = von_mises(s), mean = s.mean();
  const T dp = larger(q - yield, T{}) * (1.0 / (stiffness + hardening));
  const T take = select(dp > 0.0, stiffness * dp / q, T{});
  for (int k = 0; k < symmetric_size<dim>; ++k) s.in[k] -= take * (k < dim ? s.in[k] - mean : s.in[k]);
  if constexpr (dim == 2) s.across -= take * (s.across - mean);
  return {dp, T{}};
}

/// The root of projected_return() by Newton's method from x, for a trial stress far beyond the yield surface.
/// Not inlined: this is rare.
template <class T, class Mask>
[[gnu::noinline]] T projected_root(T a, T b, T yield, double c, double k, T x, Mask yielding) {
  for (int turn = 0; turn < 16; ++turn) {  // eight suffice for a trial stress of 1000 Y at nu = -0.9
    const T A = 1.0 + c * x, B = 1.0 + x, A2 = A * A, B2 = B * B, N = a * B2 + b * A2, root = square_root(N);
    const T step = N * ((1.0 - k * x) * root - yield * A * B) /
                   (yield * (c * a * B2 * B + b * A2 * A) + k * N * root);
    x += step;
    if (!any(yielding & (step * step > 1e-14 * B2))) break;
  }
  return x;
}

/// Projected return in plane stress (Simo & Hughes, 3.4.2). With x = 2G dgamma, where d eps^p = dgamma s, the
/// sum and the difference of the normal stresses decrease at different rates:
///   sxx + syy = (..)_trial / A,   syy - sxx and sxy = (..)_trial / B,
///   A = 1 + c x,   B = 1 + x,   c = E/(3(1-nu)) / 2G = (1+nu)/(3(1-nu)),
///   q(x)^2 = a/A^2 + b/B^2,   a = 1/4 (sxx+syy)^2,   b = 3/4 (syy-sxx)^2 + 3 sxy^2,
///   dp = x q / 3G,   q = Y + H dp.
/// The last equation, divided by q Y, is g(x) = h(x) - (1 - k x)/Y = 0 with h = 1/q, k = H/3G. h is a power
/// mean (exponent -2) of two linear functions, and therefore concave and almost linear: Newton's method
/// converges monotonically from below in every lane, without safeguards, and a step from above the root ends
/// below it.
///
/// The first step, z from x = 0, is the series of the inverse of g to z^3: with w = a/q^2 and m = q g'/h = 1
/// - w (1 - c) + k q/Y,
///   x = z + s z^2 + s (2 s - 1 + (1 - c) (4 - 5 w)/3) z^3,   s = -g''/2g' = 3/2 w (1 - w) (1 - c)^2 / m.
/// For a trial stress a few per cent beyond the surface, one further Newton step of 1e-8 B or less ends the
/// iteration. It is computed without a square root: with R = 1 - k x, N = a B^2 + b A^2 and M = A B the miss
/// of the surface is g/h = 1 - R q/Y = 1 - sqrt(1 + delta), delta = R^2 N / (Y M)^2 - 1, so that, but for
/// powers of delta (1e-8 of the step), dx = (R^2 N - (Y M)^2) M / (2 R (R (c a B^3 + b A^3) + k N M)). Beside
/// it the reciprocals of A, B and R are computed and then corrected for the step to first order, so that no
/// division follows the step.
///
/// The end of the iteration: with w the share of a/A^2 in q^2, h''/h' = -3 w (1 - w) (1/B - c/A)^2 / (w c/A +
/// (1 - w)/B), whose largest value over w gives |h''| <= 3 (1 - sqrt c)^2 h' / B. So a step dx leaves an
/// error of at most 3/2 dx^2 / B (c <= 1), and 1e-7 B leaves 1.5e-14 B.
template <class T>
FEMSPH_INLINE Flow<T> projected_return(const LinearElastic& elastic, double hardening, const T& yield,
                                       PointStress<T, 2>& s) {
  const double three_g = 3 * elastic.mu, k = hardening / three_g,
               c = (1 + elastic.poisson) / (3 * (1 - elastic.poisson)), d = 1 - c;
  const T sum = s.in[0] + s.in[1], difference = s.in[1] - s.in[0], shear = s.in[2];
  const T a = 0.25 * sum * sum, b = 0.75 * difference * difference + 3.0 * shear * shear, square = a + b;
  const T yield2 = yield * yield;
  const auto yielding = square > yield2;
  if (!any(yielding)) return {T{}, T{}};

  const T q = square_root(square), ca = c * a, slope = yield * (ca + b) + k * square * q,
          r = 1.0 / (square * slope);
  const T z = square * (q - yield) * (square * r), bend = (1.5 * d * d) * (a * b) * (yield * r),
          w = a * (slope * r);
  T x = z + bend * z * z * (1.0 + z * (2.0 * bend + ((4.0 / 3 * d - 1.0) - (5.0 / 3 * d) * w)));

  const T A = 1.0 + c * x, B = 1.0 + x, R = 1.0 - k * x, A2 = A * A, B2 = B * B, bA2 = b * A2,
          N = a * B2 + bA2, M = A * B;
  const T by_slope = 0.5 / (R * (R * (ca * B2 * B + bA2 * A) + k * N * M)), by_all = 1.0 / (M * R),
          by_M = R * by_all;
  T by_A = B * by_M, by_B = A * by_M, by_R = M * by_all;
  const T step = ((R * R) * N - yield2 * (A2 * B2)) * (M * by_slope);
  if (any(yielding & !((step * step <= 1e-16 * B2) & (z < 0.2)))) {
    x = projected_root(a, b, yield, c, k, select(z < 0.2, x + step, z), yielding);
    by_A = 1.0 / (1.0 + c * x), by_B = 1.0 / (1.0 + x), by_R = 1.0 / (1.0 - k * x);
  } else {
    x += step;
    by_A -= by_A * by_A * (c * step), by_B -= by_B * by_B * step, by_R += by_R * by_R * (k * step);
  }
  x = select(yielding, x, T{});
  const T u = 0.5 * sum * by_A, half = 0.5 * by_B * difference;
  s.in[0] = select(yielding, u - half, s.in[0]);
  s.in[1] = select(yielding, u + half, s.in[1]);
  s.in[2] = select(yielding, by_B * shear, s.in[2]);
  return {select(yielding, x * (yield * by_R), T{}) * (1.0 / three_g),
          select(yielding, x * u, T{}) * (-1.0 / three_g)};
}

/// The radial return, or in plane stress the projected one.
template <class T, int dim>
FEMSPH_INLINE Flow<T> return_to_surface(const LinearElastic& elastic, double hardening, const T& yield,
                                        PointStress<T, dim>& s) {
  if constexpr (dim == 2) {
    if (elastic.plane == Plane::stress) return projected_return(elastic, hardening, yield, s);
  }
  return radial_return(elastic, hardening, yield, s);
}

}  // namespace femsph::plastic
