#pragma once
// How a scene is discretized: a method and a resolution.

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "fem/options.hpp"
#include "sph/options.hpp"

namespace femsph::compare {

/// A discretization by its name in tables: "fem-" and the word of an element, or "sph-" and that of a variant
/// of an SPH formulation.
struct Method {
  std::string name;
  std::variant<fem::Options, sph::Options> options;
  std::string about = {};  ///< one line for `femsph list`
  bool is_fem() const { return options.index() == 0; }
};

/// All methods, in the order of tables.
const std::vector<Method>& methods();
/// Throws std::runtime_error with "did you mean".
Method method_named(const std::string& name);

/// How fine: a spacing (FEM: the edge of a square cell; the divisions are the sides' lengths over it,
/// rounded), or divisions along each axis, which for SPH must mean one spacing.
struct Resolution {
  double spacing = 0;  ///< m
  std::array<int, 3> divisions{0, 0, 0};
};

}  // namespace femsph::compare
