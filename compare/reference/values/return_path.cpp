// Perfect plasticity under a strain rate that is orthogonal to the stress deviator: the deviator rotates on
// the yield surface (Prandtl-Reuss equations).

#include <cmath>
#include <stdexcept>

#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {
namespace {

/// sigma_xx. The initial strain takes the body to its yield surface; a constant deviatoric strain rate e then
/// acts at a right angle to it. The deviator has the constant norm S = sqrt(2/3) sigma_y, and its angle theta
/// to e falls from a right angle by d theta/dt = -(2G |e|/S) sin theta.
double return_path_xx(const Scene& scene, double time) {
  const auto inner = [](const Matrix& a, const Matrix& b) {
    return a[0][0] * b[0][0] + a[1][1] * b[1][1] + a[2][2] * b[2][2];
  };
  const auto deviator_along_axes = [](const Matrix& a) {
    double trace = 0, across = 0, size = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        (i == j ? trace : across) += i == j ? a[i][j] : std::abs(a[i][j]), size += std::abs(a[i][j]);
    return std::abs(trace) + across <= 1e-6 * size;
  };
  if (scene.bodies.size() != 1 || scene.bodies[0].rigid || scene.plane == Plane::stress || scene.large_motion)
    throw std::runtime_error(
        "this theory needs one deformable body in plane strain or in three dimensions, with small motion");
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.plasticity() || !m.plasticity()->perfect() || scene.initial_displacements.size() != 1 ||
      scene.initial_velocities.size() != 1)
    throw std::runtime_error(
        "this theory needs a material without hardening, one initial displacement and one initial velocity");
  const InitialVelocity& start = scene.initial_velocities[0];
  const Matrix &a = scene.initial_displacements[0].gradient, &b = start.gradient;
  const double size_a = std::sqrt(inner(a, a)), size_b = std::sqrt(inner(b, b)),
               shear = m.young / (2 * (1 + m.poisson));
  const double S = std::sqrt(2.0 / 3) * m.plasticity()->yield;
  if (!(size_b > 0) || std::abs(inner(a, b)) > 1e-9 * size_a * size_b || !(2 * shear * size_a >= S) ||
      !deviator_along_axes(a) || !deviator_along_axes(b) || start.profile || start.spin != Point{})
    throw std::runtime_error(
        "this theory needs an initial strain beyond yield and a strain rate orthogonal to it, both "
        "deviatoric and without shear");
  const double theta = 2 * std::atan(std::exp(-2 * shear * size_b * time / S));
  return S * (std::sin(theta) * a[0][0] / size_a + std::cos(theta) * b[0][0] / size_b);
}

}  // namespace

std::vector<Theory> return_path_values() {
  using Depends = Theory::Depends;
  return {
      {"return_path_xx", "Pa",
       "sigma_xx without hardening: the angle from the strain rate e to the stress deviator is theta = 2 "
       "atan(exp(-2 G |e| t/S))",
       Depends::on_time, [](const Scene& scene, const Point&, double t) { return return_path_xx(scene, t); }},
  };
}

}  // namespace femsph::compare
