#pragma once
// What can be read at a point: names of components and units.

#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace femsph {

/// It belongs to the material (stress, strain, ..), not to the motion.
bool on_material(Quantity quantity);
/// One number at a point, which is not a component of anything.
bool is_scalar(Quantity quantity);
/// Names of the components of a quantity: x y z, or xx yy zz xy yz zx, or "equivalent" of a scalar, or 1 2 3
/// of principal stresses; z drops out of 2D vectors, yz zx out of 2D tensors.
std::vector<std::string> component_names(Quantity quantity, int dim);
std::string unit_of(Quantity quantity);  ///< SI

}  // namespace femsph
