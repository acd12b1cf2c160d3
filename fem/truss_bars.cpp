#include "fem/truss_bars.hpp"

namespace femsph::fem {

TrussBars::TrussBars(const std::vector<BarRow>& rows, const std::vector<Point>& nodes, int dim,
                     bool large_motion)
    : dim_(dim), large_(large_motion) {
  for (const BarRow& row : rows)
    for (std::size_t k = 0; k < row.segment.size(); ++k) {
      if (row.segment[k] <= 0) continue;
      const std::size_t a = row.points[k], b = row.points[k + 1];
      Point middle;
      for (int c = 0; c < 3; ++c) middle[c] = 0.5 * (nodes[a][c] + nodes[b][c]);
      trusses_.push_back(
          {{a, b}, row.bar, row.axis, row.area, row.segment[k], row.gap[k], middle, row.law, {}});
    }
}

double TrussBars::strain(const Truss& truss, const double* u, bool large, double (&pull)[3]) const {
  const std::size_t dim = static_cast<std::size_t>(dim_);
  double g[3] = {};
  for (std::size_t c = 0; c < dim; ++c)
    g[c] = (u[truss.node[1] * dim + c] - u[truss.node[0] * dim + c]) / truss.gap;
  return large ? bar_strain<FiniteRotation, 3>(g, truss.axis, pull)
               : bar_strain<SmallStrain, 3>(g, truss.axis, pull);
}

void TrussBars::add_mass(std::vector<double>& mass) const {
  for (const Truss& t : trusses_)
    for (const std::size_t node : t.node) mass[node] += 0.5 * t.law.density * t.area * t.length;
}

void TrussBars::add_force(const double* u, double* f) {
  const std::size_t dim = static_cast<std::size_t>(dim_);
  for (Truss& t : trusses_) {
    double pull[3];
    const double e = strain(t, u, large_, pull),
                 force = t.area * t.length / t.gap * t.law.advance(e, t.state);
    for (std::size_t c = 0; c < dim; ++c) {
      f[t.node[0] * dim + c] += force * pull[c];
      f[t.node[1] * dim + c] -= force * pull[c];
    }
  }
}

void TrussBars::add_stiffness(const double* x, double* y) const {
  const std::size_t dim = static_cast<std::size_t>(dim_);
  for (const Truss& t : trusses_) {
    double pull[3];
    const double force = t.area * t.length / t.gap * t.law.young * strain(t, x, false, pull);
    const std::size_t axis = static_cast<std::size_t>(t.axis);
    y[t.node[0] * dim + axis] -= force;
    y[t.node[1] * dim + axis] += force;
  }
}

double TrussBars::strain_energy(const double* u) const {
  double sum = 0;
  for (const Truss& t : trusses_) sum += t.area * t.length * t.law.stored(strain(t, u), t.state);
  return sum;
}

double TrussBars::dissipated_energy() const {
  double sum = 0;
  for (const Truss& t : trusses_) sum += t.area * t.length * t.state.dissipated;
  return sum;
}

std::vector<BarPiece> TrussBars::pieces(const double* u) const {
  std::vector<BarPiece> out;
  for (const Truss& t : trusses_) {
    const double e = strain(t, u);
    out.push_back({t.bar, t.middle, t.area, t.length, e, t.law.stress(e, t.state), t.state.plastic_strain});
  }
  return out;
}

}  // namespace femsph::fem
