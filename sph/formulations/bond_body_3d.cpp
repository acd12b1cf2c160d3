#include "sph/formulations/bond_steps.hpp"

namespace femsph::sph {

template class BondBody<3>;

}  // namespace femsph::sph
