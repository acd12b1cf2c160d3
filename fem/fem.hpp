#pragma once
// The FEM room's door: options in, discretization out. What uses deal.II (the oracle, the static limit, the
// distortion of meshes) is in a module that is opened at the first call (mesh/deal_ii.hpp).

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/options.hpp"
#include "fem/static_limit.hpp"
#include "model/motion/bodies/discretization.hpp"

namespace femsph::fem {

/// Throws std::runtime_error with one sentence if the body cannot be discretized so.
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options);

/// The same discretization through deal.II's FEValues, cell by cell: slow, and the oracle of the fast loop.
/// Only `full`, small strain.
std::unique_ptr<Discretization> discretize_oracle(const Scene& scene, std::size_t body,
                                                  const Options& options);

/// Converged static solution of a linear elastic scene with one body of straight sides, in small motion and
/// with supports at rest: polynomial degree `degree` on `divisions` cells, solved directly. Returns the value
/// of each probe (component-wise, 3 for displacement, 6 for stress and strain) by its name.
StaticLimit static_limit(const Scene& scene, const std::array<int, 3>& divisions, int degree);

/// The version of deal.II this program is built with.
std::string deal_ii_version();

}  // namespace femsph::fem
