#pragma once
// The words in which Fields (toml_fields.hpp) is asked for a key, apart from Fields itself, whose header
// brings the TOML library: kernels include the laws, and laws say which keys they read.

#include "model/input/units.hpp"

namespace femsph {

class Fields;

enum class Need { required, optional };
enum class Sign { any, not_negative, positive };

}  // namespace femsph
