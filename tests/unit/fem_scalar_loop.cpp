#include "fem_scalar_loop.hpp"

#include <stdexcept>

#include "fem/elements/cell_loop_impl.hpp"
#include "fem/elements/elements.hpp"

namespace femsph::test {

std::unique_ptr<fem::CellLoop> make_scalar_loop(const std::string& element, const fem::LoopInput& in) {
  if (element == fem::FullElement::entry.word) return fem::choose_loop<fem::FullElement, double>(in);
  if (element == fem::SriElement::entry.word) return fem::choose_loop<fem::SriElement, double>(in);
  if (element == fem::AssumedStrainElement::entry.word)
    return fem::choose_loop<fem::AssumedStrainElement, double>(in);
  if (element != fem::OnePointElement::entry.word) throw std::logic_error("no such element");
  if (in.hourglass) throw std::logic_error("no scalar loop with Flanagan and Belytschko's control");
  return fem::choose_loop<fem::OnePointElement, double>(in);
}

}  // namespace femsph::test
