#include "sph/formulations/bond_steps.hpp"

namespace femsph::sph {

template class BondBody<2>;

}  // namespace femsph::sph
