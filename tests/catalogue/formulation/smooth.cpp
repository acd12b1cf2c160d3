// A dummy for tests/catalogue: corrected SPH without hourglass control, with one variant that has a larger
// smoothing length.

#include "sph/formulations/discretize.hpp"
#include "sph/operators/gradient_operator.hpp"

namespace femsph::sph {

namespace {

Options larger_smoothing() {
  Options options;
  options.smoothing = 1.3;
  return options;
}

void check_smooth(const Scene& scene, std::size_t, const Options&, const std::vector<MirrorPlane>&) {
  if (scene.large_motion) throw Refusal("smooth SPH is for small motion");
}

std::unique_ptr<Discretization> make_smooth(const Scene& scene, std::size_t body, const Options& options,
                                            Particles particles, const Kernel& kernel) {
  return total_lagrangian(scene, body, options, std::move(particles), kernel, Correction::matrix);
}

}  // namespace

Formulation smooth_formulation() {
  return {.word = "smooth",
          .corrected = true,
          .variants = {{"smooth", "corrected gradient alone, for a test", {}},
                       {"smooth-wide", "the same with h = 1.3 d", larger_smoothing()}},
          .check = check_smooth,
          .make = make_smooth};
}

}  // namespace femsph::sph
