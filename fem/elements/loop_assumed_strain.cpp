#include "fem/elements/assumed_strain.hpp"
#include "fem/elements/cell_loop_impl.hpp"

namespace femsph::fem {

std::unique_ptr<CellLoop> make_assumed_strain_loop(const LoopInput& in) {
  return choose_loop<AssumedStrainElement>(in);
}

}  // namespace femsph::fem
