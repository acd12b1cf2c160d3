#pragma once
// The SPH room's door: options in, discretization out.

#include <memory>
#include <string>

#include "model/motion/bodies/discretization.hpp"
#include "sph/options.hpp"

namespace femsph::sph {

/// Throws std::runtime_error with one sentence if the body cannot be discretized so.
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options);

/// What a free surface takes from the kernel sum (fig. 18 of the paper): 1 - S(top)/S(middle), where S =
/// sum_j V_j W_ij, at the particles nearest to the middle of the body's y+ side and to the middle of the
/// body.
double surface_weight_loss(const Scene& scene, std::size_t body, const Options& options);

}  // namespace femsph::sph
