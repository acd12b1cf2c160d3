#pragma once
// The FEM room's door: options in, discretization out. Only this room includes deal.II, and this header does not show it.

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/motion/discretization.hpp"

namespace femsph::fem {

enum class Element { full, sri, one_point, assumed_strain };

struct Options {
  Element element = Element::full;
  /// Cells along each axis of a box; bodies that come as a mesh ignore it.
  std::array<int, 3> divisions{0, 0, 0};
  /// `one_point`: Flanagan and Belytschko's stiffness control with this coefficient, in place of the physical stabilization.
  std::optional<double> hourglass;
  double distortion = 0;       ///< inner vertices moved at random by up to this share of the cell (patch tests)
  bool scalar_kernel = false;  ///< run the kernel one cell at a time: the reference of the SIMD form (tests, bench)
};

/// Throws std::runtime_error with one sentence if the body cannot be discretized so.
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options);

/// The same discretization through deal.II's FEValues, cell by cell: slow, and the oracle of the fast loop.
/// Only `full`, small strain.
std::unique_ptr<Discretization> discretize_oracle(const Scene& scene, std::size_t body, const Options& options);

/// Converged static solution of a linear elastic scene with one body of straight sides, in small motion and with supports at rest: polynomial degree `degree` on `divisions` cells, solved directly.
/// Returns the value of each probe (component-wise, 3 for displacement, 6 for stress and strain) by its name.
struct StaticLimit {
  std::map<std::string, std::vector<double>> probes;
  std::map<std::string, std::vector<std::vector<double>>> sections;  ///< per section, per point
};
StaticLimit static_limit(const Scene& scene, const std::array<int, 3>& divisions, int degree);

/// The version of deal.II this program is built with.
std::string deal_ii_version();

}  // namespace femsph::fem
