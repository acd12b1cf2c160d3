// Cuts the cells of a mesh into pieces of about the spacing. The corners of the pieces become the particles.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "model/scene/shapes/multilinear.hpp"
#include "sph/particles/particles.hpp"

namespace femsph::sph {

namespace {

/// Bounds on the edges of the pieces, in spacings d, so that one smoothing length serves all of them. Up to
/// sqrt(2) the kernel (radius 2 d) still reaches neighbours on the diagonal. At 0.4 a particle has 6 times
/// (2D) to 15 times (3D) as many neighbours, which only costs time.
constexpr double least = 0.35, most = 1.6;

/// Groups of edges that must be cut into the same number of pieces (opposite edges of a cell, and so on from
/// cell to cell), each with the lengths of its shortest and its longest edge. One edge is the root of a
/// group.
class EdgeGroups {
 public:
  explicit EdgeGroups(const CellMesh& mesh) : mesh_(mesh) {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (int a = 0; a < mesh.dim; ++a) {
        int first = -1;
        each_edge(int(c), a, [&](int p, int q) {
          const int edge = number_of(p, q);
          if (first < 0)
            first = edge;
          else
            parent_[std::size_t(root(edge))] = root(first);
        });
      }
    shortest_.assign(parent_.size(), 1e300);
    longest_.assign(parent_.size(), 0);
    for (const auto& [ends, edge] : edges_) {
      const Point &p = mesh.vertices[std::size_t(ends.first)], &q = mesh.vertices[std::size_t(ends.second)];
      const double length = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      const std::size_t r = std::size_t(root(edge));
      shortest_[r] = std::min(shortest_[r], length), longest_[r] = std::max(longest_[r], length);
    }
  }

  /// Number of pieces along each axis of a cell.
  std::array<int, 3> pieces(int cell, double spacing) {
    std::array<int, 3> n{1, 1, 1};
    for (int a = 0; a < mesh_.dim; ++a)
      each_edge(
          cell, a, [&](int p, int q) { n[a] = pieces_of(std::size_t(root(number_of(p, q))), spacing); });
    return n;
  }
  /// Lengths of the shortest and of the longest piece edge of the whole mesh, m.
  std::pair<double, double> range(double spacing) {
    std::pair<double, double> out{1e300, 0};
    for (std::size_t r = 0; r < parent_.size(); ++r)
      if (root(int(r)) == int(r)) {
        const int n = pieces_of(r, spacing);
        out = {std::min(out.first, shortest_[r] / n), std::max(out.second, longest_[r] / n)};
      }
    return out;
  }
  bool suits(double spacing) {
    const auto [low, high] = range(spacing);
    return low >= least * spacing && high <= most * spacing;
  }

 private:
  template <class Act>
  void each_edge(int cell, int axis, Act&& act) const {
    const auto& v = mesh_.cells[std::size_t(cell)];
    for (int k = 0; k < 1 << mesh_.dim; ++k)
      if (!(k >> axis & 1)) act(v[std::size_t(k)], v[std::size_t(k | 1 << axis)]);
  }
  int number_of(int p, int q) {
    const auto [at, is_new] = edges_.try_emplace({std::min(p, q), std::max(p, q)}, int(parent_.size()));
    if (is_new) parent_.push_back(at->second);
    return at->second;
  }
  int root(int edge) {
    while (parent_[std::size_t(edge)] != edge)
      edge = parent_[std::size_t(edge)] = parent_[std::size_t(parent_[std::size_t(edge)])];
    return edge;
  }
  /// The number for which the geometric mean of the shortest and the longest piece is nearest to the spacing.
  int pieces_of(std::size_t group, double spacing) const {
    return std::max(
        1, int(std::min(1e6, std::round(std::sqrt(shortest_[group] * longest_[group]) / spacing))));
  }

