#include "model/material/laws/fluid.hpp"

#include "model/input/toml_fields.hpp"
#include "model/material/laws/log_volume.hpp"
#include "model/material/laws/point_stress.hpp"
#include "model/numerics/elementary.hpp"

namespace femsph {

Entry Fluid::entry() {
  return {"fluid",
          "a fluid: the pressure follows from the equation of state [materials.NAME.eos]; only with motion = "
          "\"large\", and without \"young\" and \"poisson\"",
          {{"viscosity", key_holds::quantity(dimension::viscosity),
            "The dynamic viscosity. 0, no viscosity, unless given."}}};
}

std::vector<KeyTable> Fluid::tables() { return {EquationOfState::table()}; }

Fluid::Parameters Fluid::read(Fields& fields, const LawInput& in) {
  Parameters p;
  p.eos = EquationOfState::read(fields, in.constants.density, 0);
  p.viscosity =
      fields.quantity("viscosity", Need::optional, dimension::viscosity, Sign::not_negative).value_or(0);
  if (in.plane == Plane::stress)
    fields.fault(
        "law", "\"law\" is \"fluid\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
  return p;
}

std::vector<std::string> Fluid::effects(const Parameters& p) {
  std::vector<std::string> on = {"fluid"};
  if (p.viscosity > 0) on.emplace_back("viscosity of the fluid");
  return on;
}

Fluid Fluid::of(const Parameters& p, const ElasticConstants& m, Plane plane) {
  Fluid law;
  law.parameters = p;
  law.base = LinearElastic::make(1, 0, m.density, plane);
  law.base.lambda = p.eos.bulk;
  law.base.mu = 0;
  law.base.poisson = nearly_half;
  return law;
}

template <class T, int dim>
void Fluid::advance(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
  plastic::PointStress<T, dim> s{stress, T{}};
  if constexpr (dim == 2) s.across = history[across];
  const T before = history[log_volume], now = before + log_volume_change(increment);
  const T factor = cauchy ? broadcast<T>(1.0) : exponential(now);
  const T mean = s.mean();
  const T pressure = -mean * (cauchy ? broadcast<T>(1.0) : exponential(-before));
  T sheared_across{};
  Symmetric<T, dim> sheared{};
  if (parameters.viscosity > 0) {
    // At rest the stress stays: a stress that is read again, without a step, is the same.
    const auto moving = contract(increment, increment) > 0.0;
    const T rate = (step > 0 ? 2 * parameters.viscosity / step : 0.0) * factor,
            third = (1.0 / 3) * trace(increment);
    T twice{};
    for (int k = 0; k < symmetric_size<dim>; ++k) {
      const T old = k < dim ? stress[k] - mean : stress[k];
      sheared[k] = select(moving, rate * (k < dim ? increment[k] - third : increment[k]), old);
      twice += (k < dim ? 1.0 : 2.0) * (old + sheared[k]) * increment[k];
    }
    sheared_across = select(moving, -rate * third, s.across - mean);
    history[work] += 0.5 * twice;
  }
  const T heat = cauchy ? history[work] * exponential(now) : history[work];
  const auto point = parameters.eos.advance<T>(before, now, {pressure, history[energy]}, heat);
  history[log_volume] = now;
  history[energy] = point.energy;
  for (int k = 0; k < symmetric_size<dim>; ++k)
    stress[k] = k < dim ? sheared[k] - factor * point.pressure : sheared[k];
  if constexpr (dim == 2) history[across] = sheared_across - factor * point.pressure;
}

template <class T>
T Fluid::stored(const T* history) const {
  const T energy_now = parameters.eos.stored(history[log_volume], history[energy]);
  return cauchy ? energy_now * exponential(-history[log_volume]) : energy_now;
}

template <class T>
T Fluid::stiffening(const T& g, const T& J) const {
  const double damping = step > 0 ? 8.0 / 3 * parameters.viscosity / step / parameters.eos.bulk : 0.0;
  return g * (parameters.eos.stiffness(J) + damping * J);
}

#define FEMSPH_FOR(T)                                                               \
  template void Fluid::advance(const Symmetric<T, 2>&, Symmetric<T, 2>&, T*) const; \
  template void Fluid::advance(const Symmetric<T, 3>&, Symmetric<T, 3>&, T*) const; \
  template T Fluid::stored(const T*) const;                                         \
  template T Fluid::stiffening(const T&, const T&) const;
FEMSPH_FOR(double)
FEMSPH_FOR(Pack)
#undef FEMSPH_FOR

}  // namespace femsph
