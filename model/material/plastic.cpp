#include "model/material/plastic.hpp"

#include "model/material/johnson_cook.hpp"
#include "model/material/no_return.hpp"
#include "model/material/return_mapping.hpp"
#include "model/material/tension.hpp"

namespace femsph {

using namespace plastic;

namespace {

/// Yield stress at p = 0: by the sign rule, where the mean stress is tension, the tensile strength.
template <class T, int dim>
FEMSPH_INLINE T initial_yield(const Plasticity& p, const PointStress<T, dim>& trial) {
  const T compressive = broadcast<T>(p.yield);
  if (p.tension != TensionRule::sign) return compressive;
  return select(trial.mean() > 0.0, broadcast<T>(p.tensile_strength), compressive);
}

/// How much the yield stress has grown: H p, E p by hypothesis 8, the largest excess so far by hypothesis 3.
template <class T>
FEMSPH_INLINE T growth(const LinearElastic& base, const Plasticity& p, const T* history) {
  switch (p.integration) {
    case Integration::largest_stress: return history[Plastic::excess];
    case Integration::modulus_mistaken: return 2 * base.mu * (1 + base.poisson) * history[Plastic::equivalent_strain];
    default: return p.hardening * history[Plastic::equivalent_strain];
  }
}

}  // namespace

template <class T, int dim>
void Plastic::flow(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
  const Plasticity& p = parameters;
  const PointStress<T, dim> before{stress, stress_across<T, dim>(history)}, trial = elastic_step(increment, stress, history);
  PointStress<T, dim> now = trial;
  const T initial = initial_yield(p, trial), yield = initial + growth(base, p, history);
  const Flow<T> step = p.johnson_cook ? johnson_cook_return(base, p, this->step, increment, history[equivalent_strain], history[work], history[excess], now)
                       : p.integration == Integration::return_mapping
                           ? return_to_surface(base, p.hardening, yield, now)
                           : tangent_step<T, dim>(base, p.hardening, yield, increment, before, now);
  if (p.tension == TensionRule::principal) cut_tension(p.tensile_strength, now);

  if (p.integration == Integration::largest_stress) history[excess] = larger(history[excess], von_mises(now) - initial);
  note<false>(trial, now, step, stress, history);
}

template void Plastic::flow(const Symmetric<double, 2>&, Symmetric<double, 2>&, double*) const;
template void Plastic::flow(const Symmetric<double, 3>&, Symmetric<double, 3>&, double*) const;
template void Plastic::flow(const Symmetric<Pack, 2>&, Symmetric<Pack, 2>&, Pack*) const;
template void Plastic::flow(const Symmetric<Pack, 3>&, Symmetric<Pack, 3>&, Pack*) const;

}  // namespace femsph
