#pragma once
// Stress read from a plastic body is brought back to the yield surface (step 6 of model/motion/README.md).

#include <array>
#include <optional>
#include <span>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

/// Bounds of the stress that are read at a place, Pa: each kept within the range of the points used.
struct StressBound {
  double yield;     ///< of the von Mises stress
  double tensile;   ///< the same where the mean stress is tension
  double strength;  ///< of the principal stresses
};
/// Empty if the law has no bound.
std::optional<StressBound> recovered_bound(std::span<const Weight> weights, const MaterialState& state);

/// The stress (xx yy zz xy yz zx) brought back to the yield surface: its deviator is scaled, in plane stress
/// the whole stress, so that the stress across stays 0; then the principal stresses are cut at the strength.
std::array<double, 6> limited(const std::array<double, 6>& stress, const StressBound& bound, Plane plane);

/// The state at one place, from the points behind the weights.
struct Recovered {
  std::array<double, 6> stress{}, strain{};
  double plastic = 0;  ///< within the range of the points used
};
Recovered recovered(std::span<const Weight> weights, const MaterialState& state, Plane plane);

}  // namespace femsph
