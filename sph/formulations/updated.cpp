// SPH on updated neighbours that stays stable: a corrected gradient, its exact adjoint as force, and bonds
// with a memory (bond_body.hpp).

#include <algorithm>

#include "sph/formulations/discretize.hpp"

namespace femsph::sph {

namespace {

void check_updated(const Scene& scene, std::size_t body, const Options& options,
                   const std::vector<MirrorPlane>&) {
  if (options.boundary != Boundary::none)
    throw Refusal("virtual particles and boundary weights belong to the classic formulation in small motion");
  if (std::any_of(scene.bars.begin(), scene.bars.end(), [&](const Bar& bar) { return bar.body == body; }))
    throw Refusal("bars lie along rows of particles, which sph-updated may part; use sph-corrected");
}

std::unique_ptr<Discretization> make_updated(const Scene& scene, std::size_t body, const Options& options,
                                             Particles particles, const Kernel& kernel) {
  return bond_body(scene, body, options, std::move(particles), kernel);
}

Options updated_options() {
  Options options;
  options.smoothing = 1.3;
  options.hourglass = 4;
  options.projection = false;
  return options;
}

}  // namespace

Formulation updated_formulation() {
  return {.word = "updated",
          .corrected = true,
          .initial_neighbours = false,
          .viscosity = true,
          .hourglass = true,
          .bytes = {1900, 6000},
          .variants = {{"updated",
                        "corrected gradient on neighbours that follow the particles; bonds remember their "
                        "length until the material flows",
                        updated_options()}},
          .check = check_updated,
          .make = make_updated};
}

}  // namespace femsph::sph
