#pragma once
// From the displacement gradient of a material point to its first Piola-Kirchhoff stress: the piece between
// "gradient" and "divergence" that both solvers share. Total Lagrangian; three kinds of motion:
//   SmallStrain      strain = sym H, P = sigma
//   FiniteRotation   F = I + H = R U; the law sees U - I in the co-rotated frame and gives its work conjugate
//   T (Biot stress); P = R T.
//                    Exact under any rigid rotation (see e.g. Ogden, Non-Linear Elastic Deformations, 2.2
//                    and 3.5). For laws with an energy, whose T is coaxial with U.
//   LargeStrain      for laws that carry their stress from step to step: they see the co-rotated rate of
//   deformation, times the step,
//                      d = sym(dU Umid^-1),  Umid = (U_n + U_n+1)/2,
//                    and what they give is the co-rotated Kirchhoff stress tau = J R^T sigma R, which works
//                    on d per undeformed volume. So a metal's yield stress is (to its small elastic strain of
//                    volume) a true stress, and its stretches add up as logarithms. The rate of tau is the
//                    Green-Naghdi rate (Simo & Hughes, Computational Inelasticity, 8.3). P = R tau U^-1, so
//                    that P F^T = R tau R^T is symmetric: angular momentum is kept whatever tau.

#include <type_traits>

#include "model/material/law.hpp"
#include "model/material/laws/stretch.hpp"

namespace femsph {

/// The law's strain is a difference of two: increments add up, and the law's stress is conjugate to it.
struct AddedStrain {
  template <class T, int dim>
  FEMSPH_INLINE static Symmetric<T, dim> increment(const Symmetric<T, dim>& before,
                                                   const Symmetric<T, dim>& now) {
    Symmetric<T, dim> d;
    for (int k = 0; k < symmetric_size<dim>; ++k) d[k] = now[k] - before[k];
    return d;
  }
  /// The stress that works on the rate of `strain`, of the law's stress.
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

/// F = R U in space.
template <class T>
struct Polar {
  Tensor<T, 3> R;
  Symmetric<T, 3> strain, shrink;  ///< U - 1 and U^-1 - 1
};

/// F^T F - 1
template <class T>
FEMSPH_INLINE Symmetric<T, 3> green(const Tensor<T, 3>& F) {
  Symmetric<T, 3> G;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const T g = F[0][i] * F[0][j] + F[1][i] * F[1][j] + F[2][i] * F[2][j];
      G(i, j) = i == j ? g - 1.0 : g;
    }
  return G;
}

/// The decomposition of F by the series of U^-1 = (1 + G)^-1/2 to G^n, G = F^T F - 1: leaves less than
/// |G|^(n+1)/2. By Cayley and Hamilton's G^3 = I1 G^2 - I2 G + I3 every power is a sum of 1, G and G^2, so
/// that a term takes three multiplications.
template <int n, class T>
FEMSPH_INLINE void polar_series(const Tensor<T, 3>& F, const Symmetric<T, 3>& G, Polar<T>& p) {
  constexpr double c[11] = {
      0,
      -1.0 / 2,
      3.0 / 8,
      -5.0 / 16,
      35.0 / 128,
      -63.0 / 256,
      231.0 / 1024,
      -429.0 / 2048,
      6435.0 / 32768,
      -12155.0 / 65536,
      46189.0 / 262144};
  const T xy = G[0] * G[1] - G[3] * G[3], yz = G[1] * G[2] - G[4] * G[4], zx = G[2] * G[0] - G[5] * G[5];
  const T I1 = trace(G), I2 = xy + yz + zx,
          I3 = G[0] * yz + G[3] * (G[4] * G[5] - G[3] * G[2]) + G[5] * (G[3] * G[4] - G[1] * G[5]);
  T a = broadcast<T>(c[n - 2]), b = broadcast<T>(c[n - 1]), g = broadcast<T>(c[n]);  // a + b G + g G^2
#pragma GCC unroll 8
  for (int k = n - 3; k >= 0; --k) {
    const T above = b;
    b = a - g * I2;
    a = c[k] + g * I3;
    g = above + g * I1;
  }
  const T sa = a + g * I3, sb = 1.0 + a + b - g * I2, sg = b + g + g * I1;  // U - 1 = (1 + G) U^-1 - 1
  Symmetric<T, 3> G2;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) G2(i, j) = G(i, 0) * G(0, j) + G(i, 1) * G(1, j) + G(i, 2) * G(2, j);
  for (int k = 0; k < 6; ++k) {
    p.shrink[k] = b * G[k] + g * G2[k];
    p.strain[k] = sb * G[k] + sg * G2[k];
  }
  for (int k = 0; k < 3; ++k) p.shrink[k] += a, p.strain[k] += sa;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      p.R[i][j] = F[i][j] + (F[i][0] * p.shrink(0, j) + F[i][1] * p.shrink(1, j) + F[i][2] * p.shrink(2, j));
}

