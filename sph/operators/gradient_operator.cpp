#include "sph/operators/gradient_operator.hpp"

#include <fmt/format.h>

#include "model/numerics/vectors.hpp"
#include "sph/operators/projection.hpp"

namespace femsph::sph {

std::unique_ptr<RowSource> rows_of(const Particles& particles, const Kernel& kernel, const Options& options) {
  if (options.boundary == Boundary::virtual_particles) return virtual_rows(particles, kernel);
  return particles.regular ? lattice_rows(particles, kernel) : search_rows(particles, kernel);
}

OperatorRows operator_rows(const Particles& particles, const Kernel& kernel, const Options& options,
                           const std::vector<Point>& area) {
  OperatorRows out{rows_of(particles, kernel, options), {}, false, 1, {}};
  if (options.boundary == Boundary::virtual_particles) out.adjoint = transposed_rows(particles, *out.rows);
  if (area.empty()) return out;
  // sum x . a = dim V, with V the volume that the facets enclose (divergence theorem). The stress acts on it.
  double enclosed = 0, volume = 0;
  for (std::size_t i = 0; i < area.size(); ++i)
    enclosed += dot(particles.position[i], area[i]) / particles.dim, volume += particles.own_volume(i);
  const double fill = enclosed / volume;
  std::vector<double> filled = particles.volume;
  for (double& v : filled) v *= fill;
  // Area vectors of the body together with its mirror images.
  std::vector<Point> whole = area;
  for (std::size_t i = 0; i < area.size(); ++i)
    whole[i] = particles.along_planes(i, (1 / particles.part[i]) * area[i]);
  Projection made = project(particles, *out.rows, whole, filled);
  if (made.needless) return out;
  if (!made.rows || made.left > 1e-3)
    out.note = fmt::format(
        "a uniform stress is in balance with its surface tractions only to {:.1g} % of them{}; a larger "
        "smoothing length (more neighbours) may help",
        100 * made.left, made.rows ? "" : ", because no weights were found that make it exact");
  if (!made.rows) return out;
  out.rows = std::move(made.rows), out.adjoint = std::move(made.adjoint);
  out.projected = true, out.fill = fill;
  return out;
}

Tensor<double, 3> correction_of(const Particles& particles, std::size_t particle, const RowSource& rows,
                                const Row& row, Boundary boundary) {
  const int dim = particles.dim;
  const Point& x = particles.position[particle];
  Tensor<double, 3> M{};
  if (boundary == Boundary::weight) {
    for (int a = 0; a < dim; ++a) M[a][a] = rows.kernel_sum(particle);
  } else {
    for (const Neighbour& j : row)
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c)
          M[a][c] += j.w[a] * (particles.position[std::size_t(j.index)][std::size_t(c)] - x[std::size_t(c)]);
  }
  if (dim == 2) M[2][2] = 1;
  const auto [cofactor, det] = cofactors(M);
  if (!(det > 1e-6))
    throw Refusal(fmt::format(
        "particle {} at ({:g}, {:g}, {:g}) m has too few neighbours for a corrected gradient; "
        "take a finer spacing or a larger smoothing length",
        particle, x[0], x[1], x[2]));
  Tensor<double, 3> B;
  for (int a = 0; a < 3; ++a)
    for (int c = 0; c < 3; ++c) B[a][c] = cofactor[c][a] / det;
  return B;
}

}  // namespace femsph::sph
