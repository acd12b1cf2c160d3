#pragma once
// A material point of the bonds in small motion: strain and stress are those of the undeformed axes.

#include "model/material/kinematics.hpp"

namespace femsph::sph {

template <int dim, class Law>
struct SmallPoint {
  static constexpr int n = symmetric_size<dim>;
  enum Slot { stress = 0, strain = n, history = 2 * n };
  static constexpr int size = history + Law::template history_size<dim>;

  FEMSPH_INLINE static void advance(const Law& law, const Tensor<Pack, dim>& L, const Pack& undeformed,
                                    Pack* own, Symmetric<Pack, dim>& resultant) {
    Symmetric<Pack, dim> D, e, s;
    for (int r = 0; r < dim; ++r)
      for (int c = r; c < dim; ++c) D(r, c) = 0.5 * (L[r][c] + L[c][r]);
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
    const double *s = own + stress, *e = own + strain;
    if constexpr (dim == 2) {
      const Symmetric<double, 2> in{s[0], s[1], s[2]}, by{e[0], e[1], e[2]};
      stress_out = {s[0], s[1], law.thickness_stress(by, in, own + history), s[2], 0, 0};
      strain_out = {e[0], e[1], law.thickness_strain(by, in, own + history), e[2], 0, 0};
    } else {
      for (std::size_t c = 0; c < 6; ++c) stress_out[c] = s[c], strain_out[c] = e[c];
    }
  }
};

}  // namespace femsph::sph
