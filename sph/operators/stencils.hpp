#pragma once
// Two packings of the same operator, behind one interface: LatticeStencils and ListStencils.
// A field is kept as one row per component, `stride` apart; particle i of a field sits at `first + i`. Of Q,
// which the divergence sums, the packing says itself where its components are (tensor_layout.hpp).

#include "sph/operators/lattice_stencils.hpp"
#include "sph/operators/list_stencils.hpp"
