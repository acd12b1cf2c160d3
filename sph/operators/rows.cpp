#include "sph/operators/rows.hpp"

#include <algorithm>
#include <cmath>

#include "sph/particles/cell_list.hpp"

namespace femsph::sph {

namespace {

/// A neighbour on the lattice, `by` cells away along each axis.
struct Offset {
  std::array<int, 3> by;
  double gradient[3];  ///< grad_i W_ij
  double steepness, value;
};

std::vector<Offset> offsets_of(const Particles& p, const Kernel& kernel) {
  std::vector<Offset> out;
  std::array<int, 3> reach{};
  for (int a = 0; a < p.dim; ++a) reach[a] = int(std::ceil(kernel.radius() / p.lattice.spacing[a]));
  for (int k = -reach[2]; k <= reach[2]; ++k)
    for (int j = -reach[1]; j <= reach[1]; ++j)
      for (int i = -reach[0]; i <= reach[0]; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        const Point x{i * p.lattice.spacing[0], j * p.lattice.spacing[1], k * p.lattice.spacing[2]};
        const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (r >= kernel.radius() * (1 - 1e-9)) continue;
        const double s = kernel.steepness(r);
        out.push_back({{i, j, k}, {s * x[0], s * x[1], s * x[2]}, s, kernel.value(r)});
      }
  return out;
}

/// Neighbours by their place on the lattice.
class LatticeRows : public RowSource {
 public:
  LatticeRows(const Particles& particles, const Kernel& kernel)
      : p_(particles), self_(kernel.value(0)), offsets_(offsets_of(particles, kernel)) {}
  void row(std::size_t i, Row& out) const override {
    out.clear();
    const auto& at = p_.lattice.place[i];
    for (const Offset& o : offsets_) {
      const int j = p_.lattice.particle(at[0] + o.by[0], at[1] + o.by[1], at[2] + o.by[2]);
      if (j < 0) continue;
      const double v = p_.kernel_volume[std::size_t(j)];
      out.push_back({j, {v * o.gradient[0], v * o.gradient[1], v * o.gradient[2]}, v * o.steepness});
    }
  }
  double kernel_sum(std::size_t i) const override {
    double sum = p_.kernel_volume[i] * self_;
    const auto& at = p_.lattice.place[i];
    for (const Offset& o : offsets_) {
      const int j = p_.lattice.particle(at[0] + o.by[0], at[1] + o.by[1], at[2] + o.by[2]);
      if (j >= 0) sum += p_.kernel_volume[std::size_t(j)] * o.value;
    }
    return sum;
  }

 protected:
  const Particles& p_;
  double self_;
  std::vector<Offset> offsets_;
};

/// As LatticeRows, with virtual particles beyond the sides, whose displacements depend linearly on the
/// particles.
class VirtualRows final : public LatticeRows {
 public:
  using LatticeRows::LatticeRows;
  void row(std::size_t i, Row& out) const override {
    out.clear();
    const auto& at = p_.lattice.place[i];
    for (const Offset& o : offsets_) {
      const std::array<int, 3> ghost{at[0] + o.by[0], at[1] + o.by[1], at[2] + o.by[2]};
      const Neighbour full{0,
                           {p_.cell * o.gradient[0], p_.cell * o.gradient[1], p_.cell * o.gradient[2]},
                           p_.cell * o.steepness};
      spread(ghost, full, out);
    }
    std::erase_if(out, [&](const Neighbour& n) { return n.index == int(i); });
  }
  double kernel_sum(std::size_t) const override {
    double sum = p_.cell * self_;
    for (const Offset& o : offsets_) sum += p_.cell * o.value;
    return sum;
  }

 private:
  /// The value at a place along one axis as a sum over places in the body: the place itself, or, beyond a
  /// side, 2 u(on the side) - u(mirrored place).
  struct Part {
    int at;
    double coefficient;
  };
  std::vector<Part> parts(int at, int axis) const {
    const int last = p_.lattice.count[std::size_t(axis)] - 1;
    if (at >= 0 && at <= last) return {{at, 1.0}};
    const int side = at < 0 ? 0 : last;
    return {{side, 2.0}, {std::clamp(2 * side - at, 0, last), -1.0}};
  }

