// Corrected SPH: the gradient of linear fields is exact (gradient_operator.hpp), on the initial neighbours
// (total_lagrangian.hpp), with hourglass control and, where the material is nearly incompressible, the mean
// change of volume over the neighbours (mean_dilatation.hpp).

#include "model/material/flow_stress.hpp"
#include "sph/formulations/discretize.hpp"
#include "sph/operators/gradient_operator.hpp"

namespace femsph::sph {

namespace {

/// Plastic flow by the von Mises criterion alone. With a tension rule the material cracks and its volume
/// grows; the rule limits the mean stress, and an average over neighbours could raise it again.
bool flows_at_constant_volume(const Plasticity* plasticity) {
  return plasticity && plasticity->tension == TensionRule::none;
}

Options own_volume() {
  Options options;
  options.kernel_volume = KernelVolume::own;
  options.hourglass = 0.1;
  options.projection = false;
  return options;
}

void check_corrected(const Scene&, std::size_t, const Options& options, const std::vector<MirrorPlane>&) {
  if (options.boundary != Boundary::none || options.viscosity.on())
    throw Refusal(
        "corrected SPH takes neither virtual particles, nor boundary weights, nor artificial viscosity: they "
        "belong to the classic formulation");
}

std::unique_ptr<Discretization> make_corrected(const Scene& scene, std::size_t body, const Options& options,
                                               Particles particles, const Kernel& kernel) {
  const Law law = scene.material_of(scene.bodies[body]).law(scene.plane);
  const Correction correction = wants_mean_dilatation(options, law)
                                    ? Correction::hourglass_and_mean_dilatation
                                : scene.large_motion || options.hourglass > 0
                                    ? Correction::matrix_and_hourglass
                                    : Correction::matrix;
  return total_lagrangian(scene, body, options, std::move(particles), kernel, correction);
}

}  // namespace

bool wants_mean_dilatation(const Options& options, const Law& law) {
  const auto [elastic, plasticity] = std::visit(
      [](const auto& l) {
        return std::pair{l.elastic(), plasticity_of(l)};
      },
      law);
  if (elastic.plane == Plane::stress) {
    if (options.dilatation == Dilatation::mean)
      throw Refusal(
          "mean dilatation is for nearly incompressible bodies; in plane stress the thickness changes "
          "freely");
    return false;
  }
  return options.dilatation == Dilatation::automatic
             ? flows_at_constant_volume(plasticity) || elastic.poisson > 0.4
             : options.dilatation == Dilatation::mean;
}

Formulation corrected_formulation() {
  return {.word = "corrected",
          .corrected = true,
          .hourglass = true,
          .variants = {{"corrected",
                        "corrected gradient over whole cells, with hourglass control: exact for linear "
                        "motion, second order to the surface",
                        {}},
                       {"corrected-own-volume",
                        "the same with half cells on sides in the kernel sums: one-sided below the surface, "
                        "and too soft; for comparison",
                        own_volume()}},
          .check = check_corrected,
          .make = make_corrected};
}

}  // namespace femsph::sph
