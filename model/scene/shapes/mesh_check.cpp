#include "model/scene/shapes/mesh_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/scene/shapes/multilinear.hpp"

namespace femsph {
namespace {

Patch patch_of(const CellMesh& mesh, const std::array<int, 8>& cell) {
  Patch patch{mesh.dim, {}};
  for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[cell[v]];
  return patch;
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// Two corners at the same place: an edge of length zero, for which no time step is small enough.
void require_distinct_corners(const CellMesh& mesh, int c, const std::string& file) {
  const auto& cell = mesh.cells[c];
  const int corners = 1 << mesh.dim;
  double longest = 0;
  for (int a = 1; a < corners; ++a)
    longest = std::max(longest, distance(mesh.vertices[cell[0]], mesh.vertices[cell[a]]));
  for (int a = 0; a < corners; ++a)
    for (int b = a + 1; b < corners; ++b) {
      if (cell[a] == cell[b])
        throw std::runtime_error(fmt::format(
            "cell {} of {} uses vertex {} twice; expected {} different corners", cell_number(mesh, c),
            in_quotes(file), vertex_number(mesh, cell[a]), corners));
      if (distance(mesh.vertices[cell[a]], mesh.vertices[cell[b]]) <= 1e-9 * longest)
        throw std::runtime_error(fmt::format(
            "cell {} of {} has two corners at one place, {}, vertices {} and {}; expected {} different "
            "corners",
            cell_number(mesh, c), in_quotes(file), place_text(mesh.vertices[cell[a]], mesh.dim),
            vertex_number(mesh, cell[a]), vertex_number(mesh, cell[b]), corners));
    }
}

// Reverses mirrored cells (clockwise, or upside down) and refuses folded ones, in which the map from the
// reference cell is singular at a Gauss point, so that shape functions have no gradient there.
void orient(CellMesh& mesh, int c, const std::string& file) {
  auto& cell = mesh.cells[c];
  if (measure(patch_of(mesh, cell)) < 0) {
    if (mesh.dim == 2)
      std::swap(cell[1], cell[2]);
    else
      std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
  }
  if (!(smallest_gauss_jacobian(patch_of(mesh, cell)) > 0))
    throw std::runtime_error(fmt::format(
        "cell {} of {} is folded or flat (its Jacobian is not positive at every Gauss point); expected "
        "convex cells",
        cell_number(mesh, c), in_quotes(file)));
}

struct Side {
  SideKey key;
  std::array<int, 4> loop;
  int cell;
};

std::vector<Side> sorted_sides(const CellMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(mesh.cells.size() * 2 * mesh.dim);
  for_each_side(mesh, [&](int cell, const std::array<int, 4>& loop) {
    sides.push_back({side_key(loop, mesh.dim), loop, cell});
  });
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.cell < b.cell; });
  return sides;
}

// Two cells on different sides of a common side number its vertices in opposite directions.
bool opposite(const Side& a, const Side& b, int dim) {
  if (dim == 2) return a.loop[0] == b.loop[1];
  const auto at = std::find(b.loop.begin(), b.loop.end(), a.loop[0]) - b.loop.begin();
  for (int v = 1; v < 4; ++v)
    if (a.loop[v] != b.loop[(at + 4 - v) % 4]) return false;
  return true;
}

/// Disjoint sets (union-find); each is represented by the smallest number in it.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    a = of(a), b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  int count() {
    int n = 0;
    for (int i = 0; i < int(parent_.size()); ++i) n += parent_[i] == i;
    return n;
  }

 private:
  std::vector<int> parent_;
};

