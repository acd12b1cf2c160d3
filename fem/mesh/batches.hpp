#pragma once
// How cells are distributed over SIMD lanes and threads. A batch is eight cells, one in each lane. A domain
// is a fixed number of consecutive batches. A node belongs to the first domain that has it. Other domains add
// their part to ghost slots behind the nodes, one for each domain and node, and the ghost slots are summed
// afterwards in the order of the domains. So no two threads write to one slot, and the result does not depend
// on the number of threads.

#include <cstddef>
#include <vector>

#include "fem/mesh/mesh.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/simd.hpp"

namespace femsph::fem {

inline constexpr std::size_t batches_per_domain = 512;

struct Batches {
  std::size_t count = 0;
  std::size_t cells = 0;      ///< lanes beyond the last cell repeat it and scatter into the padding slot
  AlignedVector<int> gather;  ///< offset of the corner's values: (batch * corners + corner) * lanes + lane
  AlignedVector<int> scatter;
  std::size_t slots = 0;  ///< nodes, ghost slots, and last the padding slot, which is never read

  /// Ghost slots of a node: those of shared_node[i] are shared_slot[k], shared_begin[i] <= k <
  /// shared_begin[i + 1].
  std::vector<int> shared_node, shared_begin, shared_slot;

  explicit Batches(const Mesh& mesh);
  std::size_t bytes() const;
  /// Adds the ghost slots to their nodes and clears them. `dim` components per slot.
  void sum_ghosts(double* f, int dim) const;
};

}  // namespace femsph::fem
