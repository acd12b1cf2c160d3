#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/one_point.hpp"

namespace femsph::fem {

std::unique_ptr<CellLoop> make_one_point_loop(const LoopInput& in) {
  return choose_loop<OnePointElement>(in);
}

}  // namespace femsph::fem
