#include "sph/formulations/choose_total_lagrangian.hpp"

namespace femsph::sph {

template std::unique_ptr<Discretization> total_lagrangian<2>(const Scene&, std::size_t, const Options&,
                                                             Particles, const Kernel&, Correction);
template std::unique_ptr<Discretization> small_motion_body<2>(const Scene&, std::size_t, const Options&,
                                                              Particles, const Kernel&, const LinearElastic&);

}  // namespace femsph::sph
