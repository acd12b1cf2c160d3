#pragma once
// For the parts of the plastic law: a stress with its component normal to the plane, and its von Mises
// stress.

#include "model/numerics/tensor.hpp"

namespace femsph::plastic {

template <class T>
FEMSPH_INLINE T larger(const T& a, const T& b) {
  return select(a > b, a, b);
}

/// In 2D `across` is the stress normal to the plane (0 in plane stress); in 3D it is not used.
template <class T, int dim>
struct PointStress {
  Symmetric<T, dim> in;
  T across;

  FEMSPH_INLINE T mean() const {
    const T sum = trace(in);
    return (dim == 2 ? sum + across : sum) * (1.0 / 3.0);
  }
};

/// q^2 = 3/2 s:s
template <class T, int dim>
FEMSPH_INLINE T von_mises_square(const PointStress<T, dim>& s) {
  const T zz = [&] {
    if constexpr (dim == 2)
      return s.across;
    else
      return s.in[2];
  }();
  const T xy = s.in[0] - s.in[1], yz = s.in[1] - zz, zx = zz - s.in[0];
  T shear = s.in[dim] * s.in[dim];
  for (int k = dim + 1; k < symmetric_size<dim>; ++k) shear += s.in[k] * s.in[k];
  return 0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear;
}

template <class T, int dim>
FEMSPH_INLINE T von_mises(const PointStress<T, dim>& s) {
  return square_root(von_mises_square(s));
}

/// Plastic strain increments of a step.
template <class T>
struct Flow {
  T equivalent;  ///< increment of p
  T across;      ///< increment of the plastic strain normal to the plane; plane stress only
};

}  // namespace femsph::plastic
