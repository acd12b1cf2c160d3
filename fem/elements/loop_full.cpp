#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/elements.hpp"

namespace femsph::fem {

std::unique_ptr<CellLoop> make_full_loop(const LoopInput& in) { return choose_loop<FullElement>(in); }

}  // namespace femsph::fem
