#include "sph/operators/projection.hpp"

#include <algorithm>
#include <cmath>

#include "model/numerics/parallel.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph::sph {

namespace {

constexpr double met = 1e-12;  ///< of the largest area vector: where to stop
constexpr int most_newton = 20, least_iterations = 100;
constexpr double most_work = 5e7;  ///< iterations x pairs, a second or two

/// The rows' pairs in one array, each with the pair that looks back: from j, or from the particle whose image
/// j is.
template <int dim>
class Pairs {
 public:
  using Vector = std::array<double, dim>;
  using Vectors = std::vector<Vector>;

  Pairs(const Particles& particles, const RowSource& rows, const std::vector<double>& volume)
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
    look_back();
  }

  std::size_t size() const { return n_; }
  std::size_t pairs() const { return index_.size(); }
  bool complete() const { return complete_; }
  std::vector<double>& scale() { return scale_; }

  /// B and G of the scales as they are now; false if some B does not exist.
  bool refresh() {
    bool all = true;
    for (std::size_t i = 0; i < n_; ++i) all = invert(i) && all;
    return all;
  }
  /// A_i.
  void area(Vectors& out) {
    parallel_for(n_, 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i)
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) change_[k] = times(scale_[k], b_[k]);
    });
    gather(out);
  }
  /// dA = J W J^T lambda: what the change of scales W J^T lambda makes of A, to first order.
  void apply(const Vectors& lambda, Vectors& out) {
    const Vectors& all = with_images(lambda);
    parallel_for(n_, 1, [&](std::size_t from, std::size_t to) {
      Vectors difference;
      for (std::size_t i = from; i < to; ++i) changes(i, all, difference, [](std::size_t, double) {});
    });
    gather(out);
  }
  /// scale += factor W J^T lambda.
  void add(const Vectors& lambda, double factor, std::vector<double>& scale) {
    const Vectors& all = with_images(lambda);
    Vectors difference;
    for (std::size_t i = 0; i < n_; ++i)
      changes(i, all, difference, [&](std::size_t k, double change) { scale[k] += factor * change; });
  }
  /// The diagonal of J W J^T, without the part of J that B's own change brings.
  void diagonal(Vectors& out) const {
    out.assign(n_, Vector{});
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
        const Vector here = b_[k], there = b_[back_[k]];
        for (int a = 0; a < dim; ++a)
          out[i][a] += start_[k] * std::pow(volume_[i] * here[a], 2) +
                       start_[back_[k]] * std::pow(volume_[own(index_[k])] * there[a], 2);
      }
  }
  /// Sum over the whole body with its images, by the particles' parts.
  double product(const Vectors& u, const Vectors& v) const {
    return parallel_sum(n_, [&](std::size_t from, std::size_t to) {
      double sum = 0;
      for (std::size_t i = from; i < to; ++i)
        for (int a = 0; a < dim; ++a) sum += p_.part[i] * u[i][a] * v[i][a];
      return sum;
    });
  }

  std::vector<Row> rows() const {
    return made([&](std::size_t i, std::size_t k) {
      const double mean = 0.5 * (scale_[k] + kernel_share(i, k) * scale_[back_[k]]);
      return neighbour(k, scale_[k], mean);
    });
  }
  std::vector<Row> adjoint() const {
    return made([&](std::size_t i, std::size_t k) {
      const double a = kernel_share(i, k) * scale_[back_[k]];
      return neighbour(k, a, a);
    });
  }

 private:
  std::size_t own(int j) const {
    return std::size_t(j) < n_ ? std::size_t(j) : p_.mirrored[std::size_t(j) - n_].of;
  }
  double sign(int j, int a) const {
    return std::size_t(j) < n_ ? 1.0 : p_.mirrored[std::size_t(j) - n_].sign[std::size_t(a)];
  }
  static Vector times(double factor, Vector v) {
    for (double& x : v) x *= factor;
    return v;
  }
  double kernel_share(std::size_t i, std::size_t k) const {
    return p_.kernel_volume[std::size_t(index_[k])] / p_.kernel_volume[i];
  }
  const Vectors& with_images(const Vectors& own) {
    if (p_.mirrored.empty()) return own;
    all_ = own;
    for (const Mirrored& m : p_.mirrored) {
      all_.push_back(own[m.of]);
      for (int a = 0; a < dim; ++a) all_.back()[a] *= m.sign[std::size_t(a)];
    }
    return all_;
  }

  void look_back() {
    back_.assign(index_.size(), 0);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
        const std::size_t m = own(index_[k]);
        double best = 1e-12 * p_.spacing * p_.spacing;
        bool found = false;
        for (std::size_t l = begin_[m]; l < begin_[m + 1]; ++l) {
          if (own(index_[l]) != i) continue;
          double off = 0;
          for (int a = 0; a < dim; ++a) off += std::pow(x_[l][a] + sign(index_[k], a) * x_[k][a], 2);
          if (off < best) best = off, back_[k] = l, found = true;
        }
        complete_ = complete_ && found;
      }
  }

  bool invert(std::size_t i) {
    double m[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, dim == 2 ? 1.0 : 0.0}};
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c) m[a][c] += scale_[k] * x_[k][a] * x_[k][c];
    double cofactor[3][3];
    for (int a = 0; a < 3; ++a)
      for (int c = 0; c < 3; ++c) {
        const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        cofactor[a][c] = m[a1][c1] * m[a2][c2] - m[a1][c2] * m[a2][c1];
      }
    const double det = m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
      for (int a = 0; a < dim; ++a) {
        b_[k][a] = 0;
        for (int c = 0; c < dim; ++c) b_[k][a] += cofactor[c][a] / det * x_[k][c];
      }
    return det > 1e-6 && m[0][0] > 0 && cofactor[2][2] > 0;
  }

  /// Of row i: d scale = W J^T lambda, told to `take`, and the change of G that it makes:
  ///   d scale_ij = W V_i (lambda_ij - H x_ij) . b_ij,  H = sum_j lambda_ij (x) G_ij;   dG_ij = d scale_ij
  ///   b_ij - (sum_m d scale_im b_im (x) x_im) G_ij.
  template <class Take>
  void changes(std::size_t i, const Vectors& lambda, Vectors& difference, Take&& take) {
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
  /// sum_k V_k change_ki - V_i sum_j change_ij.
  void gather(Vectors& out) const {
    out.resize(n_);
    parallel_for(n_, 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        Vector sum{};
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) {
          const Vector &back = change_[back_[k]], &forth = change_[k];
          const bool image = std::size_t(index_[k]) >= n_;
          const double there = volume_[std::size_t(index_[k])];
          for (int a = 0; a < dim; ++a)
            sum[a] += there * (image ? sign(index_[k], a) : 1.0) * back[a] - volume_[i] * forth[a];
        }
        out[i] = sum;
      }
    });
  }

  Neighbour neighbour(std::size_t k, double factor, double scale) const {
    Neighbour n{index_[k], {0, 0, 0}, scale};
    for (int a = 0; a < dim; ++a) n.w[a] = factor * x_[k][a];
    return n;
  }
  template <class Make>
  std::vector<Row> made(Make&& make) const {
    std::vector<Row> out(n_);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k) out[i].push_back(make(i, k));
    return out;
  }

  const Particles& p_;
  std::size_t n_;
  const std::vector<double>& volume_;
  std::vector<std::size_t> begin_, back_;
  std::vector<int> index_;
  std::vector<double> start_, scale_;
  std::vector<Vector> x_, b_, change_, all_;  ///< x_ij, B_i x_ij
  bool complete_ = true;
};

