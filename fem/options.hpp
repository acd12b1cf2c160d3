#pragma once
// What a user chooses of a FEM discretization.

#include <array>
#include <optional>

namespace femsph::fem {

enum class Element { full, sri, one_point, assumed_strain };

struct Options {
  Element element = Element::full;
  /// Cells along each axis of a box; bodies that come as a mesh ignore it.
  std::array<int, 3> divisions{0, 0, 0};
  /// `one_point`: Flanagan and Belytschko's stiffness control with this coefficient, in place of the physical
  /// stabilization.
  std::optional<double> hourglass;
  double distortion = 0;  ///< inner vertices moved at random by up to this share of the cell (patch tests)
  bool scalar_kernel =
      false;  ///< run the kernel one cell at a time: the reference of the SIMD form (tests, bench)
};

}  // namespace femsph::fem
