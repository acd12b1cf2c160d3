#pragma once
// From the scene's law to the class. Included by updated_lagrangian_2d.cpp and _3d.cpp alone.

#include "sph/formulations/updated_lagrangian.hpp"

namespace femsph::sph {

template <int dim>
std::unique_ptr<Discretization> updated_lagrangian(
    const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel) {
  return std::visit(
      [&](auto law) -> std::unique_ptr<Discretization> {
        if constexpr (requires { law.return_cauchy(); }) law.return_cauchy();
        return std::make_unique<UpdatedLagrangian<dim, std::decay_t<decltype(law)>>>(
            scene, body, options, std::move(particles), kernel, law);
      },
      scene.material_of(scene.bodies[body]).law(scene.plane));
}

}  // namespace femsph::sph
