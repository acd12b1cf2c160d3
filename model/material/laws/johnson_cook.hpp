#pragma once
// The yield stress of Johnson & Cook (7th Int. Symp. Ballistics, 1983), for metals hit hard:
//   Y = (A + B p^n) (1 + C ln max(pdot / pdot_0, 1)) (1 - T*^m),   T* = (T - T_room) / (T_melt - T_room),
//   held between 0 and 1,
// with A the law's `yield`. The heat of plastic work stays where it arises: T = T_0 + chi w / (rho c), w the
// plastic work per volume.
//
// One step brings the trial stress back to the surface of its own end (backward Euler, radial return): x = dp
// solves
//   f(x) = 3G x + Y(p + x, x / dt, T(w + q x)) - q_trial = 0,   q = q_trial - 3G x.
// f rises from below zero at 0 to above at q_trial / 3G: Newton's steps inside a bracket that shrinks, halved
// when they leave it, started from the flow of the step before.

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/plastic.hpp"
#include "model/material/laws/point_stress.hpp"
#include "model/numerics/elementary.hpp"

namespace femsph::plastic {

/// Y of x = dp, and its derivative.
template <class T>
struct YieldStress {
  T value, slope;
};

/// `dt` 0: no rate is known, and that factor is 1. `p`, `work`: at the step's start; the step's own work is q
/// x, `q_slope` = dq/dx.
template <class T>
FEMSPH_INLINE YieldStress<T> johnson_cook(const Plasticity& law, double dt, const T& p, const T& x,
                                          const T& work, const T& q, const T& q_slope) {
  const JohnsonCook& jc = *law.johnson_cook;
  const T now = p + x, there = select(now > 0.0, now, broadcast<T>(1e-300));
  const T power = exponential(jc.n * natural_log(there));
  T value = law.yield + jc.B * power, slope = jc.B * jc.n * power / there;
  if (jc.C > 0 && dt > 0) {
    const T ratio = x * (1 / (dt * jc.rate));
    const auto fast = ratio > 1.0;
    const T factor = 1.0 + jc.C * natural_log(select(fast, ratio, broadcast<T>(1.0)));
    slope = slope * factor + select(fast, value * jc.C / select(fast, x, broadcast<T>(1.0)), T{});
    value = value * factor;
  }
  if (jc.melting > 0) {
    const double range = jc.melting - jc.room;
    const T warm = (jc.start - jc.room + jc.heating * (work + q * x)) * (1 / range);
    const auto between = (warm > 0.0) & (warm < 1.0);
    const T share = select(warm >= 1.0, broadcast<T>(1.0), select(between, warm, T{}));
    const T soft = select(
        share > 0.0, exponential(jc.m * natural_log(select(share > 0.0, share, broadcast<T>(1.0)))), T{});
    const T soft_slope = select(
        between,
        jc.m * soft / select(between, share, broadcast<T>(1.0)) * (jc.heating / range) * (q + q_slope * x),
        T{});
    slope = slope * (1.0 - soft) - value * soft_slope;
    value = value * (1.0 - soft);
  }
  return {value, slope};
}

/// `guess` is the flow of the step before and takes that of this one. Where the strain stands still
/// (|increment| < 1e-12) nothing flows: the stress that the rate holds up does not fall by being looked at
/// once more.
template <class T, int dim>
FEMSPH_INLINE Flow<T> johnson_cook_return(const LinearElastic& elastic, const Plasticity& law, double dt,
                                          const Symmetric<T, dim>& increment, const T& p, const T& work,
                                          T& guess, PointStress<T, dim>& s) {
  const double stiffness = 3 * elastic.mu;
  const T q = von_mises(s), mean = s.mean();
  const auto beyond = q > johnson_cook<T>(law, dt, p, T{}, work, q, T{}).value;
  const auto moving = contract(increment, increment) > 1e-24;
  const auto yielding = beyond & moving;
  if (!any(yielding)) {
    guess = T{};
    return {T{}, T{}};
  }
  const T slope_of_q = broadcast<T>(-stiffness);
  const T most = q * (1 / stiffness);
  T low{}, high = most, x = select((guess > 0.0) & (guess < most), guess, 1e-3 * most);
  for (int turn = 0; turn < 200; ++turn) {
    const T left = q - stiffness * x;
    const YieldStress<T> y = johnson_cook<T>(law, dt, p, x, work, left, slope_of_q);
    const T f = y.value - left, step = f / (stiffness + y.slope);
    const auto over = f > 0.0;
    high = select(over, x, high), low = select(over, low, x);
    const T next = x - step, off = select(over, f, -f);
    const auto inside = (next >= low) & (next <= high);
    if (!any(yielding & (off > 1e-13 * q)))
      break;  // by stress: the rate makes the slope so steep near x = 0 that small steps prove nothing
    x = select(inside, next, 0.5 * (low + high));
  }
  const T dp = select(yielding, x, T{}), take = select(yielding, stiffness * dp / q, T{});
  for (int k = 0; k < symmetric_size<dim>; ++k) s.in[k] -= take * (k < dim ? s.in[k] - mean : s.in[k]);
  if constexpr (dim == 2) s.across -= take * (s.across - mean);
  guess = dp;
  return {dp, T{}};
}

}  // namespace femsph::plastic
