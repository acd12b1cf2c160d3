#pragma once
// Where the loops of the elements are compiled. One takes a minute or two, so the elements are shared among
// sources that compile side by side: loop_0.cpp has elements 0, 4, .. of the list, loop_1.cpp has 1, 5, ..
// and so on; loop_controlled.cpp has the loops under the control of Options::hourglass.

#include <cstddef>
#include <memory>

#include "fem/elements/cell_loop.hpp"

namespace femsph::fem {

inline constexpr std::size_t loop_sources = 4;

/// The loop of the element of this number in the list, one that source `source` compiles.
template <std::size_t source>
std::unique_ptr<CellLoop> loop_from(std::size_t number, const LoopInput& in);

/// The loop of that element under the control of Options::hourglass; null if the element has none.
std::unique_ptr<CellLoop> controlled_loop(std::size_t number, const LoopInput& in);

}  // namespace femsph::fem
