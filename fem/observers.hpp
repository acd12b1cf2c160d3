#pragma once
// What can be asked of the material points while a kernel runs on one cell: their energy, their stress and strain.

#include "fem/cell_loop.hpp"
#include "fem/elements.hpp"

namespace femsph::fem {

template <class LawType, int dim>
struct EnergyObserver {
  const CellMaterial<LawType>& material;
  double strain = 0, hourglass_ = 0;

  void enter(std::size_t, const Tensor<double, dim>&) {}
  /// 1/2 stress : elastic strain; for a law with history the elastic strain is what the compliance makes of the stress.
  template <class Frame>
  void point(int, double volume, const Frame&, const Symmetric<double, dim>& e, const Symmetric<double, dim>& s) {
    Symmetric<double, dim> elastic = e;
    if constexpr (!LawType::path_independent) {
      const double lambda = material.elastic.lambda, mu = material.elastic.mu;
      const double pressure = lambda / (2 * mu + dim * lambda) * trace(s);
      for (int k = 0; k < symmetric_size<dim>; ++k) elastic[k] = (s[k] - (k < dim ? pressure : 0.0)) / (2 * mu);
    }
    strain += 0.5 * volume * contract(s, elastic);
  }
  void hourglass(double energy) { hourglass_ += energy; }
};

template <int dim>
struct SampleObserver {
  const LinearElastic& elastic;
  const std::function<void(const Sample&)>& take;
  std::size_t first = 0;
  Tensor<double, dim> axes{};

  void enter(std::size_t first_point, const Tensor<double, dim>& cell_axes) {
    first = first_point;
    axes = cell_axes;
  }
  void hourglass(double) {}

  void point(int q, double volume, const SmallStrain::Frame<double, dim>&, const Symmetric<double, dim>& e, const Symmetric<double, dim>& s) {
    give(q, volume, axes, e, s);
  }
  /// Cauchy stress of the Biot stress T: F = R U, P = R T, sigma = P F^T / det F = R (T U) R^T / det F, symmetrised.
  void point(int q, double volume, const Tensor<double, dim>& R, const Symmetric<double, dim>& e, const Symmetric<double, dim>& T) {
    Symmetric<double, dim> U = e, s{};
    for (int i = 0; i < dim; ++i) U[i] += 1.0;
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j)
        for (int k = 0; k < dim; ++k) s(i, j) += 0.5 * (T(i, k) * U(k, j) + T(j, k) * U(k, i));
    Tensor<double, dim> full, unused;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) full[i][j] = U(i, j);
    double det = cofactors<double, dim>(full, unused);
    if (dim == 2) det *= 1 + elastic.thickness_strain(e[0], e[1]);
    for (int k = 0; k < symmetric_size<dim>; ++k) s[k] /= det;
    Tensor<double, dim> total{};
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k) total[i][j] += axes[i][k] * R[k][j];
    give(q, volume, total, e, s);
  }

 private:
  static std::array<double, 6> turned(const Tensor<double, dim>& R, const Symmetric<double, dim>& s) {
    std::array<double, 6> r{};
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          for (int l = 0; l < dim; ++l) r[static_cast<std::size_t>(symmetric_index<3>(i, j))] += R[i][k] * s(k, l) * R[j][l];
    return r;
  }
  void give(int q, double volume, const Tensor<double, dim>& R, const Symmetric<double, dim>& e, const Symmetric<double, dim>& s) {
    Sample sample{first + static_cast<std::size_t>(q), volume, turned(R, s), turned(R, e)};
    if (dim == 2) {
      sample.stress[2] = elastic.thickness_stress(sample.stress[0], sample.stress[1]);
      sample.strain[2] = elastic.thickness_strain(sample.strain[0], sample.strain[1]);
    }
    take(sample);
  }
};

}  // namespace femsph::fem
