#pragma once
// Stress that is read in a plastic body is returned to the yield surface (step 6 of "Reading stress and
// strain" in model/results/README.md).

#include <array>
#include <optional>
#include <span>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

/// Limits of the stress at a place, Pa, each within the range of the points that are used.
struct StressBound {
  double yield;     ///< of the von Mises stress
  double tensile;   ///< the same where the mean stress is tension
  double strength;  ///< of the principal stresses
};
/// Empty if the law has no limit.
std::optional<StressBound> recovered_bound(std::span<const Weight> weights, const MaterialState& state);

/// Returns the stress (xx yy zz xy yz zx, Pa) to the yield surface: its deviator is scaled (in plane stress
/// the whole stress, so that the normal stress remains 0), and then the principal stresses are limited to the
/// strength.
std::array<double, 6> limited(const std::array<double, 6>& stress, const StressBound& bound, Plane plane);

/// The state at a place, from weights of material points.
struct Recovered {
  std::array<double, 6> stress{}, strain{};
  double plastic = 0;  ///< equivalent plastic strain, within the range of the points that are used
};
Recovered recovered(std::span<const Weight> weights, const MaterialState& state, Plane plane);

}  // namespace femsph
