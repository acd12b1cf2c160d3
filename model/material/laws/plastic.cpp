#include "model/material/laws/plastic.hpp"

#include <algorithm>

#include "model/material/laws/johnson_cook.hpp"
#include "model/material/laws/no_return.hpp"
#include "model/material/laws/return_mapping.hpp"
#include "model/material/laws/tension.hpp"

namespace femsph {

using namespace plastic;

namespace {

/// The yield stress at p = 0: the tensile strength where the mean stress is tensile and tension = "sign".
template <class T, int dim>
FEMSPH_INLINE T initial_yield(const Plasticity& p, const PointStress<T, dim>& trial) {
  const T compressive = broadcast<T>(p.yield);
  if (p.tension != TensionRule::sign) return compressive;
  return select(trial.mean() > 0.0, broadcast<T>(p.tensile_strength), compressive);
}

/// The increase of the yield stress over its initial value: H p; E p in hypothesis 8; the largest excess so
/// far in hypothesis 3.
template <class T>
FEMSPH_INLINE T yield_increase(const LinearElastic& base, const Plasticity& p, const T* history) {
  switch (p.integration) {
    case Integration::largest_stress:
      return history[Plastic::excess];
    case Integration::modulus_mistaken:
      return 2 * base.mu * (1 + base.poisson) * history[Plastic::equivalent_strain];
    default:
      return p.hardening * history[Plastic::equivalent_strain];
  }
}

}  // namespace

template <class T, int dim>
void Plastic::flow(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
  const Plasticity& p = parameters;
  const PointStress<T, dim> before{stress, stress_across<T, dim>(history)},
      trial = elastic_step(increment, stress, history);
  PointStress<T, dim> now = trial;
  const T initial = initial_yield(p, trial), yield = initial + yield_increase(base, p, history);
  const Flow<T> step = p.johnson_cook
                           ? johnson_cook_return(base, p, this->step, increment, history[equivalent_strain],
                                                 history[work], history[excess], now)
                       : p.integration == Integration::return_mapping
                           ? return_to_surface(base, p.hardening, yield, now)
                           : tangent_step<T, dim>(base, p.hardening, yield, increment, before, now);
  if (p.tension == TensionRule::principal) cut_tension(p.tensile_strength, now);

  if (p.integration == Integration::largest_stress)
    history[excess] = larger(history[excess], von_mises(now) - initial);
  note<false>(trial, now, step, stress, history);
}

FlowStress flow_stress(const Plastic& law, const double* history, double share,
                       const std::array<double, 6>& cauchy) {
  const Plasticity& p = law.parameters;
  FlowStress bound;
  if (p.tension == TensionRule::principal) bound.strength = share * p.tensile_strength;
  if (p.integration != Integration::return_mapping) return bound;
  const double grown = p.hardening * history[Plastic::equivalent_strain];
  bound.yield = share * (p.yield + grown);
  bound.tensile = p.tension == TensionRule::sign ? share * (p.tensile_strength + grown) : bound.yield;
  if (p.johnson_cook) {
    const double last = history[Plastic::excess], before = history[Plastic::equivalent_strain] - last;
    const Symmetric<double, 3> s{cauchy[0], cauchy[1], cauchy[2], cauchy[3], cauchy[4], cauchy[5]};
    const double rate_and_heat =
        johnson_cook<double>(p, law.step, before, last, history[Plastic::work], 0.0, 0.0).value;
    bound.yield = bound.tensile = std::max(share * rate_and_heat, von_mises<double, 3>({s, 0.0}));
  }
  return bound;
}

template void Plastic::flow(const Symmetric<double, 2>&, Symmetric<double, 2>&, double*) const;
template void Plastic::flow(const Symmetric<double, 3>&, Symmetric<double, 3>&, double*) const;
template void Plastic::flow(const Symmetric<Pack, 2>&, Symmetric<Pack, 2>&, Pack*) const;
template void Plastic::flow(const Symmetric<Pack, 3>&, Symmetric<Pack, 3>&, Pack*) const;

}  // namespace femsph
