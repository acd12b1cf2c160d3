#include "sph/particles/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "model/numerics/simd.hpp"
#include "sph/particles/partial_volumes.hpp"

namespace femsph::sph {

namespace {

/// The smallest share of a lattice cell for which a place outside or inside of the body gets a particle.
constexpr double least_share_outside = 0.2, least_share_inside = 1e-3;

/// Whether all places around this one have particles.
bool deep_inside(const Lattice& lattice, const std::array<int, 3>& at, int dim) {
  for (int a = 0; a < 27; ++a) {
    const int di = a % 3 - 1, dj = a / 3 % 3 - 1, dk = a / 9 - 1;
    if (dim == 2 && dk != 0) continue;
    if (lattice.particle(at[0] + di, at[1] + dj, at[2] + dk) < 0) return false;
  }
  return true;
}

/// Volumes by the mass rules `share` and `full`. `share` counts a particle on a symmetry plane as a half: the
/// other half belongs to the mirror image of the body.
void give_volumes(Particles& p, const Shape& shape, MassRule rule, const std::vector<MirrorPlane>& planes) {
  p.part.assign(p.size(), 1.0);
  for (std::size_t i = 0; i < p.size(); ++i) p.part[i] = part_of(p.position[i], p.spacing, planes);
  double count = 0;
  for (double part : p.part) count += part;
  const double share = shape.measure() / count;
  p.volume.assign(p.size(), rule == MassRule::share ? share : p.cell);
}

/// Mirrors a place beyond a symmetry plane back into the body.
std::array<int, 3> folded(std::array<int, 3> at, const Lattice& lattice,
                          const std::vector<MirrorPlane>& planes) {
  for (const MirrorPlane& m : planes) {
    const int side = m.upper ? lattice.count[m.axis] - 1 : 0;
    if (m.upper ? at[m.axis] > side : at[m.axis] < side) at[m.axis] = 2 * side - at[m.axis];
  }
  return at;
}

/// Gives the volume of each place without a particle to particles next to it, such that the first moment is
/// kept (heirs() in partial_volumes.hpp).
void share_with_neighbours(Particles& p, const PartialVolumes& volumes,
                           const std::vector<MirrorPlane>& planes) {
  const Lattice& lattice = p.lattice;
  std::vector<double> added(p.size(), 0.0);
  std::size_t slot = 0;
  for (int k = 0; k < lattice.count[2]; ++k)
    for (int j = 0; j < lattice.count[1]; ++j)
      for (int i = 0; i < lattice.count[0]; ++i, ++slot) {
        if (lattice.at[slot] >= 0 || volumes.share[slot] == 0) continue;
        const auto particle = [&](const std::array<int, 3>& at) {
          const auto place = folded(at, lattice, planes);
          return lattice.particle(place[0], place[1], place[2]);
        };
        for (const auto& [heir, factor] :
             heirs(p.dim, {i, j, k}, particle, [&](int particle) { return p.volume[std::size_t(particle)]; }))
          added[std::size_t(heir)] += factor * volumes.share[slot] * p.cell / p.part[std::size_t(heir)];
      }
  for (std::size_t i = 0; i < p.size(); ++i) p.volume[i] += added[i];
}

/// Renumbers the particles slab by slab, a slab being eight particles thick along x; within a slab row by row
/// along x. Neighbour lists read their particles one by one: those of the same or the previous slab are still
/// in the faster caches, those of a whole long layer are not. The eight particles of a block keep similar
/// surroundings, so their lists have about the same length.
void number_by_slabs(Particles& p) {
  Lattice& lattice = p.lattice;
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const auto &a = lattice.place[i], &b = lattice.place[j];
    return std::array{a[0] / lanes, a[2], a[1], a[0]} < std::array{b[0] / lanes, b[2], b[1], b[0]};
  });
  const auto reorder = [&](auto& values) {
    auto old = values;
    for (std::size_t i = 0; i < order.size(); ++i) values[i] = old[order[i]];
  };
  reorder(p.position), reorder(p.volume), reorder(p.fraction), reorder(p.part), reorder(lattice.place);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [x, y, z] = lattice.place[i];
    lattice.at[lattice.slot(x, y, z)] = int(i);
  }
}

}  // namespace

