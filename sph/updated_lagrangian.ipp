// Included by updated_lagrangian_2d.cpp and _3d.cpp alone.

#include "sph/updated_lagrangian.hpp"

namespace femsph::sph {

template <int dim>
std::unique_ptr<Discretization> updated_lagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel) {
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<Discretization> {
        using LawType = std::decay_t<decltype(law)>;
        if constexpr (LargeMotionOnly<LawType>)
          throw std::runtime_error("classic SPH on updated neighbours sums rates of stress, and a neo-Hookean material has none; take corrected SPH or law = \"elastic\"");
        else
          return std::make_unique<UpdatedLagrangian<dim, LawType>>(scene, body, options, std::move(particles), kernel, law);
      },
      scene.material_of(scene.bodies[body]).law(scene.plane));
}

}  // namespace femsph::sph
