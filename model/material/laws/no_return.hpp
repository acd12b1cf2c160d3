#pragma once
// Hypotheses about elastoplastic steps without return mapping (see Integration): the stress increment follows
// from the continuum elastoplastic tangent at the start of the step (eq. 8 of the paper),
//   D^ep = C - (C:a)(a:C) / (a:C:a + H),   a = dq/d sigma = 3 s / (2 q),   dp = a:C:d eps / (a:C:a + H),
// if f >= 0 there and the step is loading (a:C:d eps > 0), else from C. The stress is not returned to the
// yield surface.

#include "model/material/laws/linear_elastic.hpp"
#include "model/material/laws/point_stress.hpp"

namespace femsph::plastic {

/// `before`: the stress at the start of the step. `s`: on entry the trial stress before + C : increment, on
/// return the new stress.
template <class T, int dim>
FEMSPH_INLINE Flow<T> tangent_step(const LinearElastic& elastic, double hardening, const T& yield,
                                   const Symmetric<T, dim>& increment, const PointStress<T, dim>& before,
                                   PointStress<T, dim>& s) {
  const T q = von_mises(before), mean = before.mean();
  const T scale = select(q > 0.0, 1.5 / q, T{});
  PointStress<T, dim> a, Ca;
  for (int k = 0; k < symmetric_size<dim>; ++k)
    a.in[k] = scale * (k < dim ? before.in[k] - mean : before.in[k]);
  a.across = dim == 2 ? scale * (before.across - mean) : T{};
  Ca.in = elastic.stress(
      a.in);  // C of the plane; as a is deviatoric, C:a = 2G a in space and in plane strain
  Ca.across = T{};
  T stiffness = contract(Ca.in, a.in);
  if (dim == 2 && elastic.plane == Plane::strain) {
    for (int k = 0; k < symmetric_size<dim>; ++k) Ca.in[k] = 2 * elastic.mu * a.in[k];
    Ca.across = 2 * elastic.mu * a.across;
    stiffness = contract(Ca.in, a.in) + Ca.across * a.across;
  }
  const T drive = contract(Ca.in, increment);
  const auto plastic =
      (q >= yield * (1 - 1e-12)) &
      (drive > 0.0);  // a stress that is equal to the largest q up to round-off counts as reaching it
  const T dp = select(plastic, drive / (stiffness + hardening), T{});
  for (int k = 0; k < symmetric_size<dim>; ++k) s.in[k] -= dp * Ca.in[k];
  if constexpr (dim == 2) s.across -= dp * Ca.across;
  return {dp, dp * a.across};
}

}  // namespace femsph::plastic
