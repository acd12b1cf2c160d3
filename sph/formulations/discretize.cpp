#include "sph/formulations/discretize.hpp"

#include <algorithm>
#include <stdexcept>

#include "sph/operators/rows.hpp"

namespace femsph::sph {

std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options) {
  const Shape& shape = *scene.bodies[body].shape;
  if (!(options.spacing > 0)) throw Refusal("SPH needs a spacing, such as --spacing \"5 mm\"");
  if (!(options.smoothing >= 0.6 && options.smoothing <= 4))
    throw Refusal("the smoothing length h / d must lie between 0.6 and 4");
  const bool classic = options.formulation == Formulation::classic;
  if (!classic && (options.boundary != Boundary::none || options.viscosity.on()))
    throw Refusal(
        "corrected SPH takes neither virtual particles, nor boundary weights, nor artificial viscosity: they "
        "belong to the classic formulation");
  if (options.boundary == Boundary::virtual_particles && (!shape.is_box() || options.jitter > 0))
    throw Refusal("virtual particles mirror a lattice in the straight sides of a box; this body is none");
  if (classic && scene.large_motion && options.boundary != Boundary::none)
    throw Refusal(
        "virtual particles and boundary weights stand on initial neighbours; a scene with large motion "
        "cannot use them");
  const std::vector<MirrorPlane> planes = mirror_planes(scene, body);
  if (options.boundary == Boundary::virtual_particles && !planes.empty())
    throw Refusal(
        "virtual particles mirror every side of a box; a body with symmetry planes cannot use them");
  const bool has_bars = std::any_of(
      scene.bars.begin(), scene.bars.end(), [&](const Bar& bar) { return bar.body == body; });
  if (classic && scene.large_motion && (has_bars || !planes.empty()))
    throw Refusal(
        "symmetry planes and bars stand on initial neighbours; classic SPH with large motion cannot use "
        "them");
  Particles particles = fill_best(shape, options, planes);
  const Kernel kernel(options.kernel, shape.dim(), options.smoothing * particles.spacing);
  add_mirrored(particles, planes, kernel.radius());
  set_kernel_volumes(particles, classic ? KernelVolume::own : options.kernel_volume);
  if (classic && scene.large_motion)
    return shape.dim() == 2 ? updated_lagrangian<2>(scene, body, options, std::move(particles), kernel)
                            : updated_lagrangian<3>(scene, body, options, std::move(particles), kernel);
  return shape.dim() == 2 ? total_lagrangian<2>(scene, body, options, std::move(particles), kernel)
                          : total_lagrangian<3>(scene, body, options, std::move(particles), kernel);
}

bool wants_mean_dilatation(const Options& options, const LinearElastic& elastic,
                           bool flows_at_constant_volume) {
  if (elastic.plane == Plane::stress) {
    if (options.dilatation == Dilatation::mean)
      throw Refusal(
          "a mean dilatation is for bodies that keep their volume; in plane stress the thickness gives way");
    return false;
  }
  return options.dilatation == Dilatation::automatic
             ? flows_at_constant_volume || elastic.poisson > 0.4
             : options.dilatation == Dilatation::mean;
}

double surface_weight_loss(const Scene& scene, std::size_t body, const Options& options) {
  const Shape& shape = *scene.bodies[body].shape;
  Particles particles = fill(shape, options);
  set_kernel_volumes(particles, KernelVolume::own);
  const Kernel kernel(options.kernel, shape.dim(), options.smoothing * particles.spacing);
  const auto rows = options.boundary == Boundary::virtual_particles ? virtual_rows(particles, kernel)
                                                                    : lattice_rows(particles, kernel);
  const auto nearest = [&](const Point& p) {
    std::size_t best = 0;
    const auto distance = [&](std::size_t i) {
      double r = 0;
      for (int a = 0; a < 3; ++a) r += (particles.position[i][a] - p[a]) * (particles.position[i][a] - p[a]);
      return r;
    };
    for (std::size_t i = 1; i < particles.size(); ++i)
      if (distance(i) < distance(best)) best = i;
    return best;
  };
  Point middle{}, top{};
  for (int a = 0; a < 3; ++a) top[a] = middle[a] = 0.5 * (shape.lower()[a] + shape.upper()[a]);
  top[1] = shape.upper()[1];
  return 1 - rows->kernel_sum(nearest(top)) / rows->kernel_sum(nearest(middle));
}

}  // namespace femsph::sph
