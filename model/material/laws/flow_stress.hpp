#pragma once
// The present limit of stress at a material point, for reading stress between material points.

#include <array>
#include <limits>

namespace femsph {

/// Limits of the Cauchy stress, Pa.
struct FlowStress {
  /// Limit of the von Mises stress.
  double yield = std::numeric_limits<double>::infinity();
  /// The same for tensile mean stress; it differs from `yield` only with tension = "sign".
  double tensile = std::numeric_limits<double>::infinity();
  /// Limit of the principal stresses.
  double strength = std::numeric_limits<double>::infinity();
};

/// The limits of a law that has none; laws with limits overload this. `history` and `cauchy` (Pa) are those
/// of the point, `share` is the ratio of Cauchy stress to the law's stress.
template <class LawType>
FlowStress flow_stress(const LawType&, const double*, double, const std::array<double, 6>&) {
  return {};
}

}  // namespace femsph
