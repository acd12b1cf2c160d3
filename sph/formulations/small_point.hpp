#pragma once
// A material point of the bonds in small motion: strain and stress are those of the undeformed axes.

#include "model/material/spatial_state.hpp"

namespace femsph::sph {

template <int dim, class Law>
struct SmallPoint {
  static constexpr int n = symmetric_size<dim>;
  enum Slot { stress = 0, strain = n, history = 2 * n };
  static constexpr int size = history + Law::template history_size<dim>;

  FEMSPH_INLINE static void advance(const Law& law, const Tensor<Pack, dim>& L, const Pack& undeformed,
                                    Pack* own, Symmetric<Pack, dim>& resultant) {
    Symmetric<Pack, dim> D, e, s;
    SmallStrain::strain<Pack, dim>(L, D);
    for (int k = 0; k < n; ++k) own[strain + k] += D[k], e[k] = own[strain + k], s[k] = own[stress + k];
    if constexpr (Law::path_independent)
      s = law.stress(e);
    else
      law.update(D, s, own + history);
    for (int k = 0; k < n; ++k) own[stress + k] = s[k], resultant[k] = undeformed * s[k];
  }

  FEMSPH_INLINE static Pack stored(const Law& law, const Pack& undeformed, const Pack* own) {
    Symmetric<Pack, dim> e, s;
    for (int k = 0; k < n; ++k) e[k] = own[strain + k], s[k] = own[stress + k];
    return undeformed * law.stored_energy(e, s, own + history);
  }

  static void show(const Law& law, const double* own, std::array<double, 6>& stress_out,
                   std::array<double, 6>& strain_out) {
    Symmetric<double, dim> s, e;
    for (int k = 0; k < n; ++k) s[k] = own[stress + k], e[k] = own[strain + k];
    spatial_state<SmallStrain>(law, Tensor<double, dim>{}, s, e, own + history, stress_out, strain_out);
  }
};

}  // namespace femsph::sph
