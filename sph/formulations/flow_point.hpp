#pragma once
// A material point of the updated form whose law carries its stress from step to step, on the Kirchhoff
// stress tau = J sigma, as in the other discretizations (LargeStrain in model/material/kinematics.hpp):
// energies then belong to the undeformed volume V0, and V0 tau : D is the power. The objective rate is
// Jaumann's, by the rule of Hughes & Winget (jaumann.hpp). Each function takes eight points.

#include "model/material/law.hpp"
#include "model/material/laws/point_stress.hpp"
#include "model/numerics/elementary.hpp"
#include "sph/formulations/jaumann.hpp"

namespace femsph::sph {

/// exp(e) - 1 of a symmetric matrix: the series of e/16, then (1 + x)^2 - 1 = x (2 + x) four times.
inline std::array<double, 6> exponential_minus_one(const std::array<double, 6>& e) {
  using Matrix = Tensor<double, 3>;
  const auto product = [](const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
  };
  const auto of = [&](int i, int j) { return e[std::size_t(symmetric_index<3>(i, j))]; };
  Matrix E, x{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) E[i][j] = of(i, j) / 16;
  for (int n = 10; n >= 1; --n) {  // x = E/n (1 + x)
    Matrix next = product(E, x);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) next[i][j] = (next[i][j] + E[i][j]) / n;
    x = next;
  }
  for (int k = 0; k < 4; ++k) {
    Matrix next = product(x, x);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) next[i][j] += 2 * x[i][j];
    x = next;
  }
  return {x[0][0], x[1][1], x[2][2], x[0][1], x[1][2], x[2][0]};
}

template <int dim, class Law>
struct FlowPoint {
  static constexpr int n = symmetric_size<dim>;
  /// tau, Pa; the sum of the rotated strain increments (a logarithmic strain); ln J in 2D of the plane.
  enum Slot { stress = 0, strain = n, growth = 2 * n, history = 2 * n + 1 };
  static constexpr int size = history + Law::template history_size<dim>;

  /// L: velocity gradient times dt. `resultant`: V sigma = V0 tau. `kept`: the share of the memory of bonds
  /// that remains: 1 in an elastic step, else the ratio of the von Mises stress after and before the return
  /// to the yield surface, q / (q + 3 G dp).
  FEMSPH_INLINE static void advance(const Law& law, const Tensor<Pack, dim>& L, const Pack& undeformed,
                                    Pack* own, Symmetric<Pack, dim>& resultant, Pack& kept) {
    Symmetric<Pack, dim> D, e, now;
    Tensor<Pack, dim> W;
    split_motion<Pack, dim>(L, D, W);
    const Tensor<Pack, dim> Q = turn_of<Pack, dim>(W);
    for (int k = 0; k < n; ++k) e[k] = own[strain + k], now[k] = own[stress + k];
    e = turned<Pack, dim>(Q, e);
    now = turned<Pack, dim>(Q, now);
    const Pack before = law.plastic_strain(own + history);
    law.update(D, now, own + history);
    const Pack flow = law.plastic_strain(own + history) - before;
    for (int k = 0; k < n; ++k) {
      own[stress + k] = now[k];
      own[strain + k] = e[k] + D[k];
      resultant[k] = undeformed * now[k];
    }
    own[growth] += trace(D);
    kept = broadcast<Pack>(1.0);
    if (any(flow > 0.0)) {
      const Pack q = von_mises(law, now, own + history);
      kept = select(flow > 0.0, q / (q + 3.0 * law.elastic().mu * flow), kept);
    }
  }

  FEMSPH_INLINE static Pack stored(const Law& law, const Pack& undeformed, const Pack* own) {
    Symmetric<Pack, dim> s;
    for (int k = 0; k < n; ++k) s[k] = own[stress + k];
    return undeformed * law.stored_energy(s, s, own + history);
  }
  /// Cauchy stress, and the strain U - 1 of the logarithmic strain, of one point: six components.
  static void show(const Law& law, const double* own, std::array<double, 6>& stress_out,
                   std::array<double, 6>& strain_out) {
    const double *s = own + stress, *e = own + strain;
    double J = own[growth];
    if constexpr (dim == 2) {
      const Symmetric<double, 2> in{s[0], s[1], s[2]}, by{e[0], e[1], e[2]};
      const double across = law.thickness_strain(by, in, own + history);
      J += across;
      stress_out = {s[0], s[1], law.thickness_stress(by, in, own + history), s[2], 0, 0};
      strain_out = {e[0], e[1], across, e[2], 0, 0};
    } else {
      for (std::size_t c = 0; c < 6; ++c) stress_out[c] = s[c], strain_out[c] = e[c];
    }
    for (double& component : stress_out) component /= std::exp(J);
    strain_out = exponential_minus_one(strain_out);
  }
  /// Cauchy stress over the stress of the law.
  static double cauchy_share(const double* own) { return std::exp(-own[growth]); }

 private:
  /// With the stress normal to the plane.
  FEMSPH_INLINE static Pack von_mises(const Law& law, const Symmetric<Pack, dim>& s, const Pack* history_of) {
    plastic::PointStress<Pack, dim> point{s, Pack{}};
    if constexpr (dim == 2) {
      if constexpr (requires { Law::normal; })
        point.across = history_of[Law::normal];
      else if constexpr (requires { law.template stress_across<Pack, dim>(history_of); })
        point.across = law.template stress_across<Pack, dim>(history_of);
    }
    return plastic::von_mises(point);
  }
};

}  // namespace femsph::sph