template <class Vectors>
double largest_of(const Vectors& v) {
  double most = 0;
  for (const auto& x : v)
    for (double c : x) most = std::max(most, std::abs(c));
  return most;
}

/// Conjugate gradients on J W J^T lambda = r, scaled by the diagonal, until no component of what is left
/// exceeds `enough`. The matrix is singular (A does not see affine lambda), r is in its range. Returns
/// lambda.
template <int dim>
typename Pairs<dim>::Vectors solve(Pairs<dim>& pairs, typename Pairs<dim>::Vectors r, double enough, int most,
                                   int& iterations) {
  using Vectors = typename Pairs<dim>::Vectors;
  const std::size_t n = pairs.size();
  Vectors diagonal, lambda(n), z(n), p, q;
  pairs.diagonal(diagonal);
  const auto precondition = [&] {
    for (std::size_t i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) z[i][a] = r[i][a] / diagonal[i][a];
  };
  precondition();
  p = z;
  double rz = pairs.product(r, z);
  const int last = std::min(
      most, iterations + std::max(500, 2 * iterations));  // round-off may not let it come as near as asked
  while (largest_of(r) > enough && iterations < last) {
    ++iterations;
    pairs.apply(p, q);
    const double pq = pairs.product(p, q);
    if (!(pq > 0)) break;
    const double step = rz / pq;
    for (std::size_t i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) lambda[i][a] += step * p[i][a], r[i][a] -= step * q[i][a];
    precondition();
    const double next = pairs.product(r, z), turn = next / rz;
    rz = next;
    for (std::size_t i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) p[i][a] = z[i][a] + turn * p[i][a];
  }
  return lambda;
}

