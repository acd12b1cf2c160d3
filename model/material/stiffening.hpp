#pragma once
// How much stiffer a material point is than in the undeformed body, for the time step
// (motion/march_step.cpp).

#include <concepts>
#include <limits>

#include "model/material/law.hpp"

namespace femsph {

/// Laws whose tangent dP/dF becomes stiffer with the deformation. stiffening(g, J) is a bound of the ratio of
/// the largest stiffness to the undeformed one, with 1/sqrt(g) the smallest principal stretch and J the ratio
/// of volumes (in 2D of areas).
template <class LawType>
concept Stiffens = requires(const LawType& law, double x) {
  { law.stiffening(x, x) } -> std::same_as<double>;
};

/// An upper bound of the largest eigenvalue of a symmetric matrix: exact in the plane; in space mean + 2
/// sqrt(J2 / 3), which is exact if the two smaller eigenvalues are equal (uniaxial compression).
template <class T, int dim>
FEMSPH_INLINE T largest_eigenvalue_bound(const Symmetric<T, dim>& B) {
  if constexpr (dim == 2) {
    const T half = 0.5 * (B[0] - B[1]);
    return 0.5 * (B[0] + B[1]) + square_root(half * half + B[2] * B[2]);
  } else {
    const T mean = (1.0 / 3) * trace(B), a = B[0] - mean, b = B[1] - mean, c = B[2] - mean;
    const T J2 = 0.5 * (a * a + b * b + c * c) + B[3] * B[3] + B[4] * B[4] + B[5] * B[5];
    return mean + 2.0 * square_root((1.0 / 3) * J2);
  }
}

/// The stiffening of a point with inverse deformation gradient dX/dx and J; infinite where J <= 0.
template <class T, int dim, Stiffens LawType>
FEMSPH_INLINE T stiffening(const LawType& law, const Tensor<T, dim>& inverse, const T& J) {
  Symmetric<T, dim> B;  // F^-1 F^-T, with eigenvalues 1 / stretch^2
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      T s = inverse[i][0] * inverse[j][0];
      for (int k = 1; k < dim; ++k) s += inverse[i][k] * inverse[j][k];
      B(i, j) = s;
    }
  return select(J > 0.0, law.stiffening(largest_eigenvalue_bound(B), J),
                broadcast<T>(std::numeric_limits<double>::infinity()));
}

}  // namespace femsph
