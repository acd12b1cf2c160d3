#pragma once
// Which class a choice of options becomes. One translation unit per dimension, so that they compile side by
// side.

#include <memory>

#include "sph/formulations/particle_body.hpp"

namespace femsph::sph {

/// Plastic flow of von Mises' kind alone: a tension rule opens the body, and cuts a mean stress that no mean
/// must raise again.
template <class LawType>
bool flows_at_constant_volume(const LawType& law) {
  if constexpr (requires { law.parameters.tension; })
    return law.parameters.tension == TensionRule::none;
  else
    return false;
}
/// Whether a body of corrected SPH is given the mean change of volume. Throws Refusal if it is asked for and
/// has no use.
bool wants_mean_dilatation(const Options& options, const LinearElastic& elastic,
                           bool flows_at_constant_volume);

template <int dim>
std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body, const Options& options,
                                                 Particles particles, const Kernel& kernel);
extern template std::unique_ptr<Discretization> total_lagrangian<2>(const Scene&, std::size_t, const Options&,
                                                                    Particles, const Kernel&);
extern template std::unique_ptr<Discretization> total_lagrangian<3>(const Scene&, std::size_t, const Options&,
                                                                    Particles, const Kernel&);

/// Classic SPH on the initial neighbours in small motion, elastic whatever the scene's material is.
template <int dim>
std::unique_ptr<Discretization> small_motion_body(const Scene& scene, std::size_t body,
                                                  const Options& options, Particles particles,
                                                  const Kernel& kernel, const LinearElastic& elastic);
extern template std::unique_ptr<Discretization> small_motion_body<2>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&, const LinearElastic&);
extern template std::unique_ptr<Discretization> small_motion_body<3>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&, const LinearElastic&);

/// Classic SPH on updated neighbours with the Jaumann rate, for large motion.
template <int dim>
std::unique_ptr<Discretization> updated_lagrangian(
    const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel);
extern template std::unique_ptr<Discretization> updated_lagrangian<2>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&);
extern template std::unique_ptr<Discretization> updated_lagrangian<3>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&);

}  // namespace femsph::sph
