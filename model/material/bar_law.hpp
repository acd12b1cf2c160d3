#pragma once
// The uniaxial law of reinforcing bars, and their axial strain.

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "model/material/kinematics.hpp"
#include "model/material/laws/law_input.hpp"

namespace femsph {

/// The history of a point of a bar.
struct BarState {
  double stress = 0;  ///< Pa
  double plastic_strain = 0;
  double equivalent = 0;  ///< sum of |plastic strain increments|
  double dissipated = 0;  ///< plastic work, J/m^3
};

/// Uniaxial elastoplasticity with linear isotropic hardening: |sigma| <= yield + H alpha. The return in one
/// dimension is exact (Simo & Hughes, Computational Inelasticity, box 1.4): d gamma = f_trial / (E + H).
struct BarLaw {
  double young, yield, hardening, density;  ///< Pa, Pa, Pa, kg/m^3

  static BarLaw make(double young, double density, const BarYield& law) {
    return {young, law.yield, law.hardening, density};
  }

  /// The stress at the total strain; advances the state. Plastic work is computed with the mean stress of the
  /// step, like the work of all forces, so that the energy balance closes.
  double advance(double strain, BarState& s) const {
    const double before = s.stress;
    s.stress = young * (strain - s.plastic_strain);
    const double over = std::abs(s.stress) - (yield + hardening * s.equivalent);
    if (over > 0) {
      const double flow = over / (young + hardening), signed_flow = std::copysign(flow, s.stress);
      s.plastic_strain += signed_flow;
      s.equivalent += flow;
      s.stress -= young * signed_flow;
      s.dissipated += 0.5 * (before + s.stress) * signed_flow;
    }
    return s.stress;
  }
  double stress(double strain, const BarState& s) const { return young * (strain - s.plastic_strain); }
  /// Elastic energy, J/m^3.
  double stored(double strain, const BarState& s) const {
    return 0.5 * stress(strain, s) * (strain - s.plastic_strain);
  }
};

/// The axial strain of a bar along axis a, and the direction `pull` of its force, from the column g = du/dX_a
/// of the displacement gradient. Small motion: g_a and e_a. Large motion: |e_a + g| - 1 and (e_a + g)/|e_a +
/// g|, which are work conjugate.
template <class Kinematics, int dim>
double bar_strain(const double (&g)[dim], int a, double (&pull)[dim]) {
  for (int r = 0; r < dim; ++r) pull[r] = r == a ? 1.0 : 0.0;
  if constexpr (!std::is_same_v<Kinematics, SmallStrain>) {
    double square = 0;
    for (int r = 0; r < dim; ++r) pull[r] += g[r], square += pull[r] * pull[r];
    const double stretch = std::sqrt(square);
    for (double& p : pull) p /= stretch;
    return stretch - 1;
  }
  return g[a];
}

}  // namespace femsph
