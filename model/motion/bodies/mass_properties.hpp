#pragma once
// Mass and centre of gravity of a body: those of the scene, and what a discretization makes of them.

#include <string>

#include "model/motion/bodies/discretization.hpp"

namespace femsph {

struct MassProperties {
  double mass = 0;  ///< kg
  Point centre{};   ///< m, at the start
};

/// rho V and the centroid of the body's shape, with the bars in it; of a rigid body its mass.
MassProperties mass_of(const Scene& scene, std::size_t body);
/// The sums over the points of a discretization.
MassProperties mass_of(const Discretization& discretization);

/// How far a discretization is off: its mass relative to the scene's, the centre relative to the diagonal of
/// the body's bounding box.
struct MassError {
  double mass = 0, centre = 0;
};
MassError mass_error(const Scene& scene, std::size_t body, const Discretization& discretization);
/// A sentence if one of them is over 1 %, else empty.
std::string mass_warning(const Scene& scene, std::size_t body, const Discretization& discretization);

/// "12.5 kg, centre (10, 20, 0) mm"
std::string to_text(const MassProperties& m, int dim);

}  // namespace femsph
