#include "model/material/laws/plastic_with_eos.hpp"

#include "model/material/laws/log_volume.hpp"

namespace femsph {

PlasticWithEos PlasticWithEos::of(const Plasticity& p, const ElasticConstants& m, Plane plane) {
  PlasticWithEos law;
  law.base = law.whole = LinearElastic::make(m.young, m.poisson, m.density, plane);
  law.parameters = p;
  const double K = p.eos->bulk, G = law.base.mu;
  law.whole.lambda = K - 2.0 / 3 * G;
  law.whole.poisson = (3 * K - 2 * G) / (2 * (3 * K + G));
  return law;
}

/// The plastic law gets the deviatoric stress and the whole increment. Its flow and plastic work depend on
/// the deviators alone, so that its bulk modulus does not matter; the mean stress that it adds is taken off.
template <class T, int dim>
void PlasticWithEos::advance(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress,
                             T* history) const {
  plastic::PointStress<T, dim> s{stress, T{}};
  if constexpr (dim == 2) s.across = history[normal];
  const T before = history[log_volume], now = before + log_volume_change(increment);
  const T factor = cauchy ? broadcast<T>(1.0) : exponential(now);
  const T mean = s.mean();
  const T pressure = -mean * (cauchy ? broadcast<T>(1.0) : exponential(-before));
  T own[4] = {history[equivalent_strain], history[work], history[excess], s.across - mean};
  for (int k = 0; k < dim; ++k) s.in[k] -= mean;
  Plastic::update<T, dim>(increment, s.in, own);
  s.across = own[across];
  history[equivalent_strain] = own[equivalent_strain];
  history[work] = own[work];
  history[excess] = own[excess];

  const T heat = cauchy ? history[work] * exponential(now) : history[work];
  const auto point = parameters.eos->advance<T>(before, now, {pressure, history[energy]}, heat);
  history[log_volume] = now;
  history[energy] = point.energy;
  const T shift = s.mean() + factor * point.pressure;
  for (int k = 0; k < symmetric_size<dim>; ++k) stress[k] = k < dim ? s.in[k] - shift : s.in[k];
  if constexpr (dim == 2) history[normal] = s.across - shift;
}

template <class T, int dim>
T PlasticWithEos::stored(const Symmetric<T, dim>& stress, const T* history) const {
  plastic::PointStress<T, dim> s{stress, T{}};
  if constexpr (dim == 2) s.across = history[normal];
  const T of_pressure = parameters.eos->stored(history[log_volume], history[energy]);
  return plastic::von_mises_square(s) * (1 / (6 * base.mu)) +
         (cauchy ? of_pressure * exponential(-history[log_volume]) : of_pressure);
}

template <class T>
T PlasticWithEos::stiffening(const T& g, const T& J) const {
  const double shear = 4.0 / 3 * base.mu, bulk = parameters.eos->bulk;
  return g * (bulk * parameters.eos->stiffness(J) + shear) * (1 / (bulk + shear));
}

#define FEMSPH_FOR(T)                                                                        \
  template void PlasticWithEos::advance(const Symmetric<T, 2>&, Symmetric<T, 2>&, T*) const; \
  template void PlasticWithEos::advance(const Symmetric<T, 3>&, Symmetric<T, 3>&, T*) const; \
  template T PlasticWithEos::stored(const Symmetric<T, 2>&, const T*) const;                 \
  template T PlasticWithEos::stored(const Symmetric<T, 3>&, const T*) const;                 \
  template T PlasticWithEos::stiffening(const T&, const T&) const;
FEMSPH_FOR(double)
FEMSPH_FOR(Pack)
#undef FEMSPH_FOR

}  // namespace femsph
