#pragma once
// What a user chooses of a FEM discretization.

#include <array>
#include <memory>
#include <optional>

namespace femsph::fem {

class CellLoop;
struct LoopInput;

enum class Element { full, sri, one_point, assumed_strain };

struct Options {
  Element element = Element::full;
  /// Cells along each axis of a box; bodies that come as a mesh ignore it.
  std::array<int, 3> divisions{0, 0, 0};
  /// `one_point`: Flanagan and Belytschko's stiffness control with this coefficient, in place of the physical
  /// stabilization.
  std::optional<double> hourglass;
  double distortion = 0;  ///< inner vertices moved at random by up to this share of the cell (patch tests)
  /// Makes the loop in place of make_loop: a test's own, such as one that takes the cells one at a time.
  std::unique_ptr<CellLoop> (*loop)(Element, const LoopInput&) = nullptr;
};

}  // namespace femsph::fem
