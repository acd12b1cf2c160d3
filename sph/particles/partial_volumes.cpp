#include "sph/particles/partial_volumes.hpp"

#include <algorithm>
#include <cmath>

#include "model/scene/shapes/multilinear.hpp"
#include "sph/particles/mesh_cells.hpp"

namespace femsph::sph {

namespace {

enum : char { empty, full, cut };

/// Integrates the hat functions of all places of a lattice over a shape.
class HatIntegrals {
 public:
  HatIntegrals(const Shape& shape, const Lattice& lattice, const std::vector<MirrorPlane>& planes)
      : shape_(shape), lattice_(lattice), planes_(planes), dim_(shape.dim()) {
    for (int a = 0; a < dim_; ++a) cells_[a] = lattice.count[a] - 1;
    spacing_ = *std::min_element(lattice.spacing.begin(), lattice.spacing.begin() + dim_);
    out_.share.assign(lattice_.at.size(), 0.0);
    out_.border.assign(lattice_.at.size(), 0);
    state_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2], full);
  }

  /// Finds which cells are full, empty or cut by a side.
  void classify() {
    const CellMesh* mesh = shape_.cells();
    if (mesh) mark_sides(*mesh);
    if (!shape_.is_box()) each_cell([&](const std::array<int, 3>& c) { classify_cell(c, mesh != nullptr); });
  }
  bool any_cut() const { return std::find(state_.begin(), state_.end(), cut) != state_.end(); }

  PartialVolumes integrate() {
    const CellMesh* mesh = shape_.cells();
    classify();
    each_cell([&](const std::array<int, 3>& c) {
      const char state = state_[cell(c)];
      for (int v = 0; v < 1 << dim_; ++v) {
        if (state == full) out_.share[node(c, v)] += 1.0 / (1 << dim_);
        if (state == cut) out_.border[node(c, v)] = 1;
      }
    });
    if (mesh)
      add_mesh(*mesh);
    else
      each_cell([&](const std::array<int, 3>& c) {
        if (state_[cell(c)] == cut) add_lines(c);
      });
    match();
    return std::move(out_);
  }

 private:
  std::size_t cell(const std::array<int, 3>& c) const {
    return std::size_t(c[0]) + std::size_t(cells_[0]) * (std::size_t(c[1]) + std::size_t(cells_[1]) * c[2]);
  }
  std::size_t node(const std::array<int, 3>& c, int v) const {
    return std::size_t(c[0] + (v & 1)) +
           std::size_t(lattice_.count[0]) *
               (std::size_t(c[1] + (v >> 1 & 1)) +
                std::size_t(lattice_.count[1]) * std::size_t(c[2] + (v >> 2 & 1)));
  }
  /// The point of cell c with local coordinates xi, each from 0 to 1.
  Point at(const std::array<int, 3>& c, const std::array<double, 3>& xi) const {
    Point x = lattice_.origin;
    for (int a = 0; a < dim_; ++a) x[a] += (c[a] + xi[a]) * lattice_.spacing[a];
    return x;
  }
  template <class Act>
  void each_cell(Act&& act) const {
    for (int k = 0; k < cells_[2]; ++k)
      for (int j = 0; j < cells_[1]; ++j)
        for (int i = 0; i < cells_[0]; ++i) act({i, j, k});
  }
  double hat(int v, const std::array<double, 3>& xi) const {
    double phi = 1;
    for (int a = 0; a < dim_; ++a) phi *= v >> a & 1 ? xi[a] : 1 - xi[a];
    return phi;
  }

  /// Marks the lattice cells whose inside is crossed by the surface of the mesh. A surface that lies on
  /// planes of the lattice crosses none.
  void mark_sides(const CellMesh& mesh) {
    for (const Facet& facet : boundary_of(topology_of(dim_, mesh.cells))) {
      Patch patch{dim_ - 1, {}};
      for (int v = 0; v < patch.corner_count(); ++v)
        patch.corners[v] = mesh.vertices[facet.points[lexicographic[std::size_t(v)]]];
      const auto n = cuts(patch, 0.5 * spacing_);
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          mark_piece(
              patch, {double(i) / n[0], double(j) / n[1]}, {double(i + 1) / n[0], double(j + 1) / n[1]});
    }
  }
  void mark_piece(const Patch& patch, const std::array<double, 2>& low, const std::array<double, 2>& high) {
    std::array<int, 3> first{}, last{};
    for (int a = 0; a < dim_; ++a) {
      double least = 0, most = 0;
      for (int v = 0; v < patch.corner_count(); ++v) {
        const double x = (patch.at({v & 1 ? high[0] : low[0], v >> 1 & 1 ? high[1] : low[1], 0})[a] -
                          lattice_.origin[a]) /
                         lattice_.spacing[a];
        least = v ? std::min(least, x) : x, most = v ? std::max(most, x) : x;
      }
      first[a] = std::max(0, int(std::floor(least + 1e-6)));
      last[a] = std::min(cells_[a] - 1, int(std::ceil(most - 1e-6)) - 1);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i) state_[cell({i, j, k})] = cut;
  }

