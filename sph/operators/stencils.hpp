#pragma once
// Two storage forms of the same operator with one interface: LatticeStencils and ListStencils. A field is one
// row per component, `stride` apart; particle i is at `first + i`. The storage form says where the components
// of Q, which the divergence sums, are stored (tensor_layout.hpp).

#include "sph/operators/lattice_stencils.hpp"
#include "sph/operators/list_stencils.hpp"
