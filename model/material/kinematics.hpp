#pragma once
// From the displacement gradient H = du/dX of a material point to the first Piola-Kirchhoff stress P: what
// both solvers do between "gradient" and "divergence". Everything refers to the undeformed body (total
// Lagrangian), F = 1 + H. Three kinds of kinematics:
//
// SmallStrain: strain = sym H, P = sigma.
//
// FiniteRotation, for laws with a strain energy: F = R U. The law gets the strain U - 1 in the co-rotated
// frame and returns the Biot stress T, which is work conjugate to it; P = R T. This holds because the T of an
// isotropic law is coaxial with U. It is exact under any rigid rotation (e.g. Ogden, Non-Linear Elastic
// Deformations, 2.2 and 3.5).
//
// LargeStrain, for laws that carry their stress from step to step: the law gets the co-rotated rate of
// deformation times the step,
//   d = sym(dU Umid^-1),  Umid = (U_n + U_n+1)/2,
// and returns the co-rotated Kirchhoff stress tau = J R^T sigma R, which is work conjugate to d per
// undeformed volume. So the yield stress of a metal is a true stress (but for its small elastic change of
// volume), and its plastic strain a logarithmic one. The objective rate of tau is that of Green and Naghdi
// (Simo & Hughes, Computational Inelasticity, 8.3). P = R tau U^-1, so that P F^T = R tau R^T is symmetric:
// angular momentum is conserved whatever tau is.

#include <type_traits>

#include "model/material/law.hpp"
#include "model/material/laws/stretch.hpp"
#include "model/material/polar.hpp"

namespace femsph {

/// Kinematics whose strain increment is the difference of two strains, and whose stress is conjugate to the
/// strain.
struct AddedStrain {
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> increment(const Symmetric<T, dim>& before,
                                                   const Symmetric<T, dim>& now) {
    Symmetric<T, dim> d;
    for (int k = 0; k < symmetric_size<dim>; ++k) d[k] = now[k] - before[k];
    return d;
  }
  /// The stress that is work conjugate to the rate of `strain`, from the stress of the law.
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> conjugate(const Symmetric<T, dim>&,
                                                   const Symmetric<T, dim>& stress) {
    return stress;
  }
};

struct SmallStrain : AddedStrain {
  template <class T, int dim>
  struct Frame {};  // the axes do not turn

  template <class T, int dim>
  FEMSPH_INLINE static Frame<T, dim> strain(const Tensor<T, dim>& H, Symmetric<T, dim>& e) {
    for (int i = 0; i < dim; ++i) e(i, i) = H[i][i];
    for (int i = 0; i < dim; ++i)
      for (int j = i + 1; j < dim; ++j) e(i, j) = 0.5 * (H[i][j] + H[j][i]);
    return {};
  }

  template <class T, int dim>
  FEMSPH_INLINE static void piola(const Frame<T, dim>&, const Symmetric<T, dim>&, const Symmetric<T, dim>& s,
                                  Tensor<T, dim>& P) {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) P[i][j] = s(i, j);
  }
};

struct FiniteRotation : AddedStrain {
  template <class T, int dim>
  using Frame = Tensor<T, dim>;

  template <class T, int dim>
  FEMSPH_INLINE static Frame<T, dim> strain(const Tensor<T, dim>& H, Symmetric<T, dim>& e) {
    Tensor<T, dim> F = H;
    for (int i = 0; i < dim; ++i) F[i][i] += 1.0;
    if constexpr (dim == 3) {
      Polar<T> p;
      polar(F, p);
      e = p.strain;
      return p.R;
    }
    const Tensor<T, dim> R = polar_rotation<T, dim>(F);
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) {
        T s = R[0][i] * F[0][j];
        for (int k = 1; k < dim; ++k) s += R[k][i] * F[k][j];
        e(i, j) = i == j ? s - 1.0 : s;
      }
    return R;
  }

  template <class T, int dim>
  FEMSPH_INLINE static void piola(const Frame<T, dim>& R, const Symmetric<T, dim>&,
                                  const Symmetric<T, dim>& s, Tensor<T, dim>& P) {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        T p = R[i][0] * s(0, j);
        for (int k = 1; k < dim; ++k) p += R[i][k] * s(k, j);
        P[i][j] = p;
      }
  }
};

struct LargeStrain {
  /// R and U^-1; in space the polar decomposition yields both.
  template <class T, int dim>
  struct Frame : Tensor<T, dim> {
    Symmetric<T, dim> inverse;
  };

