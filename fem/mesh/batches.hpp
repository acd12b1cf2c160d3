#pragma once
// How the cells are dealt to SIMD lanes and threads. A batch is eight cells, corner by corner; a domain is a
// fixed run of batches (its size depends on nothing but the dimension). A node first touched by another
// domain is a ghost: the domain adds to a slot of its own behind the nodes, and the slots are summed
// afterwards in domain order. So no two threads write one slot, and the result does not depend on how many
// there are.

#include <cstddef>
#include <vector>

#include "fem/mesh/mesh.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/simd.hpp"

namespace femsph::fem {

inline constexpr std::size_t batches_per_domain = 512;

struct Batches {
  std::size_t count = 0;
  std::size_t cells = 0;  ///< lanes beyond the last cell repeat it, and scatter into a slot that nobody reads
  AlignedVector<int> gather;  ///< offset of the corner's values: (batch * corners + corner) * lanes + lane
  AlignedVector<int> scatter;
  std::size_t slots = 0;  ///< nodes, ghost slots and the slot of the padding lanes

  /// Ghost slots by node: node[i] also owns slot[begin[i]] .. slot[begin[i + 1] - 1].
  std::vector<int> shared_node, shared_begin, shared_slot;

  explicit Batches(const Mesh& mesh);
  std::size_t bytes() const;
  /// Adds the ghost slots to their nodes and clears them. `dim` components per slot.
  void sum_ghosts(double* f, int dim) const;
};

}  // namespace femsph::fem
