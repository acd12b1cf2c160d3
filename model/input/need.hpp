#pragma once
// Arguments of the functions of Fields (toml_fields.hpp). They are separate because the header of Fields
// includes the TOML library, and kernels include the laws, which declare how they read their keys.

#include "model/input/units.hpp"

namespace femsph {

class Fields;

enum class Need { required, optional };
enum class Sign { any, not_negative, positive };

}  // namespace femsph
