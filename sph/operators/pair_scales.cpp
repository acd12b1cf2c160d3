#include "sph/operators/pair_scales.hpp"

#include <cmath>

#include "model/numerics/parallel.hpp"

namespace femsph::sph {

template <int dim>
PairScales<dim>::PairScales(const Particles& particles, const RowSource& rows,
                            const std::vector<double>& volume)
    : p_(particles), n_(particles.size()), volume_(volume) {
  Row row;
  begin_.push_back(0);
  for (std::size_t i = 0; i < n_; ++i) {
    rows.row(i, row);
    for (const Neighbour& n : row) {
      index_.push_back(n.index);
      start_.push_back(n.scale);
      Vector x;
      for (int a = 0; a < dim; ++a) x[a] = p_.position[std::size_t(n.index)][a] - p_.position[i][a];
      x_.push_back(x);
    }
    begin_.push_back(index_.size());
  }
  scale_ = start_;
  b_.resize(index_.size());
  change_.resize(index_.size());
  find_pairs_that_look_back();
}

template <int dim>
bool PairScales<dim>::refresh() {
  bool all = true;
  for (std::size_t i = 0; i < n_; ++i) all = invert(i) && all;
  return all;
}

template <int dim>
void PairScales<dim>::area(Vectors& out) {
  parallel_for(n_, 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) change_[k] = times(scale_[k], b_[k]);
  });
  gather(out);
}

template <int dim>
void PairScales<dim>::apply(const Vectors& lambda, Vectors& out) {
  const Vectors& all = with_images(lambda);
  parallel_for(n_, 1, [&](std::size_t from, std::size_t to) {
    Vectors difference;
    for (std::size_t i = from; i < to; ++i) changes(i, all, difference, [](std::size_t, double) {});
  });
  gather(out);
}

template <int dim>
void PairScales<dim>::add(const Vectors& lambda, double factor, std::vector<double>& scale) {
  const Vectors& all = with_images(lambda);
  Vectors difference;
  for (std::size_t i = 0; i < n_; ++i)
    changes(i, all, difference, [&](std::size_t k, double change) { scale[k] += factor * change; });
}

template <int dim>
void PairScales<dim>::diagonal(Vectors& out) const {
  out.assign(n_, Vector{});
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
      const Vector here = b_[k], there = b_[back_[k]];
      for (int a = 0; a < dim; ++a)
        out[i][a] += start_[k] * std::pow(volume_[i] * here[a], 2) +
                     start_[back_[k]] * std::pow(volume_[p_.own(std::size_t(index_[k]))] * there[a], 2);
    }
}

template <int dim>
double PairScales<dim>::product(const Vectors& u, const Vectors& v) const {
  return parallel_sum(n_, [&](std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i)
      for (int a = 0; a < dim; ++a) sum += p_.part[i] * u[i][a] * v[i][a];
    return sum;
  });
}

template <int dim>
std::vector<Row> PairScales<dim>::rows() const {
  return made([&](std::size_t i, std::size_t k) {
    const double mean = 0.5 * (scale_[k] + kernel_share(i, k) * scale_[back_[k]]);
    return neighbour(k, scale_[k], mean);
  });
}

template <int dim>
std::vector<Row> PairScales<dim>::adjoint() const {
  return made([&](std::size_t i, std::size_t k) {
    const double a = kernel_share(i, k) * scale_[back_[k]];
    return neighbour(k, a, a);
  });
}

template <int dim>
auto PairScales<dim>::with_images(const Vectors& own) -> const Vectors& {
  if (p_.mirrored.empty()) return own;
  all_ = own;
  for (const Mirrored& m : p_.mirrored) {
    all_.push_back(own[m.of]);
    for (int a = 0; a < dim; ++a) all_.back()[a] *= m.sign[std::size_t(a)];
  }
  return all_;
}

template <int dim>
void PairScales<dim>::find_pairs_that_look_back() {
  back_.assign(index_.size(), 0);
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
      const std::size_t m = p_.own(std::size_t(index_[k]));
      double best = 1e-12 * p_.spacing * p_.spacing;
      bool found = false;
      for (std::size_t l = begin_[m]; l < begin_[m + 1]; ++l) {
        if (p_.own(std::size_t(index_[l])) != i) continue;
        double off = 0;
        for (int a = 0; a < dim; ++a)
          off += std::pow(x_[l][a] + p_.sign(std::size_t(index_[k]), a) * x_[k][a], 2);
        if (off < best) best = off, back_[k] = l, found = true;
      }
      complete_ = complete_ && found;
    }
}

