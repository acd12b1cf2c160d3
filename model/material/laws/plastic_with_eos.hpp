#pragma once
// A plastic material whose mean stress follows from an equation of state: the table "eos" of a plastic
// material. The deviator follows the plastic law with the shear modulus of "young" and "poisson". It is a
// type of its own, so that plastic materials without an equation of state carry neither its history nor a
// branch. Not in plane stress, without a tension rule, with return mapping. Stress and energies as in
// fluid.hpp.

#include "model/material/laws/plastic.hpp"

namespace femsph {

struct PlasticWithEos : Plastic {
  static constexpr bool large_motion_only = true;

  LinearElastic whole;  ///< with the bulk modulus of the equation of state at rest
  bool cauchy = false;  ///< of the stress that update() takes and returns; else Kirchhoff
  void return_cauchy() { cauchy = true; }

  /// `p.eos` must be there.
  static PlasticWithEos of(const Plasticity& p, const ElasticConstants& m, Plane plane);

  /// The first three entries are those of Plastic; `normal`: the stress normal to the plane, 2D only.
  enum VolumeSlot { log_volume = excess + 1, energy, normal };
  template <int dim>
  static constexpr int history_size = dim == 2 ? 6 : 5;

  template <class T, int dim>
  FEMSPH_INLINE void update(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const {
    const Symmetric<T, dim> by =
        increment;  // copies: what the kernel holds in registers must not have an address
    Symmetric<T, dim> to = stress;
    advance(by, to, history);
    stress = to;
  }
  /// update(). In plastic_with_eos.cpp for T = double and Pack, dim = 2 and 3.
  template <class T, int dim>
  void advance(const Symmetric<T, dim>& increment, Symmetric<T, dim>& stress, T* history) const;

  /// That of the pressure, and s:s/4G of the deviator s.
  template <class T, int dim>
  FEMSPH_INLINE T stored_energy(const Symmetric<T, dim>&, const Symmetric<T, dim>& stress,
                                const T* history) const {
    const Symmetric<T, dim> in = stress;
    return stored(in, history);
  }
  template <class T, int dim>
  T stored(const Symmetric<T, dim>& stress, const T* history) const;

  /// As Plastic, with the stiffness of the equation of state in place of K (1 - ln J).
  template <class T>
  T stiffening(const T& g, const T& J) const;

  const LinearElastic& elastic() const { return whole; }
  double wave_speed() const { return whole.wave_speed(); }
  double thickness_stress(const Symmetric<double, 2>&, const Symmetric<double, 2>&,
                          const double* history) const {
    return history[normal];
  }
  double thickness_strain(const Symmetric<double, 2>&, const Symmetric<double, 2>&, const double*) const {
    return 0;
  }
};

inline FlowStress flow_stress(const PlasticWithEos& law, const double* history, double share,
                              const std::array<double, 6>& cauchy) {
  return flow_stress(static_cast<const Plastic&>(law), history, share, cauchy);
}

}  // namespace femsph
