#pragma once
// Selective reduced integration: normal strains at the Gauss points, each shear strain replaced by its
// average over the cell. It is the B-bar idea of Hughes (Int. J. Numer. Meth. Engng 15, 1980) applied to the
// shear. The average of a linear field is exact on any cell, so the patch test holds. "Shear" has a meaning
// in the cell's own axes only: nodal vectors are turned into them first.

#include "fem/elements/element.hpp"
#include "fem/elements/rotation.hpp"

namespace femsph::fem {

struct SriElement {
  static constexpr ElementEntry entry{
      .word = "sri",
      .name = "selective reduced integration",
      .about = "selective reduced integration of the shear: bends; locks in volume as fem-full does",
      .locks_in_volume = true};
  template <int dim>
  static constexpr int points = corners<dim>;
  static constexpr bool own_axes = true;
  static constexpr bool equal_volumes = false;

  template <class Kinematics, class T, int dim, class LawType, class Observer>
  FEMSPH_INLINE static void force(const CellMaterial<LawType>& material, const T* X, const T* u,
                                  [[maybe_unused]] T* state, T* f, Observer& observer) {
    constexpr int n = corners<dim>, shears = symmetric_size<dim> - dim;
    const GaussCell<T, dim> x(X), y(u);
    Tensor<T, dim> C[n];
    Symmetric<T, dim> strain[n], stress[n];
    typename Kinematics::template Frame<T, dim> frame[n];
    T det[n], volume = T{}, shear_strain[shears]{}, shear_stress[shears]{};
    for (int q = 0; q < n; ++q) {
      det[q] = cofactors<T, dim>(x.at(q), C[q]);
      frame[q] = Kinematics::template strain<T, dim>(
          displacement_gradient<T, dim>(y.at(q), C[q], 1.0 / det[q]), strain[q]);
      volume += det[q];
      for (int k = 0; k < shears; ++k) shear_strain[k] += det[q] * strain[q][dim + k];
    }
    const T share = 1.0 / volume;
    for (int q = 0; q < n; ++q) {
      Symmetric<T, dim> assumed = strain[q];
      for (int k = 0; k < shears; ++k) assumed[dim + k] = shear_strain[k] * share;
      stress[q] = advance_law<LawType, T, dim, Kinematics>(
          material.law, assumed, state + q * point_state_size<LawType, dim>);
      observer.point(q, det[q], frame[q], assumed, stress[q],
                     history_of<LawType, dim>(state + q * point_state_size<LawType, dim>));
      stress[q] = Kinematics::template conjugate<T, dim>(assumed, stress[q]);
      for (int k = 0; k < shears; ++k) shear_stress[k] += det[q] * stress[q][dim + k];
    }
    GaussForce<T, dim> sum;
    for (int q = 0; q < n; ++q) {
      Tensor<T, dim> P;
      for (int k = 0; k < shears; ++k) stress[q][dim + k] = shear_stress[k] * share;
      if constexpr (rotates<Kinematics>)
        coupled_piola<T, dim>(frame[q], strain[q], stress[q], Tensor<T, dim>{}, P);
      else
        Kinematics::template piola<T, dim>(frame[q], strain[q], stress[q], P);
      sum.add(q, P, C[q]);
    }
    sum.nodal(f);
  }
};

}  // namespace femsph::fem
