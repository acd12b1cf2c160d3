// The surface of a body of particles: its facets and their areas, and the share of the angle around a
// particle that the body fills.

#include <algorithm>
#include <cmath>

#include "model/numerics/vectors.hpp"
#include "sph/formulations/particle_body.hpp"
#include "sph/particles/mesh_cells.hpp"

namespace femsph::sph {

namespace {

/// The outward area vector of each corner of a facet, m^(dim - 1): a_k = integral of N_k n, so that
/// sum x_k (x) a_k is the integral of x (x) n. Two Gauss points in each direction are exact.
std::array<Point, 4> corner_areas(const Particles& p, const Facet& f) {
  const auto x = [&](int k) { return p.position[f.points[std::size_t(k)]]; };
  if (p.dim == 2) {
    const Point half = 0.5 * (x(1) - x(0)),
                area{half[1], -half[0], 0};  // the body lies to the left of 0 -> 1
    return {area, area, {}, {}};
  }
  std::array<Point, 4> out{};
  const double g[2] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
  for (const double s : g)
    for (const double t : g) {
      const Point along = (1 - t) * (x(1) - x(0)) + t * (x(2) - x(3)),
                  across = (1 - s) * (x(3) - x(0)) + s * (x(2) - x(1));
      const Point area = 0.25 * cross(along, across);
      const double N[4] = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
      for (int k = 0; k < 4; ++k) out[std::size_t(k)] = out[std::size_t(k)] + N[k] * area;
    }
  return out;
}

}  // namespace

std::vector<Facet> ParticleBody::boundary() const {
  const Lattice& lattice = particles_.lattice;
  const bool plane = particles_.dim == 2;
  Topology cells = topology_of(particles_.dim, particles_.cells);
  // Particles outside of a side that cuts the lattice are left out: they would touch other bodies too soon.
  std::vector<char> inside(particles_.size(), 1);
  for (std::size_t i = 0; steps_ && i < inside.size(); ++i) inside[i] = in_body(i);
  for (const auto& [i, j, k] : lattice.place) {
    std::array<std::size_t, 8> cell{};
    bool whole = true;
    for (int c = 0; c < (plane ? 4 : 8) && whole; ++c) {
      const int corner = lattice.particle(i + ((c + 1) / 2 % 2), j + (c / 2 % 2), k + c / 4);  // VTK order
      whole = corner >= 0 && std::size_t(corner) < particles_.size() &&
              inside[std::size_t(corner)];  // mirror images are left out
      cell[c] = std::size_t(corner);
    }
    if (whole) cells.cells.push_back(cell);
  }
  return boundary_of(cells);
}

/// One entry for each corner of each facet whose corners are all among `points`.
std::vector<PointArea> ParticleBody::facet_areas(const std::vector<Weight>& points) const {
  std::vector<char> there(particles_.size(), 0);
  for (const Weight& w : points) there[w.point] = 1;
  const int corners = 2 * (particles_.dim - 1);
  std::vector<PointArea> out;
  for (const Facet& f : boundary()) {
    if (!std::all_of(f.points.begin(), f.points.begin() + corners, [&](std::size_t p) { return there[p]; }))
      continue;
    const auto area = corner_areas(particles_, f);
    for (std::size_t k = 0; k < std::size_t(corners); ++k) out.push_back({f.points[k], area[k]});
  }
  return out;
}

std::vector<Point> ParticleBody::uniform_stress_areas() const {
  if (!options_.projection || !formulation_.corrected || options_.mass != MassRule::trapezoid ||
      particles_.regular || steps_)
    return {};
  std::vector<Weight> all;
  for (std::size_t i = 0; i < particles_.size(); ++i) all.push_back({i, 1.0});
  std::vector<Point> out(particles_.size(), Point{});
  for (const PointArea& part : facet_areas(all)) out[part.point] = out[part.point] + part.area;
  return out;
}

/// The share of the full angle that the body fills at a particle. With the mass rules `share` and `full`,
/// which do not store it: the share of the lattice cells around the particle that have particles at all
/// corners.
double ParticleBody::filled_share(std::size_t i) const {
  const Lattice& lattice = particles_.lattice;
  if (options_.mass == MassRule::trapezoid || lattice.place.empty()) return particles_.fraction[i];
  const auto [x, y, z] = lattice.place[i];
  const int corners = 1 << particles_.dim;
  int whole = 0;
  for (int cell = 0; cell < corners; ++cell) {
    bool there = true;
    for (int v = 0; v < corners && there; ++v) {
      const int a = (cell & 1) - (v & 1), b = (cell >> 1 & 1) - (v >> 1 & 1), c = (cell >> 2) - (v >> 2);
      there = lattice.particle(x + a, y + b, z + c) >= 0;
    }
    whole += there;
  }
  return double(whole) / corners;
}

/// The strain of a particle on the surface is that of a place below the surface; without correction it is
/// meaningless. The quality f^10 (1e-3 on a face) therefore gives it a weight only where no other is near.
MaterialUnits ParticleBody::material_units() const {
  MaterialUnits units;
  units.dim = particles_.dim;
  const std::size_t n = particles_.size();
  units.place.assign(particles_.position.begin(), particles_.position.begin() + std::ptrdiff_t(n));
  for (std::size_t i = 0; i < n; ++i) units.volume.push_back(particles_.own_volume(i));
  std::array<double, 6> shape{};
  for (std::size_t a = 0; a < std::size_t(particles_.dim); ++a)
    shape[a] = std::pow(particles_.cells.empty() ? particles_.lattice.spacing[a] : particles_.spacing, 2);
  units.shape = {shape};
  for (std::size_t i = 0; i < n; ++i) units.quality.push_back(std::max(std::pow(filled_share(i), 10), 1e-12));
  return units;
}

}  // namespace femsph::sph
