#pragma once
// Scenes built in code, and a plain reference of the SPH operator: loops over all pairs, one neighbour at a
// time.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/shapes/box.hpp"
#include "sph/operators/kernel.hpp"
#include "sph/particles/particles.hpp"
#include "sph/sph.hpp"
#include "state_of.hpp"

namespace femsph::test {

inline constexpr double infinite = std::numeric_limits<double>::infinity(),
                        nan = std::numeric_limits<double>::quiet_NaN();

inline Scene box_scene(Plane plane, Point size, bool large = false) {
  Scene s;
  s.plane = plane;
  s.large_motion = large;
  s.materials["steel"] = Material{"steel", 2.1e11, 0.3, 7850};
  const int dim = plane == Plane::none ? 3 : 2;
  s.bodies.push_back(
      {"block", std::make_shared<Box>(dim, Point{0.01, -0.02, 0}, size), dim == 2 ? 0.1 : 1.0, "steel"});
  s.duration = 1e-3;
  return s;
}

inline sph::Options classic(double spacing, sph::MassRule mass,
                            sph::Boundary boundary = sph::Boundary::none) {
  sph::Options o;
  o.formulation = "classic";
  o.spacing = spacing;
  o.mass = mass;
  o.boundary = boundary;
  return o;
}

inline sph::Options corrected(double spacing, double smoothing = 1.0) {
  sph::Options o;
  o.spacing = spacing;
  o.smoothing = smoothing;
  return o;
}

/// A flat vector with random values at the points and 0 in the padding.
inline AlignedVector<double> random_vector(const Discretization& d, unsigned seed, double size = 1e-5) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-size, size);
  AlignedVector<double> x(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (int c = 0; c < d.layout().dim; ++c) x[d.layout().at(i, c)] = value(random);
  return x;
}

/// u = A X at the points.
inline AlignedVector<double> linear_vector(const Discretization& d, const double (&A)[3][3]) {
  AlignedVector<double> x(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (int r = 0; r < d.layout().dim; ++r)
      for (int c = 0; c < d.layout().dim; ++c) x[d.layout().at(i, r)] += A[r][c] * d.position(i)[c];
  return x;
}

inline double dot(const AlignedVector<double>& a, const AlignedVector<double>& b) {
  double s = 0;
  for (std::size_t i = 0; i < a.size(); ++i) s += a[i] * b[i];
  return s;
}
inline double largest(const AlignedVector<double>& a) {
  double m = 0;
  for (double x : a) m = std::max(m, std::abs(x));
  return m;
}

/// A displacement that is even across the planes x = 0 and y = 0, as symmetry planes there allow.
inline AlignedVector<double> even_field(const Discretization& d) {
  AlignedVector<double> u(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i) {
    const Point x = d.position(i);
    u[d.layout().at(i, 0)] = 1e-3 * x[0] * (1 + 30 * x[1] * x[1]);
    u[d.layout().at(i, 1)] = -2e-3 * x[1] * std::cos(9 * x[0]);
  }
  return u;
}

inline AlignedVector<double> force(Discretization& d, const AlignedVector<double>& u) {
  AlignedVector<double> f(d.layout().size, 0.0), v(d.layout().size, 0.0),
      viscous(d.has_viscosity() ? d.layout().size : 0, 0.0);
  d.internal_force(u.data(), v.data(), 0, f.data(), viscous.empty() ? nullptr : viscous.data());
  return f;
}

/// The particles of a quarter (x, y > 0) of a plane body feel the accelerations of their twins in the whole,
/// to `tolerance` of the largest.
inline void expect_same_accelerations(Discretization& part, Discretization& whole, double tolerance) {
  const auto f = force(whole, even_field(whole)), g = force(part, even_field(part));
  for (std::size_t i = 0; i < part.layout().points; ++i) {
    const Point x = part.position(i);
    std::size_t twin = 0;
    for (std::size_t j = 0; j < whole.layout().points; ++j)
      if (std::hypot(whole.position(j)[0] - x[0], whole.position(j)[1] - x[1]) < 1e-9) twin = j;
    for (int c = 0; c < 2; ++c)
      EXPECT_NEAR(
          g[part.layout().at(i, c)] / part.mass()[i], f[whole.layout().at(twin, c)] / whole.mass()[twin],
          tolerance * largest(f) / whole.mass()[twin]);
  }
}

/// f_k = -sum_i V_i (s_i B_i) : d H_i / d u_k with H_i = sum_j K_j (u_j - u_i) (x) grad_i W_ij, small strain,
/// all pairs; if corrected with B_i = (sum_j K_j grad W (x) x_ij)^-1 and whole cells K = d^dim, else K = V. A
/// box on a lattice. Plane stress or 3D by the law. No hourglass control, no projection.
AlignedVector<double> plain_force(const Scene& scene, const sph::Options& options, const Discretization& d,
                                  const AlignedVector<double>& u);

}  // namespace femsph::test
