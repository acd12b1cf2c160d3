#include "sph/formulations/discretize.hpp"

#include "sph/operators/rows.hpp"

namespace femsph::sph {

std::unique_ptr<Discretization> discretize(const Scene& scene, std::size_t body, const Options& options) {
  const Shape& shape = *scene.bodies[body].shape;
  if (!(options.spacing > 0)) throw Refusal("SPH needs a spacing, such as --spacing \"5 mm\"");
  if (!(options.smoothing >= 0.6 && options.smoothing <= 4))
    throw Refusal("the smoothing length h / d must lie between 0.6 and 4");
  const Formulation& formulation = formulation_named(options.formulation);
  const std::vector<MirrorPlane> planes = mirror_planes(scene, body);
  formulation.check(scene, body, options, planes);
  Particles particles = fill_best(shape, options, planes);
  const Kernel kernel(options.kernel, shape.dim(), options.smoothing * particles.spacing);
  add_mirrored(particles, planes, kernel.radius());
  set_kernel_volumes(particles, formulation.corrected ? options.kernel_volume : KernelVolume::own);
  return formulation.make(scene, body, options, std::move(particles), kernel);
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
