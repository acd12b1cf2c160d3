#pragma once

#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/array.hpp"

namespace femsph {

/// The critical time step of the leap-frog, s. Without viscosity it is 2 / omega_max, with omega_max^2 the
/// largest eigenvalue of M^-1 K. This is found by Lanczos iteration with the stiffness operator of the
/// discretization; the residual of the Ritz value is added to it, so that the estimate is on the safe side.
/// With viscosity, whose force is taken at the velocity half a step before, the leap-frog is stable as long
/// as 4 M - 2 dt C - dt^2 K is positive definite. `springs` (N/m, flat) are springs to ground on the points,
/// added to the stiffness. `inverse_mass` (1/kg, flat) is 0 for held components.
double critical_step(const Discretization& discretization, const AlignedVector<double>& inverse_mass,
                     std::span<const double> springs = {});

}  // namespace femsph
