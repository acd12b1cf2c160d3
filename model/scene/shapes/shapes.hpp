#pragma once
// The catalogue of shapes: what each says of itself, and how a scene's [bodies.NAME] becomes one.

#include <filesystem>
#include <memory>
#include <vector>

#include "model/input/keys.hpp"
#include "model/input/need.hpp"
#include "model/scene/shapes/shape.hpp"

namespace femsph {

using ShapePointer = std::shared_ptr<const Shape>;

struct ShapeEntry {
  Entry entry;
  /// Reads the keys of that shape. Null after a fault, and when `dim` is 0 (the plane of the scene is at
  /// fault) and the shape needs it. Relative paths start at `folder`.
  ShapePointer (*read)(Fields& body, int dim, const std::filesystem::path& folder);
};

/// Every shape a scene can name.
const std::vector<ShapeEntry>& shapes();

}  // namespace femsph
