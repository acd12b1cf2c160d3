#pragma once
// Reads a scene file. Everything wrong with it is found in one go.

#include <string>

#include "model/input/faults.hpp"
#include "model/scene/scene.hpp"

namespace femsph {

/// Throws InputError.
Scene read_scene(const std::string& file);
/// The same from memory; `file` names it in messages, and relative mesh paths start at its folder.
Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace femsph
