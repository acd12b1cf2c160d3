#include "sph_support.hpp"

namespace femsph::test {

namespace {

struct Matrix {
  double a[3][3] = {};
};

Matrix inverse(const Matrix& m, int dim) {
  Matrix out;
  if (dim == 2) {
    const double det = m.a[0][0] * m.a[1][1] - m.a[0][1] * m.a[1][0];
    out.a[0][0] = m.a[1][1] / det, out.a[1][1] = m.a[0][0] / det, out.a[0][1] = -m.a[0][1] / det,
    out.a[1][0] = -m.a[1][0] / det;
    return out;
  }
  double det = 0;
  for (int i = 0; i < 3; ++i)
    det += m.a[0][i] *
           (m.a[1][(i + 1) % 3] * m.a[2][(i + 2) % 3] - m.a[1][(i + 2) % 3] * m.a[2][(i + 1) % 3]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out.a[j][i] = (m.a[(i + 1) % 3][(j + 1) % 3] * m.a[(i + 2) % 3][(j + 2) % 3] -
                     m.a[(i + 1) % 3][(j + 2) % 3] * m.a[(i + 2) % 3][(j + 1) % 3]) /
                    det;
  return out;
}

}  // namespace

AlignedVector<double> plain_force(const Scene& scene, const sph::Options& options, const Discretization& d,
                                  const AlignedVector<double>& u) {
  const int dim = d.layout().dim;
  const std::size_t n = d.layout().points;
  const auto law = std::get<LinearElastic>(scene.material_of(scene.bodies[0]).law(scene.plane));
  const sph::Kernel kernel(options.kernel, dim, options.smoothing * d.spacing());
  const double thickness = scene.bodies[0].thickness, density = law.density;
  const auto volume = [&](std::size_t i) { return d.mass()[i] / density / thickness; };
  // A box filled by a lattice: a neighbour counts with its whole cell in the kernel sums, where it is asked
  // to.
  const bool whole = options.formulation == "corrected" && options.kernel_volume == sph::KernelVolume::whole;
  const auto kernel_volume = [&](std::size_t j) { return whole ? std::pow(d.spacing(), dim) : volume(j); };
  const auto gradient = [&](std::size_t i, std::size_t j, double(&g)[3], double(&x)[3]) {
    double r2 = 0;
    for (int c = 0; c < 3; ++c) x[c] = d.position(j)[c] - d.position(i)[c], r2 += x[c] * x[c];
    const double r = std::sqrt(r2), s = r < kernel.radius() * (1 - 1e-9) ? kernel.steepness(r) : 0.0;
    for (int c = 0; c < 3; ++c) g[c] = s * x[c];
    return s > 0;
  };
  AlignedVector<double> f(d.layout().size, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    Matrix H, M;
    double g[3], x[3];
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i || !gradient(i, j, g, x)) continue;
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c) {
          H.a[r][c] += kernel_volume(j) * (u[d.layout().at(j, r)] - u[d.layout().at(i, r)]) * g[c];
          M.a[r][c] += kernel_volume(j) * g[r] * x[c];
        }
    }
    Matrix B;
    for (int r = 0; r < 3; ++r) B.a[r][r] = 1;
    if (options.formulation == "corrected") B = inverse(M, dim);
    Matrix G, Q;
    double trace = 0;
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c)
        for (int k = 0; k < dim; ++k) G.a[r][c] += H.a[r][k] * B.a[k][c];
    for (int r = 0; r < dim; ++r) trace += G.a[r][r];
    for (int r = 0; r < dim; ++r)
      for (int c = 0; c < dim; ++c)
        for (int k = 0; k < dim; ++k)
          Q.a[r][c] += (law.mu * (G.a[r][k] + G.a[k][r]) + (r == k ? law.lambda * trace : 0.0)) * B.a[k][c];
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i || !gradient(i, j, g, x)) continue;
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c) {
          const double part = volume(i) * thickness * Q.a[r][c] * kernel_volume(j) * g[c];
          f[d.layout().at(j, r)] -= part;
          f[d.layout().at(i, r)] += part;
        }
    }
  }
  return f;
}

}  // namespace femsph::test