template <int dim>
bool PairScales<dim>::invert(std::size_t i) {
  Tensor<double, 3> M{};
  if (dim == 2) M[2][2] = 1;
  for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
    for (int a = 0; a < dim; ++a)
      for (int c = 0; c < dim; ++c) M[a][c] += scale_[k] * x_[k][a] * x_[k][c];
  const auto [cofactor, det] = cofactors(M);
  for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
    for (int a = 0; a < dim; ++a) {
      b_[k][a] = 0;
      for (int c = 0; c < dim; ++c) b_[k][a] += cofactor[c][a] / det * x_[k][c];
    }
  return det > 1e-6 && M[0][0] > 0 && cofactor[2][2] > 0;  // positive definite
}

/// Row i of d scale = W J^T lambda, passed to `take`, and the change of G = scale b that follows, which is
/// stored in change_:
///   d scale_ij = W V_i (lambda_ij - H x_ij) . b_ij,  H = sum_j lambda_ij (x) G_ij
///   dG_ij = d scale_ij b_ij - (sum_m d scale_im b_im (x) x_im) G_ij
template <int dim>
template <class Take>
void PairScales<dim>::changes(std::size_t i, const Vectors& lambda, Vectors& difference, Take&& take) {
  double H[dim][dim] = {}, T[dim][dim] = {};
  const std::size_t first = begin_[i];
  const Vector here = lambda[i];
  difference.resize(std::max(difference.size(), begin_[i + 1] - first));
  for (std::size_t k = first; k < begin_[i + 1]; ++k) {
    const Vector &there = lambda[std::size_t(index_[k])], G = times(scale_[k], b_[k]);
    Vector& d = difference[k - first];
    for (int a = 0; a < dim; ++a) d[a] = there[a] - here[a];
    for (int a = 0; a < dim; ++a)
      for (int c = 0; c < dim; ++c) H[a][c] += d[a] * G[c];
  }
  for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
    const Vector &d = difference[k - first], &bk = b_[k];
    double misfit = 0;
    for (int a = 0; a < dim; ++a) {
      double off = d[a];
      for (int c = 0; c < dim; ++c) off -= H[a][c] * x_[k][c];
      misfit += off * bk[a];
    }
    const double change = start_[k] * volume_[i] * misfit;
    take(k, change);
    change_[k] = times(change, bk);
    for (int a = 0; a < dim; ++a)
      for (int c = 0; c < dim; ++c) T[a][c] += change_[k][a] * x_[k][c];
  }
  for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
    const Vector G = times(scale_[k], b_[k]);
    for (int a = 0; a < dim; ++a)
      for (int c = 0; c < dim; ++c) change_[k][a] -= T[a][c] * G[c];
  }
}

/// out_i = sum_k V_k change_ki - V_i sum_j change_ij.
template <int dim>
void PairScales<dim>::gather(Vectors& out) const {
  out.resize(n_);
  parallel_for(n_, 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      Vector sum{};
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
        const Vector &back = change_[back_[k]], &forth = change_[k];
        const bool image = std::size_t(index_[k]) >= n_;
        const double there = volume_[std::size_t(index_[k])];
        for (int a = 0; a < dim; ++a)
          sum[a] += there * (image ? p_.sign(std::size_t(index_[k]), a) : 1.0) * back[a] -
                    volume_[i] * forth[a];
      }
      out[i] = sum;
    }
  });
}

template <int dim>
Neighbour PairScales<dim>::neighbour(std::size_t k, double factor, double scale) const {
  Neighbour n{index_[k], {0, 0, 0}, scale};
  for (int a = 0; a < dim; ++a) n.w[a] = factor * x_[k][a];
  return n;
}

template <int dim>
template <class Make>
std::vector<Row> PairScales<dim>::made(Make&& make) const {
  std::vector<Row> out(n_);
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) out[i].push_back(make(i, k));
  return out;
}

template class PairScales<2>;
template class PairScales<3>;

}  // namespace femsph::sph