  const CellMesh& mesh_;
  std::map<std::pair<int, int>, int> edges_;
  std::vector<int> parent_;
  std::vector<double> shortest_, longest_;
};

/// Numbers the corners of the pieces. Cells share a corner that lies on a common vertex, edge or face. Its
/// key does not depend on how the cells are oriented: the vertices of that edge or face, and the integer
/// weight of each (its shape function times the product of the numbers of pieces, with common factors
/// removed).
class Corners {
 public:
  explicit Corners(CellMesh& mesh) : mesh_(mesh) {}
  int vertex(const std::array<int, 8>& cell, const Patch& patch, const std::array<int, 3>& n,
             const std::array<int, 3>& at) {
    Key key;
    key.fill({-1, 0});
    std::size_t count = 0;
    for (int v = 0; v < patch.corner_count(); ++v) {
      long weight = 1;
      for (int a = 0; a < patch.k; ++a)
        if (n[a] != 0) weight *= v >> a & 1 ? at[a] : n[a] - at[a];
      if (weight == 0) continue;
      if (count == key.size()) return add(patch, n, at);  // inside a hexahedron: not shared
      key[count++] = {cell[std::size_t(v)], weight};
    }
    if (patch.k == 2 && count == 4) return add(patch, n, at);
    // Along an axis where the corner is at an end of the cell, the number of pieces must not matter.
    long common = 0;
    for (std::size_t k = 0; k < count; ++k) common = std::gcd(common, key[k].second);
    for (std::size_t k = 0; k < count; ++k) key[k].second /= common;
    std::sort(key.begin(), key.begin() + std::ptrdiff_t(count));
    const auto [known, is_new] = at_.try_emplace(key, 0);
    if (is_new) known->second = add(patch, n, at);
    return known->second;
  }

 private:
  using Key = std::array<std::pair<int, long>, 4>;
  int add(const Patch& patch, const std::array<int, 3>& n, const std::array<int, 3>& at) {
    mesh_.vertices.push_back(patch.at({double(at[0]) / n[0], double(at[1]) / n[1], double(at[2]) / n[2]}));
    return int(mesh_.vertices.size()) - 1;
  }
  CellMesh& mesh_;
  std::map<Key, int> at_;
};

void cut_cell(const CellMesh& mesh, const std::array<int, 8>& cell, const std::array<int, 3>& n,
              Corners& corners, CellMesh& out) {
  Patch patch{mesh.dim, {}};
  for (int v = 0; v < patch.corner_count(); ++v)
    patch.corners[std::size_t(v)] = mesh.vertices[std::size_t(cell[std::size_t(v)])];
  const int levels = mesh.dim == 3 ? n[2] : 0;
  std::vector<int> number;
  for (int k = 0; k <= levels; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) number.push_back(corners.vertex(cell, patch, n, {i, j, k}));
  for (int k = 0; k < std::max(1, levels); ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 8> piece{};
        for (int v = 0; v < patch.corner_count(); ++v)
          piece[std::size_t(v)] = number[std::size_t(
              i + (v & 1) + (n[0] + 1) * (j + (v >> 1 & 1) + (n[1] + 1) * (k + (v >> 2))))];
        out.cells.push_back(piece);
      }
}

}  // namespace

std::optional<CellMesh> cut_to_spacing(const CellMesh& mesh, double spacing, std::string& why) {
  EdgeGroups groups(mesh);
  if (!groups.suits(spacing)) {
    const auto [low, high] = groups.range(spacing);
    why = fmt::format(
        "its mesh can only be cut into pieces of {:.3g} to {:.3g} mm, too uneven for particles {:.3g} mm "
        "apart: the particles are placed on a lattice instead, and stress near curved and slanted sides is "
        "less accurate",
        low * 1e3, high * 1e3, spacing * 1e3);
    for (double finer = spacing / 1.1; finer > spacing / 12; finer /= 1.1)
      if (groups.suits(finer)) {
        why += fmt::format("; with a spacing of {:.3g} mm they follow the mesh", finer * 1e3);
        break;
      }
    return std::nullopt;
  }
  CellMesh out;
  out.dim = mesh.dim;
  Corners corners(out);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    cut_cell(mesh, mesh.cells[c], groups.pieces(int(c), spacing), corners, out);
  return out;
}

}  // namespace femsph::sph
