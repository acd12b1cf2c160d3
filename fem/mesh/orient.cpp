#include <set>
#include <utility>

#include "fem/mesh/grid.hpp"

namespace femsph::fem {

bool edges_agree(const CellMesh& grid) {
  std::set<std::pair<int, int>> seen;
  for (const auto& cell : grid.cells)
    for (int d = 0; d < grid.dim; ++d)
      for (int a = 0; a < 1 << grid.dim; ++a) {
        if (a >> d & 1) continue;
        const int from = cell[a], to = cell[a | 1 << d];
        if (seen.count({to, from})) return false;
        seen.insert({from, to});
      }
  return true;
}

}  // namespace femsph::fem
