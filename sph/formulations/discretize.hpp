#pragma once
// What formulations are made of: the bodies of particles, without their kernels. They are compiled in one
// source for each dimension (total_lagrangian_2d.cpp and so on), side by side.

#include <memory>

#include "sph/formulations/particle_body.hpp"

namespace femsph::sph {

enum class Correction;  // gradient_operator.hpp

/// Whether a body of a corrected formulation is given the mean change of volume. Throws Refusal if the
/// options ask for it where it has no use.
bool wants_mean_dilatation(const Options& options, const Law& law);

/// SPH on the initial neighbours. In large motion the correction is one with hourglass control. Throws
/// std::runtime_error if the material is made for large motion and the scene is not.
template <int dim>
std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body, const Options& options,
                                                 Particles particles, const Kernel& kernel,
                                                 Correction correction);
extern template std::unique_ptr<Discretization> total_lagrangian<2>(const Scene&, std::size_t, const Options&,
                                                                    Particles, const Kernel&, Correction);
extern template std::unique_ptr<Discretization> total_lagrangian<3>(const Scene&, std::size_t, const Options&,
                                                                    Particles, const Kernel&, Correction);
inline std::unique_ptr<Discretization> total_lagrangian(const Scene& scene, std::size_t body,
                                                        const Options& options, Particles particles,
                                                        const Kernel& kernel, Correction correction) {
  const auto make = particles.dim == 2 ? total_lagrangian<2> : total_lagrangian<3>;
  return make(scene, body, options, std::move(particles), kernel, correction);
}

/// Uncorrected SPH on the initial neighbours in small motion, elastic whatever the scene's material is.
template <int dim>
std::unique_ptr<Discretization> small_motion_body(const Scene& scene, std::size_t body,
                                                  const Options& options, Particles particles,
                                                  const Kernel& kernel, const LinearElastic& elastic);
extern template std::unique_ptr<Discretization> small_motion_body<2>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&, const LinearElastic&);
extern template std::unique_ptr<Discretization> small_motion_body<3>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&, const LinearElastic&);

/// Uncorrected SPH on neighbours that follow the particles, for large motion.
template <int dim>
std::unique_ptr<Discretization> updated_lagrangian(
    const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel);
extern template std::unique_ptr<Discretization> updated_lagrangian<2>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&);
extern template std::unique_ptr<Discretization> updated_lagrangian<3>(
    const Scene&, std::size_t, const Options&, Particles, const Kernel&);
inline std::unique_ptr<Discretization> updated_lagrangian(
    const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel) {
  const auto make = particles.dim == 2 ? updated_lagrangian<2> : updated_lagrangian<3>;
  return make(scene, body, options, std::move(particles), kernel);
}

/// Corrected SPH on neighbours that follow the particles, with bonds that have a memory, for large motion.
template <int dim>
std::unique_ptr<Discretization> bond_body(const Scene& scene, std::size_t body, const Options& options,
                                          Particles particles, const Kernel& kernel);
extern template std::unique_ptr<Discretization> bond_body<2>(const Scene&, std::size_t, const Options&,
                                                             Particles, const Kernel&);
extern template std::unique_ptr<Discretization> bond_body<3>(const Scene&, std::size_t, const Options&,
                                                             Particles, const Kernel&);
inline std::unique_ptr<Discretization> bond_body(const Scene& scene, std::size_t body, const Options& options,
                                                 Particles particles, const Kernel& kernel) {
  const auto make = particles.dim == 2 ? bond_body<2> : bond_body<3>;
  return make(scene, body, options, std::move(particles), kernel);
}

}  // namespace femsph::sph
