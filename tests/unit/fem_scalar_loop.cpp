#include "fem_scalar_loop.hpp"

#include <stdexcept>

#include "fem/elements/assumed_strain.hpp"
#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/elements.hpp"
#include "fem/elements/one_point.hpp"

namespace femsph::test {

std::unique_ptr<fem::CellLoop> make_scalar_loop(fem::Element element, const fem::LoopInput& in) {
  switch (element) {
    case fem::Element::full:
      return fem::choose_loop<fem::FullElement, double>(in);
    case fem::Element::sri:
      return fem::choose_loop<fem::SriElement, double>(in);
    case fem::Element::one_point:
      if (in.hourglass) throw std::logic_error("no scalar loop with Flanagan and Belytschko's control");
      return fem::choose_loop<fem::OnePointElement, double>(in);
    case fem::Element::assumed_strain:
      return fem::choose_loop<fem::AssumedStrainElement, double>(in);
  }
  throw std::logic_error("no such element");
}

}  // namespace femsph::test
