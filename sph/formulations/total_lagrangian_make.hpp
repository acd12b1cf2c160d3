#pragma once
// Included by total_lagrangian_2d.cpp and _3d.cpp alone.

#include "sph/formulations/discretize.hpp"
#include "sph/formulations/total_lagrangian_output.hpp"

namespace femsph::sph {

template <int dim>
std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body, const Options& options,
                                                 Particles particles, const Kernel& kernel) {
  const Law law = scene.material_of(scene.bodies[body]).law(scene.plane);
  return std::visit(
      [&](const auto& l) -> std::unique_ptr<Discretization> {
        using LawType = std::decay_t<decltype(l)>;
        const auto with = [&]<class Stencils, class Kinematics, Correction correction>()
            -> std::unique_ptr<Discretization> {
          return std::make_unique<TotalLagrangian<dim, Stencils, Kinematics, LawType, correction>>(
              scene, body, options, std::move(particles), kernel, l);
        };
        const auto packed = [&]<class Kinematics, Correction correction>() {
          const bool lattice = particles.regular && !options.force_lists;
          return lattice ? with.template operator()<LatticeStencils<dim>, Kinematics, correction>()
                         : with.template operator()<ListStencils<dim>, Kinematics, correction>();
        };
        const bool hourglass = options.hourglass > 0, classic = options.formulation == Formulation::classic;
        if (!classic && wants_mean_dilatation(options, l.elastic(), flows_at_constant_volume(l))) {
          if (scene.large_motion)
            return packed
                .template operator()<LargeMotion<LawType>, Correction::hourglass_and_mean_dilatation>();
          if constexpr (!LargeMotionOnly<LawType>)
            return packed.template operator()<SmallStrain, Correction::hourglass_and_mean_dilatation>();
        }
        if (scene.large_motion && !classic)
          return packed.template operator()<LargeMotion<LawType>, Correction::matrix_and_hourglass>();
        if constexpr (LargeMotionOnly<LawType>) {
          throw std::runtime_error("this material needs motion = \"large\"");
        } else {
          if (classic)
            return options.boundary == Boundary::weight
                       ? packed.template operator()<SmallStrain, Correction::matrix>()
                       : packed.template operator()<SmallStrain, Correction::none>();
          return hourglass ? packed.template operator()<SmallStrain, Correction::matrix_and_hourglass>()
                           : packed.template operator()<SmallStrain, Correction::matrix>();
        }
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
