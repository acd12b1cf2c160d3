#pragma once
// Input of all laws: the elastic constants, the plane, and what a law may need to read its keys.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/input/keys.hpp"
#include "model/input/need.hpp"

namespace femsph {

/// Plane stress, plane strain, or three-dimensional (`none`).
enum class Plane { stress, strain, none };

/// The keys of every material.
struct ElasticConstants {
  double young, poisson, density;  ///< Pa, 1, kg/m^3
};

/// What a law may need to read its keys.
struct LawInput {
  ElasticConstants constants;
  std::optional<Plane> plane;  ///< empty where the key "plane" of the scene is faulty
};

/// The uniaxial yield stress of a law, for reinforcing bars.
struct BarYield {
  double yield = std::numeric_limits<double>::infinity();  ///< Pa
  double hardening = 0;                                    ///< H, Pa
  /// Why bars cannot have this law and what is expected, to follow the words: material "m". Empty if they
  /// can.
  std::string refusal = "";
};

}  // namespace femsph
