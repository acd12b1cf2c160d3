#pragma once
// A dummy for tests/catalogue: full integration with twice the force. It is as stiff as an element whose
// material has twice Young's modulus.

#include "fem/elements/full.hpp"

namespace femsph::fem {

struct DoubledElement : FullElement {
  static constexpr ElementEntry entry{
      .word = "doubled",
      .name = "doubled full integration",
      .about = "twice as stiff as fem-full, for a test",
      .locks_in_volume = true};

  template <class Kinematics, class T, int dim, class LawType, class Observer>
  FEMSPH_INLINE static void force(const CellMaterial<LawType>& material, const T* X, const T* u, T* state,
                                  T* f, Observer& observer) {
    FullElement::force<Kinematics, T, dim>(material, X, u, state, f, observer);
    for (int i = 0; i < dim * corners<dim>; ++i) f[i] *= 2.0;
  }
};

}  // namespace femsph::fem
