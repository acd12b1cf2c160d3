#pragma once
// The rest of stiffness_body.hpp: the places of gradients, and the check of det F.

#include "sph/formulations/stiffness_body.hpp"

namespace femsph::sph {

/// Of a field with second derivatives the corrected gradient of particle i is, to first order, that at x_i +
/// s_i: the least-squares place
///   s_i = 1/(dim + 1) sum_j (G_ij . x_ij) x_ij,  G_ij = B_i w_ij;
/// s_i is zero where neighbours are symmetric, and points into the body at its surface. An uncorrected
/// gradient has an error of order 0 at the surface, and no such place.
template <int dim, class Stencils, Correction correction>
MaterialUnits StiffnessBody<dim, Stencils, correction>::material_units() const {
  MaterialUnits units = ParticleBody::material_units();
  if constexpr (corrected) {
    if (!formulation_.corrected) return units;
    AlignedVector<double> x(layout_.size, 0.0);
    for (std::size_t i = 0; i < particles_.position.size(); ++i)
      for (int c = 0; c < dim; ++c) x[layout_.at(i, c)] = particles_.position[i][std::size_t(c)];
    parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
        Tensor<Pack, dim> sum[dim]{};  // w_a x_b x_c
        operator_.stencils().each(block, x.data() + first(block), stride(),
                                  [&](const Pack(&apart)[dim], const Pack(&w)[dim], const Pack&) {
                                    for (int a = 0; a < dim; ++a)
                                      for (int b = 0; b < dim; ++b)
                                        for (int c = 0; c < dim; ++c)
                                          sum[a][b][c] += w[a] * apart[b] * apart[c];
                                  });
        for (std::size_t i = block * lanes; i < std::min((block + 1) * lanes, particles_.size()); ++i)
          for (int c = 0; c < dim; ++c)
            for (int a = 0; a < dim; ++a)
              for (int b = 0; b < dim; ++b)
                units.place[i][std::size_t(c)] += operator_.correction(i, a, b) * sum[a][b][c][i % lanes] /
                                                  (dim + 1);
      }
    });
  }
  return units;
}

/// det F <= 0 at a particle.
template <int dim, class Stencils, Correction correction>
std::optional<Trouble> StiffnessBody<dim, Stencils, correction>::trouble(const double* given) const {
  const double* u = with_mirrored(given);
  AlignedVector<double> det(blocks() * lanes);
  parallel_for(blocks() * lanes, lanes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin / lanes; block < end / lanes; ++block) {
      Tensor<Pack, dim> F;
      Pack L[dim];
      gradient<false>(block, u, F, L);
      for (int a = 0; a < dim; ++a) F[a][a] += 1.0;
      Pack d = F[0][0] * F[1][1] - F[0][1] * F[1][0];
      if constexpr (dim == 3)
        d = d * F[2][2] + (F[0][2] * F[1][0] - F[0][0] * F[1][2]) * F[2][1] +
            (F[0][1] * F[1][2] - F[0][2] * F[1][1]) * F[2][0];
      store(&det[block * lanes], d);
    }
  });
  return inside_out(det, u);
}

}  // namespace femsph::sph
