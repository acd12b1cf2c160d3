#pragma once

#include "model/motion/effects/effect.hpp"

namespace femsph {

/// Fills MovingBody::held and ::driven by the scene's supports and symmetry planes, and sets the inverse mass
/// of held components to 0. Throws InputError where two supports want different motions of a component.
void hold_components(Motion& motion);

}  // namespace femsph
