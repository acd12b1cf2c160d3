#pragma once
// The element loops with one double in place of eight lanes: the same kernels, one cell at a time.

#include <memory>
#include <string>

#include "fem/elements/cell_loop.hpp"

namespace femsph::test {

/// For fem::Options::loop.
std::unique_ptr<fem::CellLoop> make_scalar_loop(const std::string& element, const fem::LoopInput& in);

}  // namespace femsph::test
