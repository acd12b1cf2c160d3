#pragma once
// How much stress a point can bear now: what a reading between points must not exceed.

#include <array>
#include <limits>

namespace femsph {

/// Pa, of the Cauchy stress.
struct FlowStress {
  /// Bound of von Mises' stress.
  double yield = std::numeric_limits<double>::infinity();
  /// The same where the mean stress is tension; other than `yield` by the sign rule only.
  double tensile = std::numeric_limits<double>::infinity();
  /// Bound of the principal stresses.
  double strength = std::numeric_limits<double>::infinity();
};

/// Of a law that states none. `history` is the point's; `cauchy` its own stress, and `share` that over the
/// law's stress.
template <class LawType>
FlowStress flow_stress(const LawType&, const double*, double, const std::array<double, 6>&) {
  return {};
}

}  // namespace femsph
