// Neo-Hookean particles on updated neighbours carry their deformation gradient along.

#include <gtest/gtest.h>

#include "sph/formulations/stretch_point.hpp"
#include "sph_updated_support.hpp"

namespace femsph::test {
namespace {

/// A B, of matrices or of the upper left corners of arrays.
template <int dim, class MatrixA, class MatrixB>
Tensor<double, dim> product(const MatrixA& a, const MatrixB& b) {
  Tensor<double, dim> out{};
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      for (int k = 0; k < dim; ++k) out[i][j] += a[i][k] * b[k][j];
  return out;
}

/// M N^-1 of 2 x 2 or 3 x 3 matrices, by Cramer's rule.
template <int dim>
Tensor<double, dim> over(const Tensor<double, dim>& M, const Tensor<double, dim>& N,
                         double* determinant = nullptr) {
  double n[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, inverse[3][3];
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) n[i][j] = N[i][j];
  const auto minor = [&](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return n[a][c] * n[b][d] - n[a][d] * n[b][c];
  };
  const double det = n[0][0] * minor(0, 0) + n[0][1] * minor(0, 1) + n[0][2] * minor(0, 2);
  if (determinant) *determinant = det;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) inverse[j][i] = minor(i, j) / det;
  return product<dim>(M, inverse);
}

/// A large stretch and shear that grows while the whole makes two and a half turns.
template <int dim>
Tensor<double, dim> deformation(double t) {
  const double angle = 5 * std::acos(-1.0) * t, c = std::cos(angle), s = std::sin(angle);
  const double R[3][3] = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}},
               U[3][3] = {{1 + 0.8 * t, 0.5 * t, 0.2 * t}, {0, 1 - 0.4 * t, 0.3 * t}, {0, 0, 1 + 0.5 * t}};
  return product<dim>(R, U);
}

// The gradient at the middle of a step, L = 2 (F1 - F0)(F1 + F0)^-1, carries F0 to F1 exactly, so after forty
// steps the stress is that of F alone: sigma = (mu (b - 1) + lambda ln J) / J with b = F F^T (Bonet & Wood,
// eq. 6.29); what was put in is held as volume and energy.
template <int dim>
void carry_stretch() {
  const NeoHookean law = NeoHookean::make(5e6, 0.3, 1000, dim == 3 ? Plane::none : Plane::strain);
  using State = sph::StretchPoint<dim, NeoHookean>;
  alignas(64) Pack own[State::size] = {}, volume = broadcast<Pack>(0.25);
  Tensor<double, dim> F{};
  double J = 1;
  for (int k = 0; k <= 40; ++k) {
    const Tensor<double, dim> before = F, next = deformation<dim>(k / 40.0);
    F = next;
    if (k == 0) continue;
    Tensor<double, dim> difference, sum;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        difference[i][j] = 2 * (next[i][j] - before[i][j]), sum[i][j] = next[i][j] + before[i][j];
    const Tensor<double, dim> L = over<dim>(difference, sum);
    Tensor<Pack, dim> packed;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) packed[i][j] = broadcast<Pack>(L[i][j]);
    State::advance(law, packed, volume, own);
  }
  over<dim>(F, F, &J);
  double b_trace = dim == 2 ? 1 : 0;
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      double b = 0;
      for (int k = 0; k < dim; ++k) b += F[i][k] * F[j][k];
      b_trace += i == j ? b : 0;
      const double cauchy = (law.base.mu * (b - (i == j)) + (i == j ? law.lambda * std::log(J) : 0)) / J;
      for (int l = 0; l < lanes; ++l) ASSERT_NEAR((State::pull(own)(i, j)[l]), cauchy, 1e-12 * law.base.mu);
    }
  EXPECT_NEAR(volume[3], 0.25 * J, 1e-13);
  const double energy = 0.25 * (0.5 * law.base.mu * (b_trace - 3 - 2 * std::log(J)) +
                                0.5 * law.lambda * std::log(J) * std::log(J));
  EXPECT_NEAR(State::stored(law, volume, own)[5], energy, 1e-12 * energy);
}

TEST(UpdatedNeoHookean, KnowsTheStressOfTheWholeStretchThroughAnyTurn) {
  carry_stretch<2>();
  carry_stretch<3>();
}

// What the forces do on a small step is what the law stores: E1 - E0 = -(f0 + f1)/2 . (u1 - u0) up to the
// square of the step.
TEST(UpdatedNeoHookean, ForcesAreTheSlopeOfTheEnergy) {
  for (Plane plane : {Plane::stress, Plane::strain, Plane::none}) {
    Scene scene = box_scene(
        plane, plane == Plane::none ? Point{0.08, 0.07, 0.06} : Point{0.2, 0.13, 0}, true);
    scene.materials.at("steel").parameters = NeoHookean::Parameters{};
    const auto d = sph::discretize(scene, 0, classic(0.01, sph::MassRule::share));
    AlignedVector<double> f(d->layout().size, 0.0), f0, u0, v = f;
    double e0 = 0, e1 = 0, work = 0;
    for (int k = 0; k <= 20; ++k) {
      const AlignedVector<double> u = swirl(*d, k < 20 ? 0.02 * k : 0.38 + 1e-7);
      for (std::size_t i = 0; i < u.size() && k > 0; ++i) v[i] = u[i] - u0[i];
      d->internal_force(u.data(), v.data(), k == 0 ? 0 : 1, f.data(), nullptr);
      if (k == 20)
        for (std::size_t i = 0; i < f.size(); ++i) work -= 0.5 * (f[i] + f0[i]) * v[i];
      e0 = e1, e1 = d->energies(u.data()).strain, f0 = f, u0 = u;
    }
    EXPECT_GT(e1, e0);
    EXPECT_NEAR(e1 - e0, work, 1e-5 * (e1 - e0));
  }
}

}  // namespace
}  // namespace femsph::test
