#pragma once
// What can be read at a point of a body. One file a quantity: its word, its unit, what it is, and how it
// follows from the state at the point; the list of them is in quantities.cpp.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "model/input/keys.hpp"
#include "model/numerics/tensor.hpp"

namespace femsph {

/// All that a quantity may be made of, at one point and in space. Tensors are xx yy zz xy yz zx.
struct StateAtPoint {
  Point displacement{}, velocity{};          ///< m, m/s
  std::array<double, 6> stress{}, strain{};  ///< Pa, 1
  double plastic = 0;                        ///< equivalent plastic strain
};

struct Quantity {
  /// vector: x y z; tensor: xx yy zz xy yz zx, of which a plane leaves yz and zx out; principal: 1 2 3, the
  /// largest first; scalar: one number that is no component of anything.
  enum class Components { vector, tensor, principal, scalar };
  using Values = std::array<double, 6>;

  const char *word, *about;
  const char* unit;  ///< SI
  Components components;
  bool on_material;  ///< it belongs to the material (stress, strain, ..), not to the motion
  bool of_stress;    ///< what a yield surface bounds
  /// The components in space; those that it has fewer than six of stand first.
  Values (*read)(const StateAtPoint&);
  const char* scalar_name = "equivalent";  ///< what a scalar's one component is called

  bool is_scalar() const { return components == Components::scalar; }
};

/// All of them, in the order of lists.
const std::vector<const Quantity*>& quantities();
/// Their words, for Fields::choice.
const std::vector<std::pair<std::string, const Quantity*>>& quantity_words();
/// What they say of themselves, for the page of keys and for lists.
std::vector<Entry> quantity_entries();
/// Throws std::logic_error if there is none of this word.
const Quantity* quantity_named(const std::string& word);

/// Names of its components: x y z, or xx yy zz xy yz zx, or 1 2 3, or that of a scalar; z drops out of
/// vectors in a plane, yz zx out of tensors.
std::vector<std::string> component_names(const Quantity& quantity, int dim);
/// Its values at a point, as many as it has components.
std::vector<double> values_at(const Quantity& quantity, const StateAtPoint& state, int dim);

}  // namespace femsph
