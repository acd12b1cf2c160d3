#pragma once
// The volume of the body that belongs to each place of a lattice. With phi_i the multilinear hat function of
// place i (1 there, 0 at the other places) it is
//   V_i = integral of phi_i over the body.
// The hats add up to one and reproduce x, so sum V_i is the body's volume and sum V_i x_i its first moment,
// however its sides cut the lattice; where they lie on the lattice V_i is the part of the cell around i that
// is inside: a half on a face, a quarter on an edge.

#include <utility>
#include <vector>

#include "sph/particles/particles.hpp"

namespace femsph::sph {

struct PartialVolumes {
  std::vector<double> share;  ///< V_i over the volume of a cell of the lattice, of each place
  std::vector<char> border;   ///< a side of the body cuts a cell at this place
};
/// Only cells that the boundary cuts are integrated: those of a mesh by Gauss points, those of other shapes
/// along the lines that cross the side.
PartialVolumes partial_volumes(const Shape& shape, const Lattice& lattice,
                               const std::vector<MirrorPlane>& planes);

/// Whether no side of the body cuts a cell of the lattice.
bool follows_sides(const Shape& shape, const Lattice& lattice);

/// The lattice over a shape's bounding box, with a place at both ends of each side; no particles yet.
/// Throws std::runtime_error when the spacing does not fit the body.
Lattice lattice_over(const Shape& shape, double spacing);

/// Scales the volumes marked in `which` by 1 + a + b . (x - c), the smallest change (weighted by 1/V) for
/// which the sums of V and V x are those of the shape. The first moment normal to a symmetry plane is not
/// changed: that of the body with its image is right by symmetry.
void match_moments(const Shape& shape, const std::vector<MirrorPlane>& planes, const std::vector<Point>& at,
                   const std::vector<char>& which, std::vector<double>& volume);

/// The particles that take over the volume of a place without a particle, with factors that keep the total,
/// and the first moment where two particles stand in a row next to the place. `particle(place)` is -1 where
/// there is none; the rows are weighted by `volume(particle)`.
template <class ParticleAt, class VolumeOf>
std::vector<std::pair<int, double>> heirs(int dim, const std::array<int, 3>& place, ParticleAt&& particle,
                                          VolumeOf&& volume) {
  std::vector<std::pair<int, double>> out;
  double sum = 0;
  const int levels = dim == 3 ? 1 : 0;
  for (int k = -levels; k <= levels; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        const int next = particle({place[0] + i, place[1] + j, place[2] + k}),
                  second = particle({place[0] + 2 * i, place[1] + 2 * j, place[2] + 2 * k});
        if (next < 0 || second < 0) continue;
        const double weight = volume(next) * volume(second) / (i * i + j * j + k * k);
        out.push_back({next, 2 * weight});
        out.push_back({second, -weight});
        sum += weight;
      }
  for (int reach = 1; out.empty() && reach < 64; ++reach)  // a thin body: the nearest
    for (int k = -reach * levels; k <= reach * levels; ++k)
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
          if (const int near = particle({place[0] + i, place[1] + j, place[2] + k}); near >= 0)
            out.push_back({near, 1.0}), sum += 1;
  for (auto& [heir, factor] : out) factor /= sum;
  return out;
}

}  // namespace femsph::sph
