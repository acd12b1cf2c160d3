#pragma once
// From the displacement gradient of a material point to its first Piola-Kirchhoff stress: the piece between "gradient" and
// "divergence" that both solvers share. Total Lagrangian; three kinds of motion:
//   SmallStrain      strain = sym H, P = sigma
//   FiniteRotation   F = I + H = R U; the law sees U - I in the co-rotated frame and gives its work conjugate T (Biot stress); P = R T.
//                    Exact under any rigid rotation (see e.g. Ogden, Non-Linear Elastic Deformations, 2.2 and 3.5). For laws with an
//                    energy, whose T is coaxial with U.
//   LargeStrain      for laws that carry their stress from step to step: they see the co-rotated rate of deformation, times the step,
//                      d = sym(dU Umid^-1),  Umid = (U_n + U_n+1)/2,
//                    and what they give is the co-rotated Kirchhoff stress tau = J R^T sigma R, which works on d per undeformed volume. So
//                    a metal's yield stress is (to its small elastic strain of volume) a true stress, and its stretches add up as
//                    logarithms. The rate of tau is the Green-Naghdi rate (Simo & Hughes, Computational Inelasticity, 8.3).
//                    P = R tau U^-1, so that P F^T = R tau R^T is symmetric: angular momentum is kept whatever tau.

#include <type_traits>

#include "model/material/law.hpp"
#include "model/material/stretch.hpp"

namespace femsph {

/// The law's strain is a difference of two: increments add up, and the law's stress is conjugate to it.
struct AddedStrain {
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> increment(const Symmetric<T, dim>& before, const Symmetric<T, dim>& now) {
    Symmetric<T, dim> d;
    for (int k = 0; k < symmetric_size<dim>; ++k) d[k] = now[k] - before[k];
    return d;
  }
  /// The stress that works on the rate of `strain`, of the law's stress.
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> conjugate(const Symmetric<T, dim>&, const Symmetric<T, dim>& stress) { return stress; }
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
  FEMSPH_INLINE static void piola(const Frame<T, dim>&, const Symmetric<T, dim>&, const Symmetric<T, dim>& s, Tensor<T, dim>& P) {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) P[i][j] = s(i, j);
  }
};

/// X <- (X + X^-T)/2. Out of the kernels' way: few points are stretched so far.
template <class T>
[[gnu::noinline]] Tensor<T, 3> newton_polar_turn(Tensor<T, 3> R) {
  Tensor<T, 3> C;  // cofactors: X^-T = C / det X
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      C[i][j] = R[i1][j1] * R[i2][j2] - R[i1][j2] * R[i2][j1];
    }
  const T r = 0.5 / (R[0][0] * C[0][0] + R[0][1] * C[0][1] + R[0][2] * C[0][2]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R[i][j] = 0.5 * R[i][j] + C[i][j] * r;
  return R;
}

/// Rotation of the polar decomposition F = R U. 2D: closed form. 3D: with G = X^T X - 1 the turns
///   X <- X (1 - G/2 + 3/8 G^2 - 5/16 G^3 + 35/128 G^4)    leave 63/256 |G|^5, no division (the series of (1 + G)^-1/2; Higham,
///                                                         Functions of Matrices, 8.3),
///   X <- (X + X^-T)/2                                     Newton's, for stretches far from 1 (Higham 1986).
/// They end when the last one's error is below 1e-16 in every lane: one turn for stretches up to 0.04 %, two up to 13 %.
template <class T, int dim>
FEMSPH_INLINE Tensor<T, dim> polar_rotation(const Tensor<T, dim>& F) {
  Tensor<T, dim> R;
  if constexpr (dim == 2) {
    const T c = F[0][0] + F[1][1], s = F[1][0] - F[0][1];
    const T r = 1.0 / square_root(c * c + s * s);
    R[0][0] = R[1][1] = c * r;
    R[1][0] = s * r;
    R[0][1] = -s * r;
  } else {
    R = F;
    for (int turn = 0; turn < 20; ++turn) {
      Symmetric<T, 3> G;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
          const T g = R[0][i] * R[0][j] + R[1][i] * R[1][j] + R[2][i] * R[2][j];
          G(i, j) = i == j ? g - 1.0 : g;
        }
      const T size = contract(G, G);  // |G|^2
      if (any(size > 0.25)) {
        R = newton_polar_turn(R);
        continue;
      }
      const auto times = [](const Symmetric<T, 3>& A, const Symmetric<T, 3>& B) __attribute__((always_inline)) {  // of two powers of G
        Symmetric<T, 3> C;
        for (int i = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j) C(i, j) = A(i, 0) * B(0, j) + A(i, 1) * B(1, j) + A(i, 2) * B(2, j);
        return C;
      };
      const Symmetric<T, 3> G2 = times(G, G);
      Symmetric<T, 3> S;
      for (int k = 0; k < 6; ++k) S[k] = 35.0 / 128 * G2[k] - 5.0 / 16 * G[k];
      S = times(G2, S);
      for (int k = 0; k < 6; ++k) S[k] += 3.0 / 8 * G2[k] - 0.5 * G[k];
      for (int i = 0; i < 3; ++i) {
        const T x = R[i][0], y = R[i][1], z = R[i][2];
        for (int j = 0; j < 3; ++j) R[i][j] += x * S(0, j) + y * S(1, j) + z * S(2, j);
      }
      if (!any(size > 6.5e-7)) break;
    }
  }
  return R;
}

