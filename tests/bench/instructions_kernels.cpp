// The kernels that instructions.cpp counts, and no others: the rooms' own templates, chosen by hand so that
// this second build stays short.

#include <stdexcept>

#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/elements.hpp"
#include "fem/elements/loops.hpp"
#include "sph/formulations/discretize.hpp"
#include "sph/formulations/total_lagrangian_output.hpp"

namespace femsph {

namespace {

[[noreturn]] void absent() { throw std::runtime_error("not among the kernels of this program"); }

}  // namespace

namespace fem {

template <class ElementType>
std::unique_ptr<CellLoop> plane_loop(const LoopInput& in) {
  if (in.mesh->dim != 2) absent();
  if (const auto* elastic = std::get_if<LinearElastic>(&in.law)) {
    if (in.large_motion)
      return std::make_unique<Loop<ElementType, FiniteRotation, LinearElastic, 2, Pack>>(in, *elastic);
    return std::make_unique<Loop<ElementType, SmallStrain, LinearElastic, 2, Pack>>(in, *elastic);
  }
  if (in.large_motion) absent();
  return std::make_unique<Loop<ElementType, SmallStrain, Plastic, 2, Pack>>(in, std::get<Plastic>(in.law));
}
// In the order of the list.
template <>
std::unique_ptr<CellLoop> loop_from<0>(std::size_t, const LoopInput& in) {
  return plane_loop<FullElement>(in);
}
template <>
std::unique_ptr<CellLoop> loop_from<1>(std::size_t, const LoopInput&) {
  absent();
}
template <>
std::unique_ptr<CellLoop> loop_from<2>(std::size_t, const LoopInput& in) {
  return plane_loop<OnePointElement>(in);
}
template <>
std::unique_ptr<CellLoop> loop_from<3>(std::size_t, const LoopInput&) {
  absent();
}
std::unique_ptr<CellLoop> controlled_loop(std::size_t, const LoopInput&) { absent(); }

}  // namespace fem

namespace sph {

template <int dim>
std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body, const Options& options,
                                                 Particles particles, const Kernel& kernel,
                                                 Correction wanted) {
  if constexpr (dim == 2) {
    const auto with =
        [&]<class Kinematics, Correction correction>(const auto& law) -> std::unique_ptr<Discretization> {
      using LawType = std::decay_t<decltype(law)>;
      return std::make_unique<TotalLagrangian<2, LatticeStencils<2>, Kinematics, LawType, correction>>(
          scene, body, options, std::move(particles), kernel, law);
    };
    const Law law = scene.material_of(scene.bodies[body]).law(scene.plane);
    const bool classic = wanted == Correction::none, hourglass = wanted == Correction::matrix_and_hourglass;
    if (const auto* elastic = std::get_if<LinearElastic>(&law)) {
      if (classic) return with.template operator()<SmallStrain, Correction::none>(*elastic);
      if (scene.large_motion)
        return with.template operator()<FiniteRotation, Correction::matrix_and_hourglass>(*elastic);
      return hourglass ? with.template operator()<SmallStrain, Correction::matrix_and_hourglass>(*elastic)
                       : with.template operator()<SmallStrain, Correction::matrix>(*elastic);
    }
    if (classic || scene.large_motion || !hourglass) absent();
    return with.template operator()<SmallStrain, Correction::matrix_and_hourglass>(std::get<Plastic>(law));
  } else {
    absent();
  }
}
template <int dim>
std::unique_ptr<Discretization> updated_lagrangian(const Scene&, std::size_t, const Options&, Particles,
                                                   const Kernel&) {
  absent();
}
template <int dim>
std::unique_ptr<Discretization> bond_body(const Scene&, std::size_t, const Options&, Particles,
                                          const Kernel&) {
  absent();
}

template std::unique_ptr<Discretization> total_lagrangian<2>(const Scene&, std::size_t, const Options&,
                                                             Particles, const Kernel&, Correction);
template std::unique_ptr<Discretization> total_lagrangian<3>(const Scene&, std::size_t, const Options&,
                                                             Particles, const Kernel&, Correction);
template std::unique_ptr<Discretization> updated_lagrangian<2>(const Scene&, std::size_t, const Options&,
                                                               Particles, const Kernel&);
template std::unique_ptr<Discretization> updated_lagrangian<3>(const Scene&, std::size_t, const Options&,
                                                               Particles, const Kernel&);
template std::unique_ptr<Discretization> bond_body<2>(const Scene&, std::size_t, const Options&, Particles,
                                                      const Kernel&);
template std::unique_ptr<Discretization> bond_body<3>(const Scene&, std::size_t, const Options&, Particles,
                                                      const Kernel&);

}  // namespace sph
}  // namespace femsph
