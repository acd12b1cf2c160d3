#pragma once
// The page of all keys of a scene, made of the tables that stand beside their readers.

#include "model/input/keys.hpp"

namespace femsph {

const KeyPage& scene_page();

namespace scene_reader {

/// Of several tables: the body that a table names, and a place of it.
Key body_key();
std::vector<Key> place_keys();

// reader.cpp
KeyTable top_keys();
KeyTable model_keys();
KeyTable time_keys();
// keys_bodies.cpp
KeyTable material_keys();
std::vector<KeyTable> law_tables();  ///< within the table of a material
KeyTable body_keys();
KeyTable symmetry_keys();
KeyTable bar_keys();
// keys_actions.cpp
KeyTable support_keys();
KeyTable support_history_keys();
KeyTable load_keys();
KeyTable load_history_keys();
KeyTable initial_keys();
KeyTable profile_keys();
KeyTable initial_displacement_keys();
KeyTable contact_keys();
KeyTable gravity_keys();
KeyTable damping_keys();
KeyTable settling_keys();
std::vector<KeyTable> effect_tables();  ///< of effects that read a table of their own
// reader_outputs.cpp
KeyTable output_keys();
KeyTable probe_keys();
KeyTable section_keys();

}  // namespace scene_reader
}  // namespace femsph
