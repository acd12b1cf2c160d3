#pragma once
// From the scene and the correction to the class. Included by total_lagrangian_2d.cpp and _3d.cpp alone.

#include <stdexcept>

#include "sph/formulations/discretize.hpp"
#include "sph/formulations/total_lagrangian_output.hpp"

namespace femsph::sph {

template <int dim>
std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body, const Options& options,
                                                 Particles particles, const Kernel& kernel,
                                                 Correction correction) {
  const Law law = scene.material_of(scene.bodies[body]).law(scene.plane);
  return std::visit(
      [&](const auto& l) -> std::unique_ptr<Discretization> {
        using LawType = std::decay_t<decltype(l)>;
        const auto with =
            [&]<class Stencils, class Kinematics, Correction chosen>() -> std::unique_ptr<Discretization> {
          return std::make_unique<TotalLagrangian<dim, Stencils, Kinematics, LawType, chosen>>(
              scene, body, options, std::move(particles), kernel, l);
        };
        const auto packed = [&]<class Kinematics, Correction chosen>() {
          const bool lattice = particles.regular && !options.force_lists;
          return lattice ? with.template operator()<LatticeStencils<dim>, Kinematics, chosen>()
                         : with.template operator()<ListStencils<dim>, Kinematics, chosen>();
        };
        using enum Correction;
        if (scene.large_motion) switch (correction) {
            case matrix_and_hourglass:
              return packed.template operator()<LargeMotion<LawType>, matrix_and_hourglass>();
            case hourglass_and_mean_dilatation:
              return packed.template operator()<LargeMotion<LawType>, hourglass_and_mean_dilatation>();
            case none:
            case matrix:
              throw std::logic_error("in large motion SPH on initial neighbours needs hourglass control");
          }
        if constexpr (LargeMotionOnly<LawType>)
          throw std::runtime_error("this material needs motion = \"large\"");
        else
          switch (correction) {
            case none:
              return packed.template operator()<SmallStrain, none>();
            case matrix:
              return packed.template operator()<SmallStrain, matrix>();
            case matrix_and_hourglass:
              return packed.template operator()<SmallStrain, matrix_and_hourglass>();
            case hourglass_and_mean_dilatation:
              return packed.template operator()<SmallStrain, hourglass_and_mean_dilatation>();
          }
        throw std::logic_error("no such correction");
      },
      law);
}

template <int dim>
std::unique_ptr<Discretization> small_motion_body(const Scene& scene, std::size_t body,
                                                  const Options& options, Particles particles,
                                                  const Kernel& kernel, const LinearElastic& elastic) {
  const auto with = [&]<class Stencils>() -> std::unique_ptr<Discretization> {
    return std::make_unique<TotalLagrangian<dim, Stencils, SmallStrain, LinearElastic, Correction::none>>(
        scene, body, options, std::move(particles), kernel, elastic);
  };
  return particles.regular && !options.force_lists
             ? with.template operator()<LatticeStencils<dim>>()
             : with.template operator()<ListStencils<dim>>();
}

}  // namespace femsph::sph
