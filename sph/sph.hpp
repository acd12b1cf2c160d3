#pragma once
// The public functions of sph: options in, discretization out.

#include <memory>
#include <string>

#include "model/motion/bodies/discretization.hpp"
#include "sph/options.hpp"

namespace femsph::sph {

/// Throws Refusal, with one sentence, if the body cannot be discretized with these options.
std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options);

/// By how much the kernel sum S = sum_j V_j W_ij is smaller at a free surface than inside (fig. 18 of the
/// paper): 1 - S(top)/S(middle), at the particles nearest to the middle of side y+ and to the middle of the
/// body.
double surface_weight_loss(const Scene& scene, std::size_t body, const Options& options);

}  // namespace femsph::sph
