#include "fem/elements/compile_loops.hpp"

template std::unique_ptr<femsph::fem::CellLoop> femsph::fem::loop_from<1>(std::size_t, const LoopInput&);