struct FiniteRotation : AddedStrain {
  template <class T, int dim>
  using Frame = Tensor<T, dim>;

  template <class T, int dim>
  FEMSPH_INLINE static Frame<T, dim> strain(const Tensor<T, dim>& H, Symmetric<T, dim>& e) {
    Tensor<T, dim> F = H;
    for (int i = 0; i < dim; ++i) F[i][i] += 1.0;
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
  FEMSPH_INLINE static void piola(const Frame<T, dim>& R, const Symmetric<T, dim>&, const Symmetric<T, dim>& s, Tensor<T, dim>& P) {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        T p = R[i][0] * s(0, j);
        for (int k = 1; k < dim; ++k) p += R[i][k] * s(k, j);
        P[i][j] = p;
      }
  }
};

struct LargeStrain {
  template <class T, int dim>
  using Frame = Tensor<T, dim>;

  template <class T, int dim>
  FEMSPH_INLINE static Frame<T, dim> strain(const Tensor<T, dim>& H, Symmetric<T, dim>& e) { return FiniteRotation::strain<T, dim>(H, e); }

  /// The midpoint rule: over a stretch by 1 + x in one step it errs by x^3/12, over a path by the square of the step.
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> increment(const Symmetric<T, dim>& before, const Symmetric<T, dim>& now) {
    Symmetric<T, dim> d, middle;
    for (int k = 0; k < symmetric_size<dim>; ++k) {
      d[k] = now[k] - before[k];
      middle[k] = 0.5 * (now[k] + before[k]);
    }
    return symmetric_product(d, inverse_stretch(middle));
  }
  /// sym(U^-1 tau): the Biot stress.
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> conjugate(const Symmetric<T, dim>& strain, const Symmetric<T, dim>& stress) {
    return symmetric_product(stress, inverse_stretch(strain));
  }

  template <class T, int dim>
  FEMSPH_INLINE static void piola(const Frame<T, dim>& R, const Symmetric<T, dim>& e, const Symmetric<T, dim>& s, Tensor<T, dim>& P) {
    const Symmetric<T, dim> inverse = inverse_stretch(e);
    Tensor<T, dim> B;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        B[i][j] = s(i, 0) * inverse(0, j);
        for (int k = 1; k < dim; ++k) B[i][j] += s(i, k) * inverse(k, j);
      }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        T p = R[i][0] * B[0][j];
        for (int k = 1; k < dim; ++k) p += R[i][k] * B[k][j];
        P[i][j] = p;
      }
  }
};

/// The kinematics of large motion that a law is made for.
template <class LawType>
using LargeMotion = std::conditional_t<LawType::path_independent, FiniteRotation, LargeStrain>;

/// Laws that are another one in small strain; no kernel is made for them there.
template <class LawType>
concept LargeMotionOnly = requires { LawType::large_motion_only; };

/// Doubles of state that a material point of this law keeps between steps: nothing if the stress follows from the strain,
/// else stress, strain and the law's own history.
template <class LawType, int dim>
inline constexpr int point_state_size =
    LawType::path_independent ? 0 : 2 * symmetric_size<dim> + LawType::template history_size<dim>;

/// Where the law's own history stands in that state.
template <class LawType, int dim, class T>
FEMSPH_INLINE T* history_of(T* state) {
  if constexpr (LawType::path_independent) return nullptr;
  else return state + 2 * symmetric_size<dim>;
}

/// strain -> stress of one material point (or of eight): reads and advances `state` (point_state_size<LawType, dim> values).
template <class LawType, class T, int dim, class Kinematics = SmallStrain>
FEMSPH_INLINE Symmetric<T, dim> advance_law(const LawType& law, const Symmetric<T, dim>& strain, [[maybe_unused]] T* state) {
  if constexpr (LawType::path_independent) {
    return law.stress(strain);
  } else {
    constexpr int n = symmetric_size<dim>;
    // The state is the bulk of what such a law reads and writes, and its lines come in bursts that the processor does not foresee:
    // ask for the point after the next (beyond the end of the array a prefetch does nothing).
    constexpr int size = point_state_size<LawType, dim>;
    if constexpr (lanes_of<T> == lanes) {
      const T* ahead = state;
      asm("" : "+r"(ahead));  // hides from the compiler's warnings that the next line may point beyond the array
      ahead += 2 * size;
      for (int k = 0; k < size; ++k) __builtin_prefetch(ahead + k, 1);
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
