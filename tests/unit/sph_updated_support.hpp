#pragma once
// Classic SPH on updated neighbours, pair by pair, and a motion to try it on.

#include "sph_support.hpp"

namespace femsph::test {

/// The formulas of sph/formulations/updated_lagrangian.hpp, one pair after the other, with general matrices.
template <int dim, class LawType>
struct PlainUpdated {
  static constexpr int n = symmetric_size<dim>;
  using Matrix = Tensor<double, dim>;
  const Discretization& d;
  LawType law;
  sph::Kernel kernel;
  sph::Viscosity viscosity;
  double thickness, density;
  std::vector<double> volume;
  std::vector<Symmetric<double, dim>> stress = std::vector<Symmetric<double, dim>>(volume.size());
  std::vector<std::array<double, 8>> history = std::vector<std::array<double, 8>>(volume.size());
  double work = 0;

  Point at(const AlignedVector<double>& u, std::size_t i) const {
    Point x = d.position(i);
    for (int c = 0; c < dim; ++c) x[std::size_t(c)] += u[d.layout().at(i, c)];
    return x;
  }
  static double inner(const double* a, const double* b) {
    double s = 0;
    for (int c = 0; c < dim; ++c) s += a[c] * b[c];
    return s;
  }
  /// Q = (I - W/2)^-1 (I + W/2) by the series of W/2: (I - A)^-1 = I + A + A^2 + ..
  static Matrix turn(const Matrix& W) {
    Matrix sum{}, power{};
    for (int i = 0; i < dim; ++i) power[i][i] = 1;
    sum = power;
    for (int k = 0; k < 60; ++k) {
      Matrix next{};
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          for (int l = 0; l < dim; ++l) next[i][j] += 0.5 * power[i][l] * W[l][j];
      power = next;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          sum[i][j] += power[i][j] * 2;  // (I + A)(I - A)^-1 = I + 2 A + 2 A^2 + ..
    }
    return sum;
  }

  void step(const AlignedVector<double>& u, const AlignedVector<double>& v, double dt,
            AlignedVector<double>& f, AlignedVector<double>& g) {
    const std::size_t count = volume.size();
    if (dt > 0) {
      std::vector<double> volume_now = volume;
      for (std::size_t i = 0; i < count; ++i) {
        Matrix L{};
        for (std::size_t j = 0; j < count; ++j) {
          const Point a = at(u, i), b = at(u, j);
          double x[dim], dv[dim];
          for (int c = 0; c < dim; ++c) {
            dv[c] = v[d.layout().at(j, c)] - v[d.layout().at(i, c)];
            x[c] = b[std::size_t(c)] - a[std::size_t(c)] - 0.5 * dt * dv[c];
          }
          const double s = volume[j] * kernel.steepness(std::sqrt(inner(x, x))) * dt;
          for (int r = 0; r < dim; ++r)
            for (int c = 0; c < dim; ++c) L[r][c] += dv[r] * s * x[c];
        }
        Matrix W;
        Symmetric<double, dim> D, turned{};
        double dilatation = 0;
        for (int r = 0; r < dim; ++r) {
          dilatation += L[r][r];
          for (int c = 0; c < dim; ++c)
            W[r][c] = 0.5 * (L[r][c] - L[c][r]), D(r, c) = 0.5 * (L[r][c] + L[c][r]);
        }
        const Matrix Q = turn(W);
        for (int r = 0; r < dim; ++r)
          for (int c = r; c < dim; ++c)
            for (int k = 0; k < dim; ++k)
              for (int l = 0; l < dim; ++l) turned(r, c) += Q[r][k] * stress[i](k, l) * Q[c][l];
        Symmetric<double, dim> now = turned;
        double before = 0;
        if constexpr (!LawType::path_independent) before = law.plastic_work(history[i].data());
        law.update(D, now, history[i].data());
        if constexpr (LawType::path_independent) {
          for (int k = 0; k < n; ++k) turned[k] = 0.5 * (turned[k] + now[k]);
          work += contract(turned, D) * volume[i] * thickness;
        } else {
          work += (law.plastic_work(history[i].data()) - before) * volume[i] * thickness;
        }
        stress[i] = now;
        volume_now[i] = volume[i] * (1 + dilatation);
      }
      volume = volume_now;
    }
    for (std::size_t i = 0; i < count; ++i) {
      double force[dim] = {}, drag[dim] = {};
      for (std::size_t j = 0; j < count; ++j) {
        if (j == i) continue;
        const Point a = at(u, i), b = at(u, j);
        double x[dim], dv[dim];
        for (int c = 0; c < dim; ++c)
          x[c] = b[std::size_t(c)] - a[std::size_t(c)],
          dv[c] = v[d.layout().at(j, c)] - v[d.layout().at(i, c)];
        const double s = volume[i] * volume[j] * thickness * kernel.steepness(std::sqrt(inner(x, x)));
        const double phi = kernel.h() * std::min(inner(dv, x), 0.0) /
                           (inner(x, x) + viscosity.gamma * kernel.h() * kernel.h());
        for (int r = 0; r < dim; ++r) {
          for (int c = 0; c < dim; ++c) force[r] += (stress[i](r, c) + stress[j](r, c)) * s * x[c];
          drag[r] += density * (viscosity.alpha * law.wave_speed() - viscosity.beta * phi) * phi * s * x[r];
        }
      }
      for (int r = 0; r < dim; ++r) f[d.layout().at(i, r)] = force[r], g[d.layout().at(i, r)] = drag[r];
    }
  }
};

/// A body that shears, bends and turns: displacement at time t of the particle at X; up to several spacings.
inline AlignedVector<double> swirl(const Discretization& d, double t) {
  AlignedVector<double> u(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i) {
    const Point X = d.position(i);
    for (int c = 0; c < d.layout().dim; ++c)
      u[d.layout().at(i, c)] = 0.03 * t *
                                   std::sin(25 * X[std::size_t(c + 1) % std::size_t(d.layout().dim)] + c) +
                               0.2 * t * (c == 0);
  }
  return u;
}

/// The velocity of the step of length dt (s) from `before` to u, where the next step begins.
inline AlignedVector<double> velocity_to(const AlignedVector<double>& u, AlignedVector<double>& before,
                                         double dt) {
  AlignedVector<double> v = u;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = (u[i] - before[i]) / dt;
  before = u;
  return v;
}

inline double apart(const AlignedVector<double>& a, const AlignedVector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace femsph::test
