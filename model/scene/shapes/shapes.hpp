#pragma once
// The catalogue of shapes, and the reading of a shape from [bodies.NAME].

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
  /// Reads the keys of that shape. Null after a fault, and where the number of dimensions is needed and not
  /// known (dim = 0, after a fault in [model]). Relative paths of files start at `folder`.
  ShapePointer (*read)(Fields& body, int dim, const std::filesystem::path& folder);
};

/// Every shape that a scene can name.
const std::vector<ShapeEntry>& shapes();

/// Reads the key `shape` of [bodies.NAME] and the keys of that shape, as ShapeEntry::read does.
ShapePointer read_shape(Fields& body, int dim, const std::filesystem::path& folder);

}  // namespace femsph
