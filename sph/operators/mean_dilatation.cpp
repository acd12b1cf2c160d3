#include "sph/operators/mean_dilatation.hpp"

#include <algorithm>
#include <numeric>

namespace femsph::sph {

namespace {

double reach_of_averages(const Particles& p) {
  double d = 0;
  for (int a = 0; a < p.dim; ++a) d = std::max(d, p.lattice.spacing[a]);
  return 2 * d;
}

}  // namespace

AveragingRows::AveragingRows(const Particles& particles)
    : p_(particles), cells_(particles.position, particles.dim, reach_of_averages(particles)) {
  // Symmetric Sinkhorn scaling of the unscaled N: r <- sqrt(r / sum_j N_ij r_j). A few iterations are enough,
  // as D keeps constants in any case. Scales within 1e-4 of 1 become 1, so that equal places keep equal rows.
  scale_.assign(p_.position.size(), 1.0);
  struct Bond {
    int to;
    double weight;
  };
  const auto own = [&](std::size_t i) {
    return p_.volume[i] / (p_.cell * p_.fraction[i] * std::pow(2.0, p_.dim));
  };
  Row row;
  double worst = 0;
  for (std::size_t i = 0; i < p_.size() && worst < 1e-4; ++i) {
    collect(i, row);
    worst = std::max(
        worst, std::abs(std::accumulate(row.begin(), row.end(), own(i) - 1,
                                        [](double sum, const Neighbour& n) { return sum + n.w[0]; })));
  }
  if (worst < 1e-4) return;  // the body is a box: nothing to scale
  std::vector<Bond> bonds;   // particle by particle, each with itself first
  std::vector<std::size_t> begin{0};
  for (std::size_t i = 0; i < p_.size(); ++i) {
    collect(i, row);
    bonds.push_back({int(i), own(i)});
    for (const Neighbour& n : row) bonds.push_back({n.index, n.w[0]});
    begin.push_back(bonds.size());
  }
  std::vector<double> next(p_.size());
  for (int iteration = 0; iteration < 12; ++iteration) {
    for (std::size_t i = 0; i < p_.size(); ++i) {
      double sum = 0;
      for (std::size_t k = begin[i]; k < begin[i + 1]; ++k)
        sum += bonds[k].weight * scale_[std::size_t(bonds[k].to)];
      next[i] = std::sqrt(scale_[i] / sum);
    }
    std::copy(next.begin(), next.end(), scale_.begin());
    for (std::size_t k = 0; k < p_.mirrored.size(); ++k) scale_[p_.size() + k] = scale_[p_.mirrored[k].of];
  }
  for (double& r : scale_)
    if (std::abs(r - 1) < 1e-4) r = 1;
}

void AveragingRows::collect(std::size_t i, Row& out) const {
  out.clear();
  const double cell = p_.cell * std::pow(2.0, p_.dim);
  cells_.around(p_.position[i], [&](int j) {
    if (j == int(i)) return;
    double r2 = 0;
    for (int a = 0; a < p_.dim; ++a)
      r2 += std::pow((p_.position[std::size_t(j)][a] - p_.position[i][a]) / p_.lattice.spacing[a], 2);
    if (r2 >= 4 * (1 - 1e-9)) return;
    // On a lattice r2 is a whole number. Rounding makes the rows of equal places equal to the last bit.
    const double steps = p_.regular ? std::round(r2) : r2;
    const double least = std::min(p_.fraction[i], p_.fraction[std::size_t(j)]);
    out.push_back({j, {p_.volume[std::size_t(j)] / (cell * least) * std::exp2(-steps), 0, 0}, 0});
  });
  std::sort(out.begin(), out.end(), [](const Neighbour& a, const Neighbour& b) { return a.index < b.index; });
}

void AveragingRows::row(std::size_t i, Row& out) const {
  collect(i, out);
  for (Neighbour& n : out) n.w[0] *= scale_[i] * scale_[std::size_t(n.index)];
}

}  // namespace femsph::sph
