#pragma once
// Mass and centre of gravity of a body, in the scene and in a discretization.

#include <string>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

struct MassProperties {
  double mass = 0;  ///< kg
  Point centre{};   ///< m, at the start
};

/// Those of the scene: density times volume, and the bars; for a rigid body its mass.
MassProperties mass_of(const Scene& scene, std::size_t body);
/// Those of a discretization: sums over its points.
MassProperties mass_of(const Discretization& discretization);

/// The error of a discretization: of the mass relative to that of the scene, of the centre relative to the
/// diagonal of the bounding box.
struct MassError {
  double mass = 0, centre = 0;
};
MassError mass_error(const Scene& scene, std::size_t body, const Discretization& discretization);
/// A warning if one of them exceeds 1 %, else empty.
std::string mass_warning(const Scene& scene, std::size_t body, const Discretization& discretization);

/// "12.5 kg, centre (10, 20, 0) mm"
std::string to_text(const MassProperties& m, int dim);

}  // namespace femsph