Lattice lattice_over(const Shape& shape, double spacing) {
  Lattice lattice;
  lattice.origin = shape.lower();
  const Point upper = shape.upper();
  double places = 1;
  for (int a = 0; a < shape.dim(); ++a) {
    const double length = upper[a] - lattice.origin[a];
    const double cells = std::round(length / spacing);
    if (!(cells >= 1))
      throw Refusal(fmt::format(
          "a spacing of {:g} mm does not fit a body {:g} mm long along {}; the spacing must be "
          "at most that length",
          spacing * 1e3, length * 1e3, "xyz"[a]));
    places *= cells + 1;
    if (places > 5e8)
      throw std::runtime_error(fmt::format(
          "a spacing of {:g} mm needs more than {:.1e} particles (about {:.0f} GB); take a coarser one",
          spacing * 1e3, places, places * 300e-9));
    lattice.count[a] = int(cells) + 1;
    lattice.spacing[a] = length / cells;
  }
  lattice.at.assign(std::size_t(lattice.count[0]) * lattice.count[1] * lattice.count[2], -1);
  return lattice;
}

Particles fill(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes) {
  Particles p;
  p.dim = shape.dim();
  Lattice& lattice = p.lattice;
  lattice = lattice_over(shape, options.spacing);
  p.cell = 1;
  for (int a = 0; a < p.dim; ++a) {
    p.cell *= lattice.spacing[a];
    p.spacing = a == 0 ? lattice.spacing[a] : std::min(p.spacing, lattice.spacing[a]);
  }
  const bool partial = options.mass == MassRule::trapezoid;
  const PartialVolumes volumes = partial ? partial_volumes(shape, lattice, planes) : PartialVolumes{};
  // Particles are the places in the body; with partial volumes also those outside whose V_i is a good part of
  // a cell.
  const auto belongs = [&](std::size_t slot, const Point& x) {
    if (!partial) return shape.contains(x, 1e-6 * p.spacing);
    const double share = volumes.share[slot] / part_of(x, p.spacing, planes);
    return share >= least_share_outside ||
           (share > least_share_inside && shape.contains(x, 1e-6 * p.spacing));
  };
  std::size_t slot = 0;
  for (int k = 0; k < lattice.count[2]; ++k)
    for (int j = 0; j < lattice.count[1]; ++j)
      for (int i = 0; i < lattice.count[0]; ++i, ++slot) {
        const Point x{lattice.origin[0] + i * lattice.spacing[0], lattice.origin[1] + j * lattice.spacing[1],
                      lattice.origin[2] + k * lattice.spacing[2]};
        if (!belongs(slot, x)) continue;
        lattice.at[slot] = int(p.position.size());
        lattice.place.push_back({i, j, k});
        p.position.push_back(x);
      }
  if (p.position.empty())
    throw Refusal(fmt::format(
        "no particle of spacing {:g} mm lies in the body; take a finer spacing", options.spacing * 1e3));
  give_volumes(p, shape, options.mass, planes);
  if (partial) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto [x, y, z] = lattice.place[i];
      p.volume[i] = p.cell * (volumes.share[lattice.slot(x, y, z)] / p.part[i]);
    }
    share_with_neighbours(p, volumes, planes);
  }
  p.fraction.assign(p.size(), 1.0);
  for (std::size_t i = 0; partial && i < p.size(); ++i) p.fraction[i] = p.volume[i] / p.cell;
  if (options.jitter > 0) {
    p.regular = false;
    std::mt19937_64 random(20090924);
    std::uniform_real_distribution<double> share(-options.jitter, options.jitter);
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int a = 0; a < p.dim; ++a) {
        const double move = share(random) * lattice.spacing[a];
        if (deep_inside(lattice, lattice.place[i], p.dim)) p.position[i][a] += move;
      }
    number_by_slabs(p);
  }
  return p;
}

