#pragma once

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/array.hpp"

namespace femsph {

/// Largest stable step of the leap-frog march, s: 2 / omega_max without viscosity.
/// omega_max^2 is the largest eigenvalue of M^-1 K, found by Lanczos iteration in the inner product of M with
/// the discretization's own operator; the Ritz value's residual is added, so the estimate errs to the safe
/// side. With viscosity (force taken at the lagged half-step velocity) the march is stable while 4 M - 2 dt C
/// - dt^2 K is positive definite. `springs` (flat, N/m) stand on the points to ground beside the
/// discretization's own stiffness. `inverse_mass` is flat, with 0 at supported components.
double critical_step(const Discretization& discretization, const AlignedVector<double>& inverse_mass,
                     std::span<const double> springs = {});

}  // namespace femsph
