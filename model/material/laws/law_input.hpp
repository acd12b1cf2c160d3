#pragma once
// What every law shares: the elastic constants of a material, the plane in which it is used, and what the law
// is told when it reads its keys.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/input/keys.hpp"
#include "model/input/need.hpp"

namespace femsph {

/// How a two-dimensional scene stands for a body in space; `none` is three-dimensional.
enum class Plane { stress, strain, none };

/// Keys that every material has.
struct ElasticConstants {
  double young, poisson, density;  ///< Pa, 1, kg/m^3
};

/// What a law may need to know while it reads its keys.
struct LawInput {
  ElasticConstants constants;
  std::optional<Plane> plane;  ///< empty where the scene's plane is itself at fault
};

/// What a reinforcing bar takes of its material's law.
struct BarYield {
  double yield = std::numeric_limits<double>::infinity();  ///< Pa
  double hardening = 0;                                    ///< H, Pa
  /// Why bars cannot have this law and what was expected, after "material "m" "; empty if they can.
  std::string refusal = "";
};

}  // namespace femsph
