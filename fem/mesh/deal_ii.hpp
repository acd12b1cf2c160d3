#pragma once
// The functions of the module that links deal.II (fem/limit/).

#include <array>
#include <memory>

#include "fem/options.hpp"
#include "fem/static_limit.hpp"
#include "model/motion/bodies/discretization.hpp"
#include "model/numerics/module.hpp"

namespace femsph::fem {

struct DealIi : ModuleHead {
  std::unique_ptr<Discretization> (*oracle)(const Scene&, std::size_t body, const Options&);
  StaticLimit (*static_limit)(const Scene&, const std::array<int, 3>& divisions, int degree);
  /// The grid of a body as deal.II makes it, its inner vertices moved at random if `distortion` > 0
  /// (mesh.hpp).
  CellMesh (*grid)(const Shape&, const std::array<int, 3>& divisions, double distortion);
};

/// Opened at the first call. Throws std::runtime_error if the module is missing or of another build.
const DealIi& deal_ii();

}  // namespace femsph::fem
