#pragma once
// What a user chooses of a FEM discretization, and the list of elements to choose from.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace femsph::fem {

class CellLoop;
struct LoopInput;

/// What an element says of itself; it stands beside its kernel in fem/elements/.
struct ElementEntry {
  const char* word;   ///< of Options::element; the method is called "fem-" and this word
  const char* name;   ///< for messages: "full integration"
  const char* about;  ///< one line for `femsph list`
  /// Too stiff where the material keeps its volume (Poisson's ratio near 1/2, plastic flow).
  bool locks_in_volume = false;
  /// Its control of hourglass modes while Options::hourglass is not given: "physical stabilization". Null: it
  /// has no hourglass modes, and Options::hourglass does nothing.
  const char* hourglass_control = nullptr;
  std::array<int, 2> points = {};  ///< material points a cell in 2D and in 3D; elements() fills them in
};

/// All elements, in the order of `femsph list`.
const std::vector<ElementEntry>& elements();
/// Throws Refusal with "did you mean".
const ElementEntry& element_named(const std::string& word);

struct Options {
  std::string element = "full";  ///< the word of one of elements()
  /// Cells along each axis of a box; bodies that come as a mesh ignore it.
  std::array<int, 3> divisions{0, 0, 0};
  /// Elements with an hourglass control: the stiffness control of Flanagan and Belytschko (Int. J. Numer.
  /// Meth. Engng 17, 1981) with this coefficient, in place of the element's own.
  std::optional<double> hourglass;
  double distortion = 0;  ///< inner vertices moved at random by up to this share of the cell (patch tests)
  /// Makes the loop in place of make_loop; for tests, such as one that takes the cells one at a time.
  std::unique_ptr<CellLoop> (*loop)(const std::string& element, const LoopInput&) = nullptr;
};

}  // namespace femsph::fem
