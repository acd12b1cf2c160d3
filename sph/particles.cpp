#include "sph/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "model/numerics/simd.hpp"

namespace femsph::sph {

namespace {

/// Share of the lattice cell around p that lies in the shape: half on a face, a quarter on an edge of a box.
double fraction_inside(const Shape& shape, const Point& p, const Point& spacing, const std::vector<MirrorPlane>& planes) {
  const int dim = shape.dim(), cuts = 8;
  int inside = 0, all = 0;
  for (int k = 0; k < (dim == 3 ? cuts : 1); ++k)
    for (int j = 0; j < cuts; ++j)
      for (int i = 0; i < cuts; ++i) {
        Point s{p[0] + ((i + 0.5) / cuts - 0.5) * spacing[0], p[1] + ((j + 0.5) / cuts - 0.5) * spacing[1],
                      dim == 3 ? p[2] + ((k + 0.5) / cuts - 0.5) * spacing[2] : 0.0};
        for (const MirrorPlane& m : planes)
          if (m.upper ? s[m.axis] > m.at : s[m.axis] < m.at) s[m.axis] = 2 * m.at - s[m.axis];
        inside += shape.contains(s, 0.0);
        ++all;
      }
  return double(inside) / all;
}

bool deep_inside(const Lattice& lattice, const std::array<int, 3>& at, int dim) {
  for (int a = 0; a < 27; ++a) {
    const int di = a % 3 - 1, dj = a / 3 % 3 - 1, dk = a / 9 - 1;
    if (dim == 2 && dk != 0) continue;
    if (lattice.particle(at[0] + di, at[1] + dj, at[2] + dk) < 0) return false;
  }
  return true;
}

/// The share rule counts particles as the body with its images would: those on a plane belong to it by half.
void give_volumes(Particles& p, const Shape& shape, MassRule rule, const std::vector<MirrorPlane>& planes) {
  p.part.assign(p.size(), 1.0);
  for (const MirrorPlane& m : planes)
    for (std::size_t i = 0; i < p.size(); ++i)
      if (std::abs(p.position[i][m.axis] - m.at) < 1e-6 * p.spacing) p.part[i] *= 0.5;
  double count = 0;
  for (double part : p.part) count += part;
  const double share = shape.measure() / count;
  p.volume.assign(p.size(), rule == MassRule::share ? share : p.cell);
  if (rule != MassRule::trapezoid) return;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!deep_inside(p.lattice, p.lattice.place[i], p.dim)) p.volume[i] = p.cell * fraction_inside(shape, p.position[i], p.lattice.spacing, planes);
}

/// Numbers the particles slab by slab, a slab being eight of them thick along x; within it rows along x come first as before. Lists reach their
/// neighbours one by one: those in the same slab or the one before are still in the processor's nearer caches, those of a whole long layer are not.
/// And the eight particles of a block go on looking alike, so that their lists are of one length.
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
  reorder(p.position), reorder(p.volume), reorder(p.part), reorder(lattice.place);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& at = lattice.place[i];
    lattice.at[std::size_t(at[0]) + std::size_t(lattice.count[0]) * (std::size_t(at[1]) + std::size_t(lattice.count[1]) * std::size_t(at[2]))] = int(i);
  }
}

}  // namespace

