#pragma once

#include "model/motion/effects/effect.hpp"

namespace femsph {

/// Fills MovingBody::held and MovingBody::driven from the supports and symmetry planes of the scene, and sets
/// the inverse mass of held components to 0. Throws InputError where two supports prescribe different motions
/// of one component.
void hold_components(Motion& motion);

}  // namespace femsph