/// Stretches far from 1, where few points are: Newton's X <- (X + X^-T)/2 (Higham 1986) until |G| < 1/2, then
/// the series until one leaves nothing.
template <class T>
[[gnu::noinline]] void polar_far(const Tensor<T, 3>& F, Polar<T>& p) {
  p.R = F;
  for (int turn = 0; turn < 20; ++turn) {
    const Symmetric<T, 3> G = green(p.R);
    const T size = contract(G, G);
    const Tensor<T, 3> X = p.R;
    if (any(size > 0.25)) {
      Tensor<T, 3> C;  // cofactors: X^-T = C / det X
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
          C[i][j] = X[i1][j1] * X[i2][j2] - X[i1][j2] * X[i2][j1];
        }
      const T r = 0.5 / (X[0][0] * C[0][0] + X[0][1] * C[0][1] + X[0][2] * C[0][2]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) p.R[i][j] = 0.5 * X[i][j] + C[i][j] * r;
      continue;
    }
    polar_series<10>(X, G, p);
    if (!any(size > 1.5e-3)) break;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const T u = p.R[0][i] * F[0][j] + p.R[1][i] * F[1][j] + p.R[2][i] * F[2][j];
      p.strain(i, j) = i == j ? u - 1.0 : u;
    }
  p.shrink = inverse_stretch(p.strain);
  for (int k = 0; k < 3; ++k) p.shrink[k] -= 1.0;
}

/// Ends when the error is below 1e-16 in every lane: the series to G^4 for stretches up to 0.04 %, to G^10 up
/// to 1.9 %.
template <class T>
FEMSPH_INLINE void polar(const Tensor<T, 3>& F, Polar<T>& p) {
  const Symmetric<T, 3> G = green(F);
  const T size = contract(G, G);  // |G|^2
  if (any(size > 1.5e-3)) {
    const Tensor<T, 3> from = F;  // copies: what the kernel holds in registers must not have an address
    Polar<T> far;
    polar_far(from, far);
    p = far;
  } else if (any(size > 6.5e-7)) {
    polar_series<10>(F, G, p);
  } else {
    polar_series<4>(F, G, p);
  }
}

/// Rotation of the polar decomposition F = R U. 2D: closed form. 3D: see above.
template <class T, int dim>
FEMSPH_INLINE Tensor<T, dim> polar_rotation(const Tensor<T, dim>& F) {
  if constexpr (dim == 2) {
    Tensor<T, dim> R;
    const T c = F[0][0] + F[1][1], s = F[1][0] - F[0][1];
    const T r = 1.0 / square_root(c * c + s * s);
    R[0][0] = R[1][1] = c * r;
    R[1][0] = s * r;
    R[0][1] = -s * r;
    return R;
  } else {
    Polar<T> p;
    polar(F, p);
    return p.R;
  }
}

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
  /// The rotation, and U^-1, which the decomposition in space gives by the way.
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

  /// The midpoint rule: over a stretch by 1 + x in one step it errs by x^3/12, over a path by the square of
  /// the step.
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

/// The kinematics of large motion that a law is made for.
template <class LawType>
using LargeMotion = std::conditional_t<LawType::path_independent, FiniteRotation, LargeStrain>;

/// Laws that are another one in small strain; no kernel is made for them there.
template <class LawType>
concept LargeMotionOnly = requires {
  LawType::large_motion_only;
};

/// Laws that carry their stress by increments of strain; the others know it from the whole strain alone.
template <class LawType>
concept Incremental = requires(const LawType& law, Symmetric<double, 2>& s, double* history) {
  law.update(s, s, history);
};

/// Doubles of state that a material point of this law keeps between steps: nothing if the stress follows from
/// the strain, else stress, strain and the law's own history.
template <class LawType, int dim>
inline constexpr int point_state_size =
    LawType::path_independent ? 0 : 2 * symmetric_size<dim> + LawType::template history_size<dim>;

/// Whether most steps read a slot of the law's history: all but the one that it calls seldom.
template <class LawType>
constexpr bool often_read(int slot) {
  if constexpr (requires { LawType::seldom; }) return slot != LawType::seldom;
  return true;
}

/// Where the law's own history stands in that state.
template <class LawType, int dim, class T>
FEMSPH_INLINE T* history_of(T* state) {
  if constexpr (LawType::path_independent)
    return nullptr;
  else
    return state + 2 * symmetric_size<dim>;
}

/// strain -> stress of one material point (or of eight): reads and advances `state`
/// (point_state_size<LawType, dim> values).
template <class LawType, class T, int dim, class Kinematics = SmallStrain>
FEMSPH_INLINE Symmetric<T, dim> advance_law(const LawType& law, const Symmetric<T, dim>& strain,
                                            [[maybe_unused]] T* state) {
  if constexpr (LawType::path_independent) {
    return law.stress(strain);
  } else {
    constexpr int n = symmetric_size<dim>;
    // The state is the bulk of what such a law reads and writes, and its lines come in bursts that the
    // processor does not foresee: ask for the point after the next (beyond the end of the array a prefetch
    // does nothing).
    constexpr int size = point_state_size<LawType, dim>;
    if constexpr (lanes_of<T> == lanes) {
      const T* ahead = state;
      asm(""
          : "+r"(ahead));  // hides from the compiler's warnings that the next line may point beyond the array
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
