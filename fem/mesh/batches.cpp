#include "fem/mesh/batches.hpp"

#include <algorithm>
#include <tuple>

#include "model/numerics/parallel.hpp"

namespace femsph::fem {

Batches::Batches(const Mesh& mesh)
    : count(round_up(mesh.cell_count(), lanes) / lanes), cells(mesh.cell_count()) {
  const std::size_t corners = static_cast<std::size_t>(mesh.corners());
  gather.resize(count * corners * lanes);
  scatter.resize(gather.size());
  slots = mesh.node_count();
  std::vector<int> owner(slots, -1), slot(slots, -1), slot_domain(slots, -1);
  std::vector<std::tuple<int, int>> ghosts;  // node and its extra slot, in the order of the domains
  for (std::size_t b = 0; b < count; ++b) {
    const int domain = static_cast<int>(b / batches_per_domain);
    for (std::size_t a = 0; a < corners; ++a)
      for (std::size_t l = 0; l < lanes; ++l) {
        const std::size_t at = (b * corners + a) * lanes + l, cell = std::min(b * lanes + l, cells - 1);
        const int node = mesh.cell(cell)[a];
        gather[at] = node * mesh.dim;
        if (b * lanes + l >= cells) {
          scatter[at] = -1;
          continue;
        }
        if (owner[node] < 0) owner[node] = domain;
        if (owner[node] != domain && slot_domain[node] != domain) {
          slot_domain[node] = domain;
          slot[node] = static_cast<int>(slots++);
          ghosts.emplace_back(node, slot[node]);
        }
        scatter[at] = (owner[node] == domain ? node : slot[node]) * mesh.dim;
      }
  }
  const int spare = static_cast<int>(slots++) * mesh.dim;
  std::replace(scatter.begin(), scatter.end(), -1, spare);

  std::stable_sort(ghosts.begin(), ghosts.end(),
                   [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
  for (const auto& [node, ghost] : ghosts) {
    if (shared_node.empty() || shared_node.back() != node) {
      shared_node.push_back(node);
      shared_begin.push_back(static_cast<int>(shared_slot.size()));
    }
    shared_slot.push_back(ghost);
  }
  shared_begin.push_back(static_cast<int>(shared_slot.size()));
}

std::size_t Batches::bytes() const {
  return sizeof(int) * (gather.capacity() + scatter.capacity() + shared_node.capacity() +
                        shared_begin.capacity() + shared_slot.capacity());
}

void Batches::sum_ghosts(double* f, int dim) const {
  parallel_for(shared_node.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (int s = shared_begin[i]; s < shared_begin[i + 1]; ++s)
        for (int c = 0; c < dim; ++c) {
          double& ghost = f[shared_slot[s] * dim + c];
          f[shared_node[i] * dim + c] += ghost;
          ghost = 0;
        }
  });
  for (int c = 0; c < dim; ++c) f[(slots - 1) * dim + c] = 0;
}

}  // namespace femsph::fem
