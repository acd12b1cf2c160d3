#pragma once
// The page of all keys of a scene (femsph help scene, docs/scene-keys.md). Each table of keys stands beside
// the code that reads it; the page collects them.

#include "model/input/keys.hpp"

namespace femsph {

const KeyPage& scene_page();

namespace scene_reader {

// reader.cpp
KeyTable top_keys();
KeyTable model_keys();
KeyTable time_keys();
// keys_bodies.cpp
KeyTable material_keys();
std::vector<KeyTable> law_tables();  ///< tables within [materials.NAME]
KeyTable body_keys();
// reader_outputs.cpp
KeyTable output_keys();
KeyTable probe_keys();
KeyTable section_keys();

}  // namespace scene_reader
}  // namespace femsph