Particles fill(const Shape& shape, const Options& options, const std::vector<MirrorPlane>& planes) {
  Particles p;
  p.dim = shape.dim();
  Lattice& lattice = p.lattice;
  lattice.origin = shape.lower();
  const Point upper = shape.upper();
  p.cell = 1;
  double places = 1;
  for (int a = 0; a < p.dim; ++a) {
    const double length = upper[a] - lattice.origin[a];
    const double cells = std::round(length / options.spacing);
    if (!(cells >= 1))
      throw Refusal(fmt::format("a spacing of {:g} mm does not fit a body {:g} mm long along {}; the spacing must be at most that length",
                                           options.spacing * 1e3, length * 1e3, "xyz"[a]));
    places *= cells + 1;
    if (places > 5e8)
      throw std::runtime_error(fmt::format("a spacing of {:g} mm asks for more than {:.1e} particles (about {:.0f} GB); take a coarser one", options.spacing * 1e3,
                                           places, places * 300e-9));
    lattice.count[a] = int(cells) + 1;
    lattice.spacing[a] = length / cells;
    p.cell *= lattice.spacing[a];
    p.spacing = a == 0 ? lattice.spacing[a] : std::min(p.spacing, lattice.spacing[a]);
  }
  lattice.at.assign(std::size_t(lattice.count[0]) * lattice.count[1] * lattice.count[2], -1);
  std::size_t slot = 0;
  for (int k = 0; k < lattice.count[2]; ++k)
    for (int j = 0; j < lattice.count[1]; ++j)
      for (int i = 0; i < lattice.count[0]; ++i, ++slot) {
        const Point x{lattice.origin[0] + i * lattice.spacing[0], lattice.origin[1] + j * lattice.spacing[1], lattice.origin[2] + k * lattice.spacing[2]};
        if (!shape.contains(x, 1e-6 * p.spacing)) continue;
        lattice.at[slot] = int(p.position.size());
        lattice.place.push_back({i, j, k});
        p.position.push_back(x);
      }
  if (p.position.empty()) throw Refusal(fmt::format("no particle of spacing {:g} mm lies in the body; take a finer spacing", options.spacing * 1e3));
  give_volumes(p, shape, options.mass, planes);
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

std::vector<MirrorPlane> mirror_planes(const Scene& scene, std::size_t body) {
  std::vector<MirrorPlane> planes;
  const Shape& shape = *scene.bodies[body].shape;
  for (const Symmetry& s : scene.symmetries)
    if (s.place.body == body) planes.push_back({s.axis(), (s.upper() ? shape.upper() : shape.lower())[s.axis()], s.upper()});
  return planes;
}

void add_mirrored(Particles& p, const std::vector<MirrorPlane>& planes, double radius) {
  if (planes.empty()) return;
  Lattice& lattice = p.lattice;
  const std::array<int, 3> count = lattice.count;
  for (const MirrorPlane& m : planes) {
    for (const MirrorPlane& other : planes)
      if (other.axis == m.axis && other.upper != m.upper && std::abs(other.at - m.at) < radius)
        throw Refusal(fmt::format("the symmetry planes across {} are {:g} mm apart, nearer than the kernel's radius of {:g} mm; take a finer spacing",
                                             "xyz"[m.axis], std::abs(other.at - m.at) * 1e3, radius * 1e3));
    const int side = m.upper ? count[m.axis] - 1 : 0;
    const std::size_t known = p.position.size(), own = p.size();
    for (std::size_t i = 0; i < known; ++i) {
      const double depth = std::abs(p.position[i][m.axis] - m.at);
      if (depth < 1e-6 * p.spacing || depth >= radius) continue;
      Mirrored image = i < own ? Mirrored{i, {1, 1, 1}} : p.mirrored[i - own];
      image.sign[m.axis] *= -1;
      Point x = p.position[i];
      x[m.axis] = 2 * m.at - x[m.axis];
      p.mirrored.push_back(image);
      p.position.push_back(x);
      p.volume.push_back(p.volume[i]);
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
    for (int a = 0; a < 3; ++a) first[a] = std::min(first[a], place[a]), last[a] = std::max(last[a], place[a]);
  for (int a = 0; a < 3; ++a) {
    lattice.count[a] = last[a] - first[a] + 1;
    lattice.origin[a] += first[a] * lattice.spacing[a];
  }
  lattice.at.assign(std::size_t(lattice.count[0]) * lattice.count[1] * lattice.count[2], -1);
  for (std::size_t i = 0; i < lattice.place.size(); ++i) {
    auto& place = lattice.place[i];
    for (int a = 0; a < 3; ++a) place[a] -= first[a];
    lattice.at[std::size_t(place[0]) + std::size_t(lattice.count[0]) * (std::size_t(place[1]) + std::size_t(lattice.count[1]) * place[2])] = int(i);
  }
}

}  // namespace femsph::sph