  template <class T, int dim>
  FEMSPH_INLINE static Frame<T, dim> strain(const Tensor<T, dim>& H, Symmetric<T, dim>& e) {
    Frame<T, dim> frame;
    if constexpr (dim == 3) {
      Tensor<T, dim> F = H;
      for (int i = 0; i < dim; ++i) F[i][i] += 1.0;
      Polar<T> p;
      polar(F, p);
      e = p.strain;
      static_cast<Tensor<T, dim>&>(frame) = p.R;
      frame.inverse = p.shrink;
      for (int i = 0; i < dim; ++i) frame.inverse[i] += 1.0;
    } else {
      static_cast<Tensor<T, dim>&>(frame) = FiniteRotation::strain<T, dim>(H, e);
      frame.inverse = inverse_stretch(e);
    }
    return frame;
  }

  /// By the midpoint rule: the error of a stretch by 1 + x in one step is x^3/12, that along a path of second
  /// order in the step.
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> increment(const Symmetric<T, dim>& before,
                                                   const Symmetric<T, dim>& now) {
    Symmetric<T, dim> d, middle;
    for (int k = 0; k < symmetric_size<dim>; ++k) {
      d[k] = now[k] - before[k];
      middle[k] = 0.5 * (now[k] + before[k]);
    }
    return symmetric_product(d, inverse_stretch(middle));
  }
  /// sym(U^-1 tau): the Biot stress.
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> conjugate(const Symmetric<T, dim>& strain,
                                                   const Symmetric<T, dim>& stress) {
    return symmetric_product(stress, inverse_stretch(strain));
  }

  template <class T, int dim>
  FEMSPH_INLINE static void piola(const Frame<T, dim>& R, const Symmetric<T, dim>&,
                                  const Symmetric<T, dim>& s, Tensor<T, dim>& P) {
    Tensor<T, dim> B;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        B[i][j] = s(i, 0) * R.inverse(0, j);
        for (int k = 1; k < dim; ++k) B[i][j] += s(i, k) * R.inverse(k, j);
      }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        T p = R[i][0] * B[0][j];
        for (int k = 1; k < dim; ++k) p += R[i][k] * B[k][j];
        P[i][j] = p;
      }
  }
};

/// The kinematics of a law in large motion.
template <class LawType>
using LargeMotion = std::conditional_t<LawType::path_independent, FiniteRotation, LargeStrain>;

/// Laws that reduce to another law in small motion; they are not compiled for SmallStrain.
template <class LawType>
concept LargeMotionOnly = requires {
  LawType::large_motion_only;
};

/// Laws whose stress follows from strain increments; that of the others follows from the total strain alone.
template <class LawType>
concept Incremental = requires(const LawType& law, Symmetric<double, 2>& s, double* history) {
  law.update(s, s, history);
};

/// Number of doubles that a material point keeps between steps: 0 if the stress follows from the strain, else
/// stress, strain and the history of the law.
template <class LawType, int dim>
inline constexpr int point_state_size =
    LawType::path_independent ? 0 : 2 * symmetric_size<dim> + LawType::template history_size<dim>;

/// Whether most steps read this entry of the law's history: all but the one that it names `seldom`.
template <class LawType>
constexpr bool often_read(int slot) {
  if constexpr (requires { LawType::seldom; }) return slot != LawType::seldom;
  return true;
}

/// The history of the law within that state; null if it has none.
template <class LawType, int dim, class T>
FEMSPH_INLINE T* history_of(T* state) {
  if constexpr (LawType::path_independent)
    return nullptr;
  else
    return state + 2 * symmetric_size<dim>;
}

/// The stress at a strain, of one material point (T = double) or of eight (Pack). Reads and advances `state`,
/// point_state_size<LawType, dim> values.
template <class LawType, class T, int dim, class Kinematics = SmallStrain>
FEMSPH_INLINE Symmetric<T, dim> advance_law(const LawType& law, const Symmetric<T, dim>& strain,
                                            [[maybe_unused]] T* state) {
  if constexpr (LawType::path_independent) {
    return law.stress(strain);
  } else {
    constexpr int n = symmetric_size<dim>;
    // Most of the memory that such a law reads and writes is its state, in an order that the processor does
    // not predict: prefetch the point after the next one. (A prefetch beyond the end of the array does
    // nothing.)
    constexpr int size = point_state_size<LawType, dim>;
    if constexpr (lanes_of<T> == lanes) {
      const T* ahead = state;
      asm("" : "+r"(ahead));  // avoids a compiler warning: the next line may point beyond the array
      ahead += 2 * size;
      for (int k = 0; k < size; ++k)
        if (often_read<LawType>(k - 2 * n)) __builtin_prefetch(ahead + k, 1);
    }
    Symmetric<T, dim> stress, before;
    for (int k = 0; k < n; ++k) {
      stress[k] = state[k];
      before[k] = state[n + k];
      state[n + k] = strain[k];
    }
    law.update(Kinematics::template increment<T, dim>(before, strain), stress, state + 2 * n);
    for (int k = 0; k < n; ++k) state[k] = stress[k];
    return stress;
  }
}

}  // namespace femsph
