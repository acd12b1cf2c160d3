#pragma once
// What all elements have in common. They are Q1 cells in total Lagrangian form. An element takes nodal
// coordinates X and displacements u of one cell (T = double) or of eight cells (T = Pack),
// x[corner * dim + component], and gives f = dE/du, the nodal forces that balance the stress. The force is
// the exact adjoint of the strain, so a law with an energy gives a force with an energy.
//
// An element is a struct that states
//   entry             its word, its name and its description (fem/options.hpp),
//   points<dim>       its material points a cell,
//   own_axes          whether it works in the axes of the cell: X, u and f are then turned into them,
//   equal_volumes     whether every material point stands for the same share of the cell,
//   force<Kinematics, T, dim>(material, X, u, state, f, observer),
//   Controlled        only if Options::hourglass has a meaning for it: the element under that control.
//
// An observer sees every material point (number, volume, frame, strain, stress, the law's history) and the
// hourglass energy; Unobserved costs nothing.

#include <type_traits>

#include "fem/elements/hourglass_moduli.hpp"
#include "fem/mesh/gauss.hpp"
#include "fem/options.hpp"
#include "model/material/kinematics.hpp"

namespace femsph::fem {

/// What an element needs to know of the material.
template <class LawType>
struct CellMaterial {
  LawType law;
  LinearElastic elastic;  ///< its elastic part
  HourglassModuli hourglass;

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

/// Calls body(q) for each of n points. The loop is unrolled for laws without history, so that the compiler
/// folds what depends on q alone; eight copies of a law with history would not fit the processor's cache of
/// decoded instructions.
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

}  // namespace femsph::fem
