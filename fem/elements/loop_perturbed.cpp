#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/one_point.hpp"

namespace femsph::fem {

std::unique_ptr<CellLoop> make_perturbed_loop(const LoopInput& in) {
  return choose_loop<PerturbedElement>(in);
}

}  // namespace femsph::fem