  void spread(const std::array<int, 3>& at, const Neighbour& full, Row& out) const {
    for (const Part& z : parts(at[2], 2))
      for (const Part& y : parts(at[1], 1))
        for (const Part& x : parts(at[0], 0)) {
          const int j = p_.lattice.particle(x.at, y.at, z.at);
          const double coefficient = x.coefficient * y.coefficient * z.coefficient;
          auto found = std::find_if(out.begin(), out.end(), [&](const Neighbour& n) { return n.index == j; });
          if (found == out.end()) found = out.insert(out.end(), {j, {0, 0, 0}, 0});
          for (int a = 0; a < 3; ++a) found->w[a] += coefficient * full.w[a];
          found->scale += coefficient * full.scale;
        }
  }
};

/// Neighbours found by a grid of cells, for particles that are not on a lattice.
class SearchRows final : public RowSource {
 public:
  SearchRows(const Particles& particles, const Kernel& kernel)
      : p_(particles), kernel_(kernel), cells_(particles.position, particles.dim, kernel.radius()) {}
  void row(std::size_t i, Row& out) const override {
    out.clear();
    around(i, [&](int j, const Point& x, double r) {
      const double s = p_.kernel_volume[std::size_t(j)] * kernel_.steepness(r);
      out.push_back({j, {s * x[0], s * x[1], s * x[2]}, s});
    });
    std::sort(
        out.begin(), out.end(), [](const Neighbour& a, const Neighbour& b) { return a.index < b.index; });
  }
  double kernel_sum(std::size_t i) const override {
    double sum = p_.kernel_volume[i] * kernel_.value(0);
    around(i, [&](int j, const Point&, double r) {
      sum += p_.kernel_volume[std::size_t(j)] * kernel_.value(r);
    });
    return sum;
  }

 private:
  template <class Take>
  void around(std::size_t i, Take&& take) const {
    const Point& xi = p_.position[i];
    cells_.around(xi, [&](int j) {
      if (j == int(i)) return;
      const Point& xj = p_.position[std::size_t(j)];
      const Point x{xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
      const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      if (r < kernel_.radius() * (1 - 1e-9)) take(j, x, r);
    });
  }
  const Particles& p_;
  Kernel kernel_;
  CellList cells_;
};

class StoredRows final : public RowSource {
 public:
  StoredRows(std::vector<Row> rows) : rows_(std::move(rows)) {}
  void row(std::size_t i, Row& out) const override { out = rows_[i]; }
  /// Not used: only boundary weights and surface_weight_loss() need the sum, and their rows are not stored.
  double kernel_sum(std::size_t) const override { return 1; }

 private:
  std::vector<Row> rows_;
};

}  // namespace

std::unique_ptr<RowSource> lattice_rows(const Particles& particles, const Kernel& kernel) {
  return std::make_unique<LatticeRows>(particles, kernel);
}
std::unique_ptr<RowSource> virtual_rows(const Particles& particles, const Kernel& kernel) {
  return std::make_unique<VirtualRows>(particles, kernel);
}
std::unique_ptr<RowSource> search_rows(const Particles& particles, const Kernel& kernel) {
  return std::make_unique<SearchRows>(particles, kernel);
}

std::unique_ptr<RowSource> stored_rows(std::vector<Row> rows) {
  return std::make_unique<StoredRows>(std::move(rows));
}

std::unique_ptr<RowSource> transposed_rows(const Particles& particles, const RowSource& rows) {
  std::vector<Row> out(particles.size());
  Row row;
  for (std::size_t j = 0; j < particles.size(); ++j) {
    rows.row(j, row);
    for (const Neighbour& n : row) {
      const std::size_t i = std::size_t(n.index);
      const double v = -particles.volume[j] / particles.volume[i];
      out[i].push_back({int(j), {v * n.w[0], v * n.w[1], v * n.w[2]}, -v * n.scale});
    }
  }
  return std::make_unique<StoredRows>(std::move(out));
}

}  // namespace femsph::sph
