#include "sph/formulations/choose_updated_lagrangian.hpp"

namespace femsph::sph {

template std::unique_ptr<Discretization> updated_lagrangian<2>(const Scene&, std::size_t, const Options&,
                                                               Particles, const Kernel&);

}  // namespace femsph::sph