// Joins cells with common sides, and returns the sides that belong to one cell only.
std::vector<FreeSide> join_cells(const CellMesh& mesh, Sets& pieces, const std::string& file) {
  const std::vector<Side> sides = sorted_sides(mesh);
  std::vector<FreeSide> free;
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    for (j = i + 1; j < sides.size() && sides[j].key == sides[i].key; ++j) {
    }
    const auto number = [&](std::size_t k) { return cell_number(mesh, sides[k].cell); };
    if (j > i + 2)
      throw std::runtime_error(fmt::format(
          "cells {}, {} and {} of {} share one side; expected two cells at most", number(i), number(i + 1),
          number(i + 2), in_quotes(file)));
    if (j == i + 1) {
      free.push_back({sides[i].loop, sides[i].cell});
      continue;
    }
    if (!opposite(sides[i], sides[i + 1], mesh.dim))
      throw std::runtime_error(fmt::format(
          "cells {} and {} of {} overlap: they lie on the same side of the side that they share; expected "
          "cells beside each other",
          number(i), number(i + 1), in_quotes(file)));
    pieces.join(sides[i].cell, sides[i + 1].cell);
  }
  return free;
}

// Pieces with common vertices are connected by hinges; others are not connected.
void check_pieces(const CellMesh& mesh, Sets& pieces, const MeshOptions& options, const std::string& file) {
  const int count = pieces.count();
  if (count == options.pieces) return;
  if (options.pieces > 1)
    throw std::runtime_error(fmt::format("{} is in {} piece{} and not in {}, as \"pieces\" says",
                                         in_quotes(file), count, count == 1 ? "" : "s", options.pieces));
  std::vector<int> first_of(mesh.vertices.size(), -1);
  int other = 0;
  for (int c = 0; c < int(mesh.cells.size()); ++c) {
    if (!other && pieces.of(c) != pieces.of(0)) other = c;
    for (int v = 0; v < 1 << mesh.dim; ++v) {
      int& first = first_of[mesh.cells[c][v]];
      if (first < 0) first = c;
      if (pieces.of(first) == pieces.of(c)) continue;
      throw std::runtime_error(fmt::format(
          "{} is in {} pieces that hang together at vertices alone, as cells {} and {} at vertex {}, {}: a "
          "hinge, which takes no moment; expected cells joined by their sides, or pieces = {} if that is "
          "meant",
          in_quotes(file), count, cell_number(mesh, first), cell_number(mesh, c),
          vertex_number(mesh, mesh.cells[c][v]), place_text(mesh.vertices[mesh.cells[c][v]], mesh.dim),
          count));
    }
  }
  throw std::runtime_error(fmt::format(
      "{} is in {} pieces, as cells {} and {} show: nothing holds them together; expected one, or pieces = "
      "{} if that is meant",
      in_quotes(file), count, cell_number(mesh, 0), cell_number(mesh, other), count));
}

}  // namespace

std::size_t cell_number(const CellMesh& mesh, int cell) {
  return mesh.cell_numbers.empty() ? std::size_t(cell) + 1 : mesh.cell_numbers[cell];
}

std::size_t vertex_number(const CellMesh& mesh, int vertex) {
  return mesh.vertex_numbers.empty() ? std::size_t(vertex) + 1 : mesh.vertex_numbers[vertex];
}

std::string place_text(const Point& p, int dim) {
  return dim == 2 ? fmt::format("({:g}, {:g}) mm", 1e3 * p[0], 1e3 * p[1])
                  : fmt::format("({:g}, {:g}, {:g}) mm", 1e3 * p[0], 1e3 * p[1], 1e3 * p[2]);
}

void check_mesh(CellMesh& mesh, const MeshOptions& options, const std::string& file) {
  for (int c = 0; c < int(mesh.cells.size()); ++c) {
    require_distinct_corners(mesh, c, file);
    orient(mesh, c, file);
  }
  Sets pieces(mesh.cells.size());
  const std::vector<FreeSide> free = join_cells(mesh, pieces, file);
  if (!options.open_seams) check_seams(mesh, free, file);
  check_pieces(mesh, pieces, options, file);
}

std::vector<int> cells_with_bad_corners(const CellMesh& mesh) {
  std::vector<int> cells;
  for (int c = 0; c < int(mesh.cells.size()); ++c)
    if (!(smallest_corner_jacobian(patch_of(mesh, mesh.cells[c])) > 0)) cells.push_back(c);
  return cells;
}

}  // namespace femsph
