// The kernels that instructions.cpp counts, and no others: the rooms' own templates, chosen by hand so that this second build stays short.

#include <stdexcept>

#include "fem/cell_loop_impl.hpp"
#include "sph/discretize.hpp"
#include "sph/total_lagrangian.hpp"

namespace femsph {

namespace {

[[noreturn]] void absent() { throw std::runtime_error("not among the kernels of this program"); }

}  // namespace

namespace fem {

template <class ElementType>
std::unique_ptr<CellLoop> plane_loop(const LoopInput& in) {
  if (in.mesh->dim != 2 || in.scalar_kernel) absent();
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<CellLoop> {
        using LawType = std::decay_t<decltype(law)>;
        if (in.large_motion) return std::make_unique<Loop<ElementType, FiniteRotation, LawType, 2, Pack>>(in, law);
        return std::make_unique<Loop<ElementType, SmallStrain, LawType, 2, Pack>>(in, law);
      },
      in.law);
}
std::unique_ptr<CellLoop> make_full_loop(const LoopInput& in) { return plane_loop<FullElement>(in); }
std::unique_ptr<CellLoop> make_one_point_loop(const LoopInput& in) { return plane_loop<OnePointElement>(in); }
std::unique_ptr<CellLoop> make_sri_loop(const LoopInput&) { absent(); }
std::unique_ptr<CellLoop> make_assumed_strain_loop(const LoopInput&) { absent(); }

}  // namespace fem

namespace sph {

template <int dim>
std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel) {
  if constexpr (dim == 2) {
    return std::visit(
        [&](const auto& law) -> std::unique_ptr<Discretization> {
          using LawType = std::decay_t<decltype(law)>;
          const auto with = [&]<class Kinematics, Correction correction>() -> std::unique_ptr<Discretization> {
            return std::make_unique<TotalLagrangian<2, LatticeStencils<2>, Kinematics, LawType, correction>>(scene, body, options, std::move(particles), kernel, law);
          };
          if (options.formulation == Formulation::classic) return with.template operator()<SmallStrain, Correction::none>();
          if (scene.large_motion) return with.template operator()<FiniteRotation, Correction::matrix_and_hourglass>();
          return options.hourglass > 0 ? with.template operator()<SmallStrain, Correction::matrix_and_hourglass>()
                                       : with.template operator()<SmallStrain, Correction::matrix>();
        },
        scene.material_of(scene.bodies[body]).law(scene.plane));
  } else {
    absent();
  }
}
template <int dim>
std::unique_ptr<Discretization> updated_lagrangian(const Scene&, std::size_t, const Options&, Particles, const Kernel&) { absent(); }

template std::unique_ptr<Discretization> total_lagrangian<2>(const Scene&, std::size_t, const Options&, Particles, const Kernel&);
template std::unique_ptr<Discretization> total_lagrangian<3>(const Scene&, std::size_t, const Options&, Particles, const Kernel&);
template std::unique_ptr<Discretization> updated_lagrangian<2>(const Scene&, std::size_t, const Options&, Particles, const Kernel&);
template std::unique_ptr<Discretization> updated_lagrangian<3>(const Scene&, std::size_t, const Options&, Particles, const Kernel&);

}  // namespace sph
}  // namespace femsph
