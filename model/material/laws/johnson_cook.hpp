#pragma once
// The yield stress of Johnson & Cook (7th Int. Symp. Ballistics, 1983), for metals at high strain rates:
//   Y = (A + B p^n) (1 + C ln max(pdot / pdot_0, 1)) (1 - T*^m),   T* = (T - T_room) / (T_melt - T_room),
//   held between 0 and 1,
// with A the `yield` of the law. There is no heat conduction: T = T_0 + chi w / (rho c), w the plastic work
// per volume.
//
// A step returns the trial stress radially to the yield surface at the end of the step (backward Euler): x =
// dp solves
//   f(x) = 3G x + Y(p + x, x / dt, T(w + q x)) - q_trial = 0,   q = q_trial - 3G x.
// f increases from a negative value at x = 0 to a positive one at q_trial / 3G. It is solved by Newton's
// method with a bracket, by bisection where a Newton step leaves the bracket; the first guess is dp of the
// step before.

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/plastic.hpp"
#include "model/material/laws/point_stress.hpp"
#include "model/numerics/elementary.hpp"

namespace femsph::plastic {

/// Y at x = dp, and dY/dx.
template <class T>
struct YieldStress {
  T value, slope;
};

/// `p` and `work` are those at the start of the step; its own plastic work is q x. `q_slope` = dq/dx. `dt` =
/// 0: the rate is not known, and its factor is 1.
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

/// `guess`: dp of the step before, replaced by that of this step. Without a strain increment (|increment| <
/// 1e-12) there is no plastic flow, so that a repeated evaluation does not relax a stress that the strain
/// rate has raised.
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
      break;  // a test of stress: near x = 0 the rate makes the slope so steep that a small step does not
              // show convergence
    x = select(inside, next, 0.5 * (low + high));
  }
  const T dp = select(yielding, x, T{}), take = select(yielding, stiffness * dp / q, T{});
  for (int k = 0; k < symmetric_size<dim>; ++k) s.in[k] -= take * (k < dim ? s.in[k] - mean : s.in[k]);
  if constexpr (dim == 2) s.across -= take * (s.across - mean);
  guess = dp;
  return {dp, T{}};
}

}  // namespace femsph::plastic
