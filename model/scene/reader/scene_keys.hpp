#pragma once
// The tables of a scene that say what acts on its bodies, as the page of keys has them. Each stands beside
// the code that reads it.

#include <vector>

#include "model/input/keys.hpp"

namespace femsph {

const KeyTable& supports_keys();
const KeyTable& loads_keys();
const KeyTable& initial_keys();
const KeyTable& initial_displacements_keys();
const KeyTable& contacts_keys();
const KeyTable& gravity_keys();
const KeyTable& damping_keys();
const KeyTable& settling_keys();
/// Those of effects that read their own table.
std::vector<KeyTable> effect_tables();

}  // namespace femsph