double part_of(const Point& x, double spacing, const std::vector<MirrorPlane>& planes) {
  double part = 1;
  for (const MirrorPlane& m : planes)
    if (m.holds(x, 1e-6 * spacing)) part *= 0.5;
  return part;
}

std::vector<MirrorPlane> mirror_planes(const Scene& scene, std::size_t body) {
  std::vector<MirrorPlane> planes;
  const Shape& shape = *scene.bodies[body].shape;
  for (const Symmetry& s : scene.symmetries)
    if (s.place.body == body)
      planes.push_back({s.axis(), (s.upper() ? shape.upper() : shape.lower())[s.axis()], s.upper()});
  return planes;
}

void set_kernel_volumes(Particles& p, KernelVolume kind) {
  p.kernel_volume = p.volume;
  if (kind == KernelVolume::own) return;
  for (std::size_t i = 0; i < p.position.size(); ++i)
    p.kernel_volume[i] = p.volume[i] == p.cell * p.fraction[i] ? p.cell : p.volume[i] / p.fraction[i];
}

void add_mirrored(Particles& p, const std::vector<MirrorPlane>& planes, double radius) {
  if (planes.empty()) return;
  p.planes = planes;
  Lattice& lattice = p.lattice;
  const std::array<int, 3> count = lattice.count;
  for (const MirrorPlane& m : planes) {
    for (const MirrorPlane& other : planes)
      if (other.axis == m.axis && other.upper != m.upper && std::abs(other.at - m.at) < radius)
        throw Refusal(fmt::format(
            "the symmetry planes across {} are {:g} mm apart, nearer than the kernel's radius of "
            "{:g} mm; take a finer spacing",
            "xyz"[m.axis], std::abs(other.at - m.at) * 1e3, radius * 1e3));
    const int side = m.upper ? count[m.axis] - 1 : 0;
    const std::size_t known = p.position.size(), own = p.size();
    for (std::size_t i = 0; i < known; ++i) {
      const double depth = std::abs(p.position[i][m.axis] - m.at);
      if (p.on_plane(p.position[i], m) || depth >= radius) continue;
      Mirrored image = i < own ? Mirrored{i, {1, 1, 1}} : p.mirrored[i - own];
      image.sign[m.axis] *= -1;
      Point x = p.position[i];
      x[m.axis] = 2 * m.at - x[m.axis];
      p.mirrored.push_back(image);
      p.position.push_back(x);
      p.volume.push_back(p.volume[i]);
      p.fraction.push_back(p.fraction[i]);
      p.part.push_back(0.0);
      if (lattice.place.empty()) continue;  // fitted
      std::array<int, 3> place = lattice.place[i];
      place[m.axis] = 2 * side - place[m.axis];
      lattice.place.push_back(place);
    }
  }
  if (lattice.place.empty()) return;
  // The lattice grows by the layers beyond the planes.
  std::array<int, 3> first{}, last{count[0] - 1, count[1] - 1, count[2] - 1};
  for (const auto& place : lattice.place)
    for (int a = 0; a < 3; ++a)
      first[a] = std::min(first[a], place[a]), last[a] = std::max(last[a], place[a]);
  for (int a = 0; a < 3; ++a) {
    lattice.count[a] = last[a] - first[a] + 1;
    lattice.origin[a] += first[a] * lattice.spacing[a];
  }
  lattice.at.assign(std::size_t(lattice.count[0]) * lattice.count[1] * lattice.count[2], -1);
  for (std::size_t i = 0; i < lattice.place.size(); ++i) {
    auto& place = lattice.place[i];
    for (int a = 0; a < 3; ++a) place[a] -= first[a];
    lattice.at[lattice.slot(place[0], place[1], place[2])] = int(i);
  }
}

}  // namespace femsph::sph
