// The particles that a place of the scene stands for, and their weights.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/numerics/least_squares.hpp"
#include "model/numerics/vectors.hpp"
#include "sph/formulations/particle_body.hpp"
#include "sph/particles/lattice_hats.hpp"

namespace femsph::sph {

namespace {

std::vector<Weight> scaled_to_one(std::vector<Weight> out) {
  const double sum = std::accumulate(
      out.begin(), out.end(), 0.0, [](double s, const Weight& w) { return s + w.weight; });
  for (Weight& w : out) w.weight /= sum;
  return out;
}

}  // namespace

/// A lattice that a side cuts has particles outside of the body too. They are not counted on a side that lies
/// on the lattice.
bool ParticleBody::in_body(std::size_t i) const {
  return !steps_ || shape_->contains(particles_.position[i], 1e-6 * particles_.spacing);
}

std::vector<Weight> ParticleBody::points_of(const Place& place) const {
  std::vector<Weight> out;
  if (place.point) {
    std::size_t nearest = 0;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      double r = 0;
      for (int a = 0; a < 3; ++a) r += std::pow(particles_.position[i][a] - (*place.point)[a], 2);
      if (r < best) best = r, nearest = i;
    }
    return {{nearest, 1.0}};
  }
  if (const std::vector<Weight> layer = layer_at(place); !layer.empty()) return layer;
  // If no particle lies on the place, the layer within half a spacing of it is taken.
  for (double tolerance : {1e-6 * particles_.spacing, 0.51 * particles_.spacing}) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      const bool on = std::all_of(place.sides.begin(), place.sides.end(), [&](const std::string& side) {
        return shape_->on_side(side, particles_.position[i], tolerance);
      });
      if (on && (place.sides.empty() || in_body(i)) &&
          (!place.within || place.within->contains(particles_.position[i], 1e-6 * particles_.spacing)))
        out.push_back({i, particles_.own_volume(i) * (place.within ? share_within(*place.within, i) : 1.0)});
    }
    if (!out.empty()) break;
  }
  if (!particles_.cells.empty() && place.sides.size() == 1 && !place.within) weigh_by_area(out);
  return scaled_to_one(out);
}

/// The particles whose cells a side cuts. They share the area of the side by the hat functions of the
/// lattice; the part of a particle that is not among them goes to the particle in whose cell the piece lies.
/// For several sides: the particles whose cells all of them cut. Empty if the body is a box, or if a side has
/// no area.
std::vector<Weight> ParticleBody::layer_at(const Place& place) const {
  if (!steps_ || place.sides.empty()) return {};
  std::vector<double> area(particles_.size(), std::numeric_limits<double>::infinity());
  for (const std::string& side : place.sides) {
    const std::vector<SidePiece> pieces = shape_->side_pieces(side, 0.05 * particles_.spacing);
    const auto left_out = [&](const SidePiece& piece) {
      return place.within && !place.within->contains(piece.at, 0.0);
    };
    std::vector<char> cut(particles_.size(), 0);
    for (const SidePiece& piece : pieces)
      if (!left_out(piece)) cut[owner_of(piece.at)] = 1;
    std::vector<double> mine(particles_.size(), 0.0);
    for (const SidePiece& piece : pieces) {
      if (left_out(piece)) continue;
      const std::size_t owner = owner_of(piece.at);
      each_hat(particles_.lattice, particles_.dim, piece.at, [&](const std::array<int, 3>& at, double phi) {
        const int particle = particles_.lattice.particle(at[0], at[1], at[2]);
        const std::size_t own = particle < 0 ? owner : particles_.own(std::size_t(particle));
        mine[cut[own] ? own : owner] += phi * piece.size;
      });
    }
    for (std::size_t i = 0; i < area.size(); ++i) area[i] = std::min(area[i], cut[i] ? mine[i] : 0.0);
  }
  std::vector<Weight> out;
  for (std::size_t i = 0; i < area.size(); ++i)
    if (area[i] > 0) out.push_back({i, area[i]});
  return scaled_to_one(out);
}

/// The particle of the body in whose lattice cell x lies, or the nearest one if that place has no particle.
std::size_t ParticleBody::owner_of(const Point& x) const {
  const Lattice& lattice = particles_.lattice;
  std::array<int, 3> at{};
  for (int a = 0; a < particles_.dim; ++a)
    at[a] = int(std::lround((x[a] - lattice.origin[a]) / lattice.spacing[a]));
  if (const int particle = lattice.particle(at[0], at[1], at[2]); particle >= 0)
    return particles_.own(std::size_t(particle));
  std::size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t p) {
    const Point off = particles_.position[p] - x;
    if (const double r = dot(off, off); r < best) best = r, nearest = p;
  };
  const int levels = particles_.dim == 3 ? 2 : 0;
  for (int k = -levels; k <= levels; ++k)
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i)
        if (const int particle = lattice.particle(at[0] + i, at[1] + j, at[2] + k); particle >= 0)
          look(particles_.own(std::size_t(particle)));
  for (std::size_t p = 0; p < particles_.size() && !std::isfinite(best); ++p) look(p);
  return nearest;
}

/// Weights the points of a side of a fitted body by area: the integrals of the facets' shape functions.
void ParticleBody::weigh_by_area(std::vector<Weight>& points) const {
  std::vector<double> area(particles_.size(), 0.0);
  for (const PointArea& part : facet_areas(points)) area[part.point] += norm(part.area);
  if (std::any_of(points.begin(), points.end(), [&](const Weight& w) { return area[w.point] == 0; }))
    return;  // a side inside of the body, or one without area
  for (Weight& w : points) w.weight = area[w.point];
}

/// The share of a particle's cell that lies in the region, of its part within the bounding box of the body.
/// Directions in which the region is flat do not count.
double ParticleBody::share_within(const Region& region, std::size_t i) const {
  double share = 1;
  for (int a = 0; a < particles_.dim; ++a) {
    if (region.upper[a] - region.lower[a] < 1e-6 * particles_.spacing) continue;
    const double x = particles_.position[i][a], half = 0.5 * particles_.lattice.spacing[a];
    const double low = std::max(x - half, shape_->lower()[a]), high = std::min(x + half, shape_->upper()[a]);
    share *= (std::min(high, region.upper[a]) - std::max(low, region.lower[a])) / (high - low);
  }
  return share;
}

std::vector<Weight> ParticleBody::interpolation(const Point& p) const {
  return least_squares_weights({particles_.position.data(), particles_.size()}, particles_.dim, p,
                               1.6 * particles_.spacing, 1e-6 * particles_.spacing);
}

}  // namespace femsph::sph
