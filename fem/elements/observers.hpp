#pragma once
// Observers of the material points while a kernel runs: one sums energies, one collects stress and strain.

#include "fem/elements/cell_loop.hpp"
#include "fem/elements/element.hpp"
#include "model/material/spatial_state.hpp"

namespace femsph::fem {

/// Sums energies over one cell at a time (S = double) or over eight (S = Pack), J per thickness.
template <class LawType, int dim, class S>
struct EnergyObserver {
  const CellMaterial<LawType>& material;
  S strain{}, plastic{}, hourglass_{};

  void enter(std::size_t, const Tensor<double, dim>&) {}
  template <class Frame>
  FEMSPH_INLINE void point(int, const S& volume, const Frame&, const Symmetric<S, dim>& e,
                           const Symmetric<S, dim>& s, const S* history) {
    strain += volume * material.law.stored_energy(e, s, history);
    if constexpr (!LawType::path_independent) plastic += volume * material.law.plastic_work(history);
  }
  FEMSPH_INLINE void hourglass(const S& energy) { hourglass_ += energy; }
};

template <class Kinematics, class LawType, int dim>
struct SampleObserver {
  const LawType& law;
  Sample* out;  ///< of the next point
  std::size_t first = 0;
  Tensor<double, dim> axes{};

  void enter(std::size_t first_point, const Tensor<double, dim>& cell_axes) {
    first = first_point;
    axes = cell_axes;
  }
  void hourglass(double) {}

  void point(int q, double volume, const SmallStrain::Frame<double, dim>&, const Symmetric<double, dim>& e,
             const Symmetric<double, dim>& s, const double* history) {
    give(q, volume, axes, e, s, across(e, s, history), history, 1.0);
  }
  void point(int q, double volume, const Tensor<double, dim>& R, const Symmetric<double, dim>& e,
             const Symmetric<double, dim>& law_stress, const double* history) {
    Across normal = across(e, law_stress, history);
    const Symmetric<double, dim> s = corotated_cauchy<Kinematics>(
        e, law_stress, normal.stress, normal.strain);
    Tensor<double, dim> total{};
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k) total[i][j] += axes[i][k] * R[k][j];
    give(q, volume, total, e, s, normal, history, cauchy_share<Kinematics>(e, normal.strain));
  }

 private:
  /// Components normal to the plane; 0 in 3D.
  struct Across {
    double stress = 0, strain = 0;
  };
  Across across([[maybe_unused]] const Symmetric<double, dim>& e,
                [[maybe_unused]] const Symmetric<double, dim>& s,
                [[maybe_unused]] const double* history) const {
    if constexpr (dim == 2)
      return {law.thickness_stress(e, s, history), law.thickness_strain(e, s, history)};
    else
      return {};
  }
  static std::array<double, 6> turned(const Tensor<double, dim>& R, const Symmetric<double, dim>& s) {
    std::array<double, 6> r{};
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          for (int l = 0; l < dim; ++l)
            r[static_cast<std::size_t>(symmetric_index<3>(i, j))] += R[i][k] * s(k, l) * R[j][l];
    return r;
  }
  void give(int q, double volume, const Tensor<double, dim>& R, const Symmetric<double, dim>& e,
            const Symmetric<double, dim>& s, const Across& normal, [[maybe_unused]] const double* history,
            [[maybe_unused]] double share) {
    Sample sample{first + static_cast<std::size_t>(q), volume, turned(R, s), turned(R, e), 0.0, {}};
    if (dim == 2) {
      sample.stress[2] = normal.stress;
      sample.strain[2] = normal.strain;
    }
    if constexpr (!LawType::path_independent) {
      sample.plastic = law.plastic_strain(history);
      sample.flow = flow_stress(law, history, share, sample.stress);
    }
    *out++ = sample;
  }
};

}  // namespace femsph::fem
