#pragma once
// A dummy for tests/catalogue: an elastic solid that stiffens with the cube of the strain,
//   psi = lambda/2 (tr e)^2 + mu e:e + k/4 (e:e)^2,   sigma = lambda tr e I + 2 mu e + k (e:e) e.

#include "model/material/laws/linear_elastic.hpp"

namespace femsph {

struct Cubic {
  struct Parameters {
    double k = 0;  ///< Pa
  };
  static constexpr const char* name = "cubic";
  static Entry entry() {
    return {"cubic",
            "elastic, stiffening with the cube of the strain",
            {{"cubic_modulus", "a pressure", "k", true}}};
  }
  static Parameters read(auto& fields, const LawInput& in) {
    const auto k = fields.quantity("cubic_modulus", Need::required, dimension::pressure, Sign::not_negative);
    if (in.plane == Plane::stress)
      fields.fault(
          "law", "\"law\" is \"cubic\" in plane stress; expected plane = \"strain\" or \"none\" in [model]");
    return {k.value_or(0)};
  }
  static Cubic of(const Parameters& p, const ElasticConstants& m, Plane plane) {
    return {LinearElastic::make(m.young, m.poisson, m.density, plane), p};
  }

  LinearElastic base;
  Parameters parameters;

  template <int dim>
  static constexpr int history_size = 0;
  static constexpr bool path_independent = true;

  template <class T, int dim>
  FEMSPH_INLINE Symmetric<T, dim> stress(const Symmetric<T, dim>& strain) const {
    Symmetric<T, dim> s = base.stress(strain);
    const T more = parameters.k * contract(strain, strain);
    for (int k = 0; k < symmetric_size<dim>; ++k) s[k] += more * strain[k];
    return s;
  }
  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>& strain, const Symmetric<T, dim>&, const T*) const {
    const T square = contract(strain, strain);
    return 0.5 * contract(base.stress(strain), strain) + 0.25 * parameters.k * square * square;
  }
  const LinearElastic& elastic() const { return base; }
  double wave_speed() const { return base.wave_speed(); }
  double thickness_stress(const Symmetric<double, 2>& e, const Symmetric<double, 2>&, const double*) const {
    return base.plane == Plane::strain ? base.lambda * trace(e) : 0.0;
  }
  double thickness_strain(const Symmetric<double, 2>&, const Symmetric<double, 2>&, const double*) const {
    return 0;
  }
};

}  // namespace femsph
