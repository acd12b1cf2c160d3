#pragma once
// What the reader of scenes finds wrong with a text.

#include <string>

#include "model/scene/reader/reader.hpp"

namespace femsph::test {

/// Scene files for the tests.
inline const std::string scenes_folder = FEMSPH_SOURCE_DIR "/tests/scenes/";

/// The whole message, with places; empty if the scene is read.
inline std::string message_of(const std::string& text, const std::string& file = "scene.toml") {
  try {
    parse_scene(text, file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// The faults without places, with `between` from one to the next; empty if the scene is read.
inline std::string faults_of(const std::string& text, const std::string& between,
                             const std::string& file = "scene.toml") {
  try {
    parse_scene(text, file);
  } catch (const InputError& e) {
    std::string all;
    for (const Fault& fault : e.faults()) all += (all.empty() ? "" : between) + fault.text;
    return all;
  }
  return "";
}

}  // namespace femsph::test