  /// Finds whether a cell is full, empty or cut, by sample points in it. For a mesh the cut cells are marked
  /// already, and the centre decides.
  void classify_cell(const std::array<int, 3>& c, bool mesh) {
    if (state_[cell(c)] == cut) return;
    const double e = 1e-6;  // keeps off the sides of the cell, which may be sides of the body
    if (mesh) {
      state_[cell(c)] = shape_.contains(at(c, {0.5, 0.5, 0.5}), e * spacing_) ? full : empty;
      return;
    }
    int inside = 0, all = dim_ == 3 ? 27 : 9;
    const double xi[3] = {e, 0.5, 1 - e};
    for (int s = 0; s < all; ++s)
      inside += shape_.contains(at(c, {xi[s % 3], xi[s / 3 % 3], xi[s / 9]}), 0.0);
    state_[cell(c)] = inside == all ? full : inside == 0 ? empty : cut;
  }

  /// Integrates the hat functions over the part of a cut cell inside the body, along lines parallel to one
  /// axis: the one most nearly normal to the side. On each line the pieces inside are found by bisection, and
  /// on them the integral is exact.
  void add_lines(const std::array<int, 3>& c) {
    const int axis = axis_across(c), lines = dim_ == 3 ? 6 : 12;
    for (int q = 0; q < (dim_ == 3 ? lines * lines : lines); ++q) {
      std::array<double, 3> xi{};
      const double across[2] = {(q % lines + 0.5) / lines, (q / lines + 0.5) / lines};
      for (int a = 0, k = 0; a < dim_; ++a)
        if (a != axis) xi[a] = across[k++];
      const double weight = dim_ == 3 ? 1.0 / (lines * lines) : 1.0 / lines;
      for (const auto& [from, to] : pieces_inside(c, xi, axis))
        for (int v = 0; v < 1 << dim_; ++v) {
          xi[axis] = v >> axis & 1 ? 1 : 0;  // makes the factor along `axis` 1: `along` takes its place
          const double along = v >> axis & 1 ? 0.5 * (to * to - from * from)
                                             : (to - from) - 0.5 * (to * to - from * from);
          out_.share[node(c, v)] += weight * hat(v, xi) * along;
        }
    }
  }
  /// The axis along which the two halves of the cell differ most in how much of them is inside.
  int axis_across(const std::array<int, 3>& c) const {
    int best = 0, most = -1;
    for (int axis = 0; axis < dim_; ++axis) {
      int difference = 0;
      const double xi[3] = {0.1, 0.5, 0.9};
      for (int s = 0; s < (dim_ == 3 ? 27 : 9); ++s) {
        std::array<double, 3> p{xi[s % 3], xi[s / 3 % 3], xi[s / 9]};
        const double side = p[axis] - 0.5;
        if (side != 0) difference += (side > 0 ? 1 : -1) * int(shape_.contains(at(c, p), 0.0));
      }
      if (std::abs(difference) > most) most = std::abs(difference), best = axis;
    }
    return best;
  }
  /// Intervals of the line inside the body, in local coordinates; pieces shorter than 1/8 may be missed.
  std::vector<std::pair<double, double>> pieces_inside(const std::array<int, 3>& c, std::array<double, 3> xi,
                                                       int axis) const {
    const auto inside = [&](double t) {
      xi[axis] = t;
      return shape_.contains(at(c, xi), 0.0);
    };
    constexpr int samples = 8;
    std::vector<std::pair<double, double>> out;
    bool before = inside(1e-9);
    double from = 0;
    for (int k = 1; k <= samples; ++k) {
      const double end = k == samples ? 1 - 1e-9 : double(k) / samples;
      const bool now = inside(end);
      if (now != before) {
        double low = double(k - 1) / samples, high = end;
        for (int halves = 0; halves < 28; ++halves) {
          const double middle = 0.5 * (low + high);
          (inside(middle) == before ? low : high) = middle;
        }
        if (now)
          from = high;
        else
          out.push_back({from, low});
      }
      before = now;
    }
    if (before) out.push_back({from, 1.0});
    return out;
  }

  /// Numbers of pieces no larger than `size` along each axis of a patch.
  static std::array<int, 3> cuts(const Patch& patch, double size) {
    std::array<int, 3> n{1, 1, 1};
    for (int a = 0; a < patch.k; ++a)
      for (int v = 0; v < patch.corner_count(); ++v) {
        if (v >> a & 1) continue;
        const Point &p = patch.corners[v], &q = patch.corners[v | 1 << a];
        n[a] = std::max(n[a], int(std::ceil(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / size)));
      }
    return n;
  }

