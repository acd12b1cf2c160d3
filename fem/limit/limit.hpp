#pragma once
// The functions of the module that discretize_oracle() and static_limit() of fem.hpp call.

#include <array>
#include <memory>

#include "fem/options.hpp"
#include "fem/static_limit.hpp"
#include "model/motion/bodies/discretization.hpp"

namespace femsph::fem {

std::unique_ptr<Discretization> make_oracle(const Scene& scene, std::size_t body, const Options& options);
StaticLimit solve_static(const Scene& scene, const std::array<int, 3>& divisions, int degree);

}  // namespace femsph::fem
