#include "sph/operators/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sph/operators/pair_scales.hpp"

namespace femsph::sph {

namespace {

constexpr double met = 1e-12;  ///< stop at this residual, divided by the largest component of the areas
constexpr int most_newton = 20, least_iterations = 100;
constexpr double most_work = 5e7;  ///< iterations x pairs, a second or two

template <class Vectors>
double largest_of(const Vectors& v) {
  double most = 0;
  for (const auto& x : v)
    for (double c : x) most = std::max(most, std::abs(c));
  return most;
}

/// Solves J W J^T lambda = r by conjugate gradients, preconditioned by the diagonal, until no component of
/// the residual exceeds `enough`. The matrix is singular (an affine lambda changes nothing), but r is in its
/// range. Returns lambda.
template <int dim>
typename PairScales<dim>::Vectors solve(PairScales<dim>& pairs, typename PairScales<dim>::Vectors r,
                                        double enough, int most, int& iterations) {
  using Vectors = typename PairScales<dim>::Vectors;
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
  // Round-off may keep the residual above `enough`.
  const int last = std::min(most, iterations + std::max(500, 2 * iterations));
  while (largest_of(r) > enough && iterations < last) {
    ++iterations;
    pairs.apply(p, q);
    const double pq = pairs.product(p, q);
    if (!(pq > 0)) break;
    const double step = rz / pq;
    for (std::size_t i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) lambda[i][a] += step * p[i][a], r[i][a] -= step * q[i][a];
    precondition();
    const double next = pairs.product(r, z), ratio = next / rz;
    rz = next;
    for (std::size_t i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) p[i][a] = z[i][a] + ratio * p[i][a];
  }
  return lambda;
}

/// The bound on the iterations: large for a small body.
template <int dim>
int most_iterations(const PairScales<dim>& pairs) {
  return int(std::max(double(least_iterations), most_work / double(pairs.pairs())));
}

/// Newton's method, as A depends on the scales through B too. It converges quadratically, so each linear
/// system is only solved to about the residual of the next step.
template <int dim>
Projection project_in(const Particles& particles, const RowSource& source, const std::vector<Point>& area,
                      const std::vector<double>& volume) {
  using Vectors = typename PairScales<dim>::Vectors;
  Projection out;
  PairScales<dim> pairs(particles, source, volume);
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
    for (double factor = 1; factor > 0.1;
         factor *= 0.5) {  // a shorter step where the full one makes the residual larger
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
