// Open seams: cells that touch without common vertices, so that they are not connected.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/scene/shapes/mesh_check.hpp"
#include "model/scene/shapes/multilinear.hpp"

namespace femsph {
namespace {

// Two places that are nearer than this share of the shortest adjacent edge are meant to be the same: gaps of
// that size come from the tolerance of CAD kernels.
constexpr double near = 1e-3;

double apart(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double shortest_edge(const CellMesh& mesh, int cell) {
  double h = 1e300;
  const auto& v = mesh.cells[cell];
  for (int a = 0; a < 1 << mesh.dim; ++a)
    for (int d = 0; d < mesh.dim; ++d)
      if (!(a >> d & 1)) h = std::min(h, apart(mesh.vertices[v[a]], mesh.vertices[v[a | 1 << d]]));
  return h;
}

/// A side as a patch, whose corners are in lexicographic order.
Patch patch_of(const CellMesh& mesh, const FreeSide& side) {
  Patch patch{mesh.dim - 1, {}};
  patch.corners[0] = mesh.vertices[side.loop[0]];
  patch.corners[1] = mesh.vertices[side.loop[1]];
  if (mesh.dim == 3)
    patch.corners[2] = mesh.vertices[side.loop[3]], patch.corners[3] = mesh.vertices[side.loop[2]];
  return patch;
}

class Seams {
 public:
  Seams(const CellMesh& mesh, const std::vector<FreeSide>& sides) : mesh_(mesh), sides_(sides) {
    std::vector<BoxGrid::Box> boxes;
    for (const FreeSide& side : sides) {
      boxes.push_back(bounding_box(patch_of(mesh, side)));
      edge_.push_back(shortest_edge(mesh, side.cell));
      for (int v = 0; v < 1 << (mesh.dim - 1); ++v) {
        const auto [at, is_new] = edge_at_.try_emplace(side.loop[v], edge_.back());
        at->second = std::min(at->second, edge_.back());
      }
    }
    const BoxGrid grid(boxes);
    for (const auto& [vertex, edge] : edge_at_) look_around(vertex, edge, grid);
  }

  void raise(const std::string& file) const {
    const std::vector<std::pair<int, int>> pairs = coincident_sides();
    const std::string cure =
        "; expected cells that share their vertices (in Gmsh: Coherence), or open_seams = true if a slit is "
        "meant";
    if (!pairs.empty()) {
      const FreeSide &a = sides_[pairs[0].first], &b = sides_[pairs[0].second];
      Point middle{};
      const int corners = 1 << (mesh_.dim - 1);
      for (int v = 0; v < corners; ++v)
        for (int c = 0; c < 3; ++c) middle[c] += mesh_.vertices[a.loop[v]][c] / corners;
      throw std::runtime_error(fmt::format(
          "{} has an open seam: {} pair{} of cell sides that lie on each other and share no side, {}those of "
          "cells {} (vertices {}) and {} (vertices {}) at {}{}{}",
          in_quotes(file), pairs.size(), pairs.size() == 1 ? "" : "s", pairs.size() == 1 ? "" : "first ",
          cell_number(mesh_, a.cell), numbers(a), cell_number(mesh_, b.cell), numbers(b),
          place_text(middle, mesh_.dim),
          hanging_ == 0 ? std::string()
                        : fmt::format(", and {} that hang{}", count(hanging_), hanging_ == 1 ? "s" : ""),
          cure));
    }
    if (hanging_)
      throw std::runtime_error(fmt::format(
          "{} has an open seam: {} lie{} on a side of a cell that does not have {}, {}vertex {} at {} on "
          "cell {} (vertices {}){}",
          in_quotes(file), count(hanging_), hanging_ == 1 ? "s" : "", hanging_ == 1 ? "it" : "them",
          hanging_ == 1 ? "" : "first ", vertex_number(mesh_, hangs_),
          place_text(mesh_.vertices[hangs_], mesh_.dim), cell_number(mesh_, sides_[on_].cell),
          numbers(sides_[on_]), cure));
  }

 private:
  static std::string count(int n) { return fmt::format("{} {}", n, n == 1 ? "vertex" : "vertices"); }

  std::string numbers(const FreeSide& side) const {
    std::string text;
    for (int v = 0; v < 1 << (mesh_.dim - 1); ++v)
      text += fmt::format("{}{}", v ? ", " : "", vertex_number(mesh_, side.loop[v]));
    return text;
  }

  bool has(const FreeSide& side, int vertex) const {
    return std::find(side.loop.begin(), side.loop.begin() + (1 << (mesh_.dim - 1)), vertex) !=
           side.loop.begin() + (1 << (mesh_.dim - 1));
  }

  // Finds the vertices at the same place as this one, and a side that it lies on without being its vertex.
  void look_around(int vertex, double edge, const BoxGrid& grid) {
    const Point& p = mesh_.vertices[vertex];
    int hangs_on = -1;
    grid.any_near(p, near * edge, [&](int s) {
      const FreeSide& side = sides_[s];
      const double tolerance = near * std::min(edge, edge_[s]);
      if (has(side, vertex) || !is_near(patch_of(mesh_, side), p, tolerance)) return false;
      bool on_corner = false;
      for (int v = 0; v < 1 << (mesh_.dim - 1); ++v)
        if (apart(mesh_.vertices[side.loop[v]], p) <= tolerance) {
          on_corner = true;
          auto& least = twin_.try_emplace(vertex, vertex).first->second;
          least = std::min(least, side.loop[v]);
        }
      if (!on_corner) hangs_on = s;
      return false;
    });
    if (hangs_on < 0) return;
    if (hanging_++ == 0) hangs_ = vertex, on_ = hangs_on;
  }

  std::vector<std::pair<int, int>> coincident_sides() const {
    if (twin_.empty()) return {};
    const auto twin = [&](int v) {
      const auto found = twin_.find(v);
      return found == twin_.end() ? v : found->second;
    };
    std::map<SideKey, int> seen;
    std::vector<std::pair<int, int>> pairs;
    for (int s = 0; s < int(sides_.size()); ++s) {
      std::array<int, 4> loop = sides_[s].loop;
      for (int& v : loop) v = v < 0 ? v : twin(v);
      const auto [first, is_new] = seen.try_emplace(side_key(loop, mesh_.dim), s);
      if (!is_new) pairs.emplace_back(first->second, s);
    }
    return pairs;
  }

  const CellMesh& mesh_;
  const std::vector<FreeSide>& sides_;
  std::vector<double> edge_;       // of the cell of each side: the shortest edge, m
  std::map<int, double> edge_at_;  // of each vertex of a free side: the shortest adjacent edge, m
  std::map<int, int> twin_;        // of vertices at the same place: the smallest number among them
  int hanging_ = 0, hangs_ = -1,
      on_ = -1;  // vertices that lie on a side of another cell: how many, the first one, and that side
};

}  // namespace

void check_seams(const CellMesh& mesh, const std::vector<FreeSide>& sides, const std::string& file) {
  Seams(mesh, sides).raise(file);
}

}  // namespace femsph