/// Iterations that a body can have: many if it is small.
template <int dim>
int most_iterations(const Pairs<dim>& pairs) {
  return int(std::max(double(least_iterations), most_work / double(pairs.pairs())));
}

/// Newton's method: A depends on the scales through B too. It is quadratic, so that each solution need be no
/// better than the next residual.
template <int dim>
Projection project_in(const Particles& particles, const RowSource& source, const std::vector<Point>& area,
                      const std::vector<double>& volume) {
  using Vectors = typename Pairs<dim>::Vectors;
  Projection out;
  Pairs<dim> pairs(particles, source, volume);
  Vectors target(pairs.size()), r;
  for (std::size_t i = 0; i < target.size(); ++i)
    for (int a = 0; a < dim; ++a) target[i][a] = area[i][std::size_t(a)];
  const double unit = largest_of(target);
  const auto residual = [&] {
    if (!pairs.refresh()) return std::numeric_limits<double>::infinity();
    pairs.area(r);
    for (std::size_t i = 0; i < r.size(); ++i)
      for (int a = 0; a < dim; ++a) r[i][a] = target[i][a] - r[i][a];
    return largest_of(r) / unit;
  };
  out.left = pairs.complete() ? residual() : std::numeric_limits<double>::infinity();
  const double first = out.left;
  if ((out.needless = first < worth_projecting)) return out;
  const int most = most_iterations(pairs);
  for (int newton = 0;
       newton < most_newton && out.left > met && std::isfinite(out.left) && out.iterations < most; ++newton) {
    const double enough = std::max(std::clamp(0.3 * out.left, 1e-5, 0.05) * out.left, 0.3 * met);
    const Vectors lambda = solve<dim>(pairs, r, enough * unit, most, out.iterations);
    const std::vector<double> before = pairs.scale();
    double left = 0;
    for (double factor = 1; factor > 0.1; factor *= 0.5) {  // shorter steps where the full one leads away
      std::vector<double> trial = before;
      pairs.scale() = before;
      pairs.refresh();
      pairs.add(lambda, factor, trial);
      pairs.scale() = trial;
      if (left = residual(); left < out.left) break;
    }
    if (!(left < out.left)) {
      pairs.scale() = before;
      residual();
      break;
    }
    out.left = left;
  }
  if (!(out.left <= 0.1 * first)) return out;
  out.rows = stored_rows(pairs.rows());
  out.adjoint = stored_rows(pairs.adjoint());
  return out;
}

}  // namespace

Projection project(const Particles& particles, const RowSource& rows, const std::vector<Point>& area,
                   const std::vector<double>& volume) {
  return particles.dim == 2 ? project_in<2>(particles, rows, area, volume)
                            : project_in<3>(particles, rows, area, volume);
}

}  // namespace femsph::sph
