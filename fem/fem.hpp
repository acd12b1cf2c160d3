#pragma once
// The public functions of fem: options in, discretization out. What uses deal.II (the oracle, the static
// limit, distorted meshes) is in a module that is loaded at the first call (mesh/deal_ii.hpp).

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

/// Throws Refusal, with one sentence, if the body cannot be discretized with these options.
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options);

/// The same discretization by deal.II's FEValues, cell by cell: slow, a reference for tests of the fast loop.
/// Element `full` in small strain only, without bars.
std::unique_ptr<Discretization> discretize_oracle(const Scene& scene, std::size_t body,
                                                  const Options& options);

/// The static solution of a linear elastic scene with elements of polynomial degree `degree` on `divisions`
/// cells, to which meshes converge. The scene has one body with straight sides, small motion, and supports at
/// rest. Returns the values of each probe and section by its name: three components of a displacement, six of
/// a stress or strain. Throws std::runtime_error for other scenes.
StaticLimit static_limit(const Scene& scene, const std::array<int, 3>& divisions, int degree);

/// The version of deal.II this program is built with.
std::string deal_ii_version();

}  // namespace femsph::fem
