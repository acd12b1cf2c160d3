#pragma once
// Reads a scene file, and reports all its errors at once.

#include <string>

#include "model/input/faults.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// Throws InputError.
Scene read_scene(const std::string& file);
/// The same from a text; `file` is its name in messages, and relative paths of meshes start at its folder.
Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace femsph
