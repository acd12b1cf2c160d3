#pragma once
// From the table [bodies.NAME] to the shape of the body.

#include <filesystem>

#include "model/input/toml_fields.hpp"
#include "model/scene/shapes/shapes.hpp"

namespace femsph {

/// Reads the key `shape` and the keys that belong to that shape. Null after a fault, and when `dim` is 0
/// (unknown) and the shape needs it. Relative paths start at `folder`.
ShapePointer read_shape(Fields& body, int dim, const std::filesystem::path& folder);

}  // namespace femsph
