#pragma once
// The elements: Q1 cells, total Lagrangian. Each takes nodal coordinates X and displacements u of one cell (T
// = double) or of eight (T = Pack), x[corner * dim + component], and gives f = dE/du, the nodal forces that
// the stress works against. The force is always the exact adjoint of the strain, so a law with an energy
// gives a force with an energy.
//
// An observer sees every material point (number, volume, frame, strain, stress, the law's history) and the
// hourglass energy; Unobserved is free.

#include <type_traits>

#include "fem/elements/hourglass_moduli.hpp"
#include "fem/elements/mean_cell.hpp"
#include "fem/elements/rotation.hpp"
#include "model/material/kinematics.hpp"

namespace femsph::fem {

/// What the kernels need to know of the material.
template <class LawType>
struct CellMaterial {
  LawType law;
  LinearElastic elastic;      ///< its elastic part
  HourglassModuli hourglass;  ///< of one_point.hpp

  explicit CellMaterial(const LawType& l, double coefficient)
      : law(l), elastic(l.elastic()), hourglass(HourglassModuli::of(l, coefficient)) {}
};

template <class Kinematics>
inline constexpr bool rotates = !std::is_same_v<Kinematics, SmallStrain>;

struct Unobserved {
  template <class... Args>
  FEMSPH_INLINE void point(const Args&...) const {}
  template <class T>
  FEMSPH_INLINE void hourglass(const T&) const {}
};

/// Calls body(q) for each point. Unrolled, what depends on q alone is known beforehand; but eight copies of a
/// law with history would not fit the processor's store of decoded instructions.
template <class LawType, int n, class Body>
FEMSPH_INLINE void each_point(Body&& body) {
  if constexpr (LawType::path_independent) {
#pragma GCC unroll 8
    for (int q = 0; q < n; ++q) body(q);
  } else {
#pragma GCC unroll 1
    for (int q = 0; q < n; ++q) body(q);
  }
}

/// 2^dim Gauss points.
struct FullElement {
  template <int dim>
  static constexpr int points = corners<dim>;
  static constexpr bool own_axes = false;  ///< works in the cell's own axes
  static constexpr bool equal_volumes =
      false;  ///< every material point stands for the same share of the cell

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

/// Normal strains at the Gauss points, each shear strain replaced by its average over the cell: the B-bar
/// idea of Hughes (Int. J. Numer. Meth. Engng 15, 1980) applied to the shear. Averages of a linear field are
/// exact on any cell: the patch test holds. "Shear" means something in the cell's own axes only, so the cell
/// is turned into them first.
struct SriElement {
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
