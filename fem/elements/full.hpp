#pragma once
// Full integration: strain and stress at the 2^dim Gauss points of the cell.

#include "fem/elements/element.hpp"

namespace femsph::fem {

struct FullElement {
  static constexpr ElementEntry entry{
      .word = "full",
      .name = "full integration",
      .about =
          "linear cells, full integration; too stiff in bending, and locks in volume (Poisson's ratio near "
          "1/2, plastic flow)",
      .locks_in_volume = true};
  template <int dim>
  static constexpr int points = corners<dim>;
  static constexpr bool own_axes = false;
  static constexpr bool equal_volumes = false;

  template <class Kinematics, class T, int dim, class LawType, class Observer>
  FEMSPH_INLINE static void force(const CellMaterial<LawType>& material, const T* X, const T* u,
                                  [[maybe_unused]] T* state, T* f, Observer& observer) {
    const GaussCell<T, dim> x(X), y(u);
    GaussForce<T, dim> sum;
    each_point<LawType, corners<dim>>([&](int q) __attribute__((always_inline)) {
      Tensor<T, dim> C, P;
      const T det = cofactors<T, dim>(x.at(q), C);
      const Tensor<T, dim> H = displacement_gradient<T, dim>(y.at(q), C, 1.0 / det);
      Symmetric<T, dim> strain;
      const auto frame = Kinematics::template strain<T, dim>(H, strain);
      const auto stress = advance_law<LawType, T, dim, Kinematics>(
          material.law, strain, state + q * point_state_size<LawType, dim>);
      observer.point(q, det, frame, strain, stress,
                     history_of<LawType, dim>(state + q * point_state_size<LawType, dim>));
      Kinematics::template piola<T, dim>(frame, strain, stress, P);
      sum.add(q, P, C);
    });
    sum.nodal(f);
  }
};

}  // namespace femsph::fem
