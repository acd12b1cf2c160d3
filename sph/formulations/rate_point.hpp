#pragma once
// A material point of the updated form whose law updates the stress from step to step, with the Jaumann rate
// (eq. 9 of the paper). Each function takes eight points.

#include "model/material/law.hpp"
#include "sph/formulations/jaumann.hpp"

namespace femsph::sph {

template <int dim, class Law>
struct RatePoint {
  static constexpr int n = symmetric_size<dim>;
  static constexpr bool plastic = !Law::path_independent;
  /// `work`, J per thickness: of a plastic law the work that is not stored, else the work of the stress,
  /// which is the stored energy (a rate law has no other measure of it).
  enum Slot { stress = 0, strain = n, work = 2 * n, history = 2 * n + 1 };
  static constexpr int size = history + Law::template history_size<dim>;

  /// The Cauchy stress in the pair forces, Pa.
  FEMSPH_INLINE static Symmetric<Pack, dim> pull(const Pack* own) {
    Symmetric<Pack, dim> s;
    for (int k = 0; k < n; ++k) s[k] = own[stress + k];
    return s;
  }

  /// L: velocity gradient times dt; volume: m^dim.
  FEMSPH_INLINE static void advance(const Law& law, const Tensor<Pack, dim>& L, Pack& volume, Pack* own) {
    Symmetric<Pack, dim> D, e, now, mean;
    Tensor<Pack, dim> W;
    split_motion<Pack, dim>(L, D, W);
    const Tensor<Pack, dim> Q = turn_of<Pack, dim>(W);
    for (int k = 0; k < n; ++k) e[k] = own[strain + k];
    e = turned<Pack, dim>(Q, e);
    mean = now = turned<Pack, dim>(Q, pull(own));
    [[maybe_unused]] Pack taken{};
    if constexpr (plastic) taken = law.plastic_work(own + history);
    law.update(D, now, own + history);
    for (int k = 0; k < n; ++k) {
      own[stress + k] = now[k];
      own[strain + k] = e[k] + D[k];
      mean[k] = 0.5 * (mean[k] + now[k]);
    }
    if constexpr (plastic)
      own[work] += (law.plastic_work(own + history) - taken) * volume;
    else
      own[work] += contract(mean, D) * volume;
    volume *= 1.0 + trace(D);
  }

  /// J per thickness.
  FEMSPH_INLINE static Pack stored(const Law& law, const Pack& volume, const Pack* own) {
    if constexpr (plastic)
      return volume * law.stored_energy(pull(own), pull(own), own + history);
    else
      return own[work];
  }
  FEMSPH_INLINE static Pack lost(const Pack* own) { return plastic ? own[work] : Pack{}; }

  /// Cauchy stress and strain of one point, six components.
  static void show(const Law& law, const double* own, std::array<double, 6>& stress_out,
                   std::array<double, 6>& strain_out) {
    const double *s = own + stress, *e = own + strain;
    if constexpr (dim == 2) {
      const Symmetric<double, 2> in{s[0], s[1], s[2]}, by{e[0], e[1], e[2]};
      stress_out = {s[0], s[1], law.thickness_stress(by, in, own + history), s[2], 0, 0};
      strain_out = {e[0], e[1], law.thickness_strain(by, in, own + history), e[2], 0, 0};
    } else {
      for (std::size_t c = 0; c < 6; ++c) stress_out[c] = s[c], strain_out[c] = e[c];
    }
  }
  static double plastic_strain([[maybe_unused]] const Law& law, [[maybe_unused]] const double* own) {
    if constexpr (plastic)
      return law.plastic_strain(own + history);
    else
      return 0;
  }
};

}  // namespace femsph::sph