  /// Integrates the hat functions of all places at cut cells again, over the cells of the mesh. Each is
  /// divided into pieces small against a lattice cell, with two Gauss points in each direction of a piece.
  void add_mesh(const CellMesh& mesh) {
    for (std::size_t i = 0; i < out_.share.size(); ++i)
      if (out_.border[i]) out_.share[i] = 0;
    std::vector<char> near(state_.size(), 0);  // cells that have such a place, and their neighbours
    each_cell([&](const std::array<int, 3>& c) {
      bool any = false;
      for (int v = 0; v < 1 << dim_; ++v) any = any || out_.border[node(c, v)];
      if (!any) return;
      std::array<int, 3> first{}, last{};
      for (int a = 0; a < 3; ++a)
        first[a] = std::max(0, c[a] - 1), last[a] = std::min(cells_[a] - 1, c[a] + 1);
      for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
          for (int i = first[0]; i <= last[0]; ++i) near[cell({i, j, k})] = 1;
    });
    double volume = 1;
    for (int a = 0; a < dim_; ++a) volume *= lattice_.spacing[a];
    const double g[2] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
    for (const auto& own : mesh.cells) {
      Patch patch{dim_, {}};
      for (int v = 0; v < patch.corner_count(); ++v) patch.corners[v] = mesh.vertices[own[v]];
      const auto n = cuts(patch, spacing_ / (dim_ == 3 ? 3 : 6));
      for (int s = 0; s < n[0] * n[1] * n[2]; ++s) {
        const std::array<int, 3> at{s % n[0], s / n[0] % n[1], s / n[0] / n[1]};
        const auto inner = [&](double x, double y, double z) {
          return std::array<double, 3>{(at[0] + x) / n[0], (at[1] + y) / n[1], (at[2] + z) / n[2]};
        };
        if (!near[cell(cell_of(patch.at(inner(0.5, 0.5, 0.5))).first)]) continue;
        for (int q = 0; q < patch.corner_count(); ++q) {
          const auto xi = inner(g[q & 1], g[q >> 1 & 1], g[q >> 2 & 1]);
          const double weight = determinant(patch, xi) / (patch.corner_count() * volume * n[0] * n[1] * n[2]);
          const auto [c, part] = cell_of(patch.at(xi));
          for (int v = 0; v < 1 << dim_; ++v)
            if (out_.border[node(c, v)]) out_.share[node(c, v)] += weight * hat(v, part);
        }
      }
    }
  }
  /// The lattice cell that holds x, and the local coordinates of x in it.
  std::pair<std::array<int, 3>, std::array<double, 3>> cell_of(const Point& x) const {
    std::pair<std::array<int, 3>, std::array<double, 3>> out{};
    for (int a = 0; a < dim_; ++a) {
      const double t = (x[a] - lattice_.origin[a]) / lattice_.spacing[a];
      out.first[a] = std::clamp(int(std::floor(t)), 0, cells_[a] - 1);
      out.second[a] = std::clamp(t - out.first[a], 0.0, 1.0);
    }
    return out;
  }

  /// Removes the error of the integration from volume and first moment.
  void match() {
    if (std::none_of(out_.border.begin(), out_.border.end(), [](char b) { return b != 0; })) return;
    std::vector<Point> places(out_.share.size());
    double volume = 1;
    for (int a = 0; a < dim_; ++a) volume *= lattice_.spacing[a];
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::size_t n = std::size_t(lattice_.count[0]), m = std::size_t(lattice_.count[1]);
      const std::size_t index[3] = {i % n, i / n % m, i / n / m};
      places[i] = lattice_.origin;
      for (int a = 0; a < dim_; ++a) places[i][a] += double(index[a]) * lattice_.spacing[a];
      out_.share[i] *= volume;
    }
    match_moments(shape_, planes_, places, out_.border, out_.share);
    for (double& share : out_.share) share /= volume;
  }

  const Shape& shape_;
  const Lattice& lattice_;
  const std::vector<MirrorPlane> planes_;
  int dim_;
  double spacing_ = 0;
  std::array<int, 3> cells_{1, 1, 1};
  std::vector<char> state_;
  PartialVolumes out_;
};

}  // namespace

PartialVolumes partial_volumes(const Shape& shape, const Lattice& lattice,
                               const std::vector<MirrorPlane>& planes) {
  return HatIntegrals(shape, lattice, planes).integrate();
}

bool follows_sides(const Shape& shape, const Lattice& lattice) {
  HatIntegrals integrals(shape, lattice, {});
  integrals.classify();
  return !integrals.any_cut();
}

}  // namespace femsph::sph
