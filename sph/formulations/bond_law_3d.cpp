#include "sph/formulations/bond_law.hpp"

namespace femsph::sph {

template std::unique_ptr<Discretization> bond_body<3>(const Scene&, std::size_t, const Options&, Particles,
                                                      const Kernel&);

}  // namespace femsph::sph
