#include "sph/particle_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/numerics/array.hpp"
#include "model/numerics/least_squares.hpp"

namespace femsph::sph {

namespace {

/// How far apart in number two neighbours of a lattice can be: what a block may load beyond the first and the last particle.
std::size_t reach(const Particles& p, const Kernel& kernel) {
  std::size_t far = lanes, step = 1;
  for (int a = 0; a < p.dim; ++a) {
    far += std::size_t(std::ceil(kernel.radius() / p.lattice.spacing[a])) * step;
    step *= std::size_t(p.lattice.count[a]);
  }
  return far;
}

}  // namespace

ParticleBody::ParticleBody(const Scene& scene, std::size_t body, const Options& options, Particles particles, const Kernel& kernel)
    : options_(options), particles_(std::move(particles)), shape_(scene.bodies[body].shape), thickness_(scene.bodies[body].thickness) {
  const Material& material = scene.material_of(scene.bodies[body]);
  density_ = material.density;
  wave_speed_ = std::visit([](const auto& law) { return law.wave_speed(); }, material.law(scene.plane));
  for (std::size_t i = 0; i < particles_.size(); ++i) mass_.push_back(particles_.own_volume(i) * thickness_ * density_);
  const std::span<const Point> own(particles_.position.data(), particles_.size());
  const std::vector<BarRow> rows = bar_rows(scene, body, own, 1e-6 * particles_.spacing);
  bars_ = SmearedBars(rows, particles_, thickness_);
  bars_.add_mass(mass_);
  bars_text_ = femsph::describe(rows, scene);
  const std::size_t padding = reach(particles_, kernel);
  layout_.points = particles_.size();
  layout_.dim = particles_.dim;
  layout_.point_stride = 1;
  layout_.offset = round_up(padding, lanes);
  layout_.component_stride = round_up(layout_.offset + round_up(particles_.position.size(), lanes) + padding, lanes);
  layout_.size = layout_.component_stride * std::size_t(particles_.dim);
}

std::string ParticleBody::describe() const {
  const char* formulation = options_.formulation == Formulation::corrected ? "corrected" : "classic";
  return fmt::format("{} SPH, {} particles, d = {:g} mm, h = {:g} d{}", formulation, particles_.size(), particles_.spacing * 1e3, options_.smoothing, bars_text_);
}

std::size_t ParticleBody::bytes() const {
  return (mass_.size() + mirrored_.size()) * sizeof(double) + particles_.mirrored.size() * sizeof(Mirrored) + bars_.bytes() +
         particles_.position.size() * (sizeof(Point) + 2 * sizeof(double)) + particles_.lattice.at.size() * sizeof(int) +
         particles_.lattice.place.size() * sizeof(std::array<int, 3>);
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
  // On a lattice that misses a curved or slanted side the nearest layer stands for it.
  for (double tolerance : {1e-6 * particles_.spacing, 0.51 * particles_.spacing}) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      const bool on = std::all_of(place.sides.begin(), place.sides.end(),
                                  [&](const std::string& side) { return shape_->on_side(side, particles_.position[i], tolerance); });
      if (on && (!place.within || place.within->contains(particles_.position[i], 1e-6 * particles_.spacing)))
        out.push_back({i, particles_.own_volume(i) * (place.within ? share_within(*place.within, i) : 1.0)});
    }
    if (!out.empty()) break;
  }
  const double sum = std::accumulate(out.begin(), out.end(), 0.0, [](double s, const Weight& w) { return s + w.weight; });
  for (Weight& w : out) w.weight /= sum;
  return out;
}

/// Share of a particle's cell, as far as it lies in the body, that lies in the region; directions in which the region is flat do not count.
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
  return least_squares_weights({particles_.position.data(), particles_.size()}, particles_.dim, p, 1.6 * particles_.spacing, 1e-6 * particles_.spacing);
}

Topology ParticleBody::topology() const { return {}; }

std::vector<Facet> ParticleBody::boundary() const {
  const Lattice& lattice = particles_.lattice;
  const bool plane = particles_.dim == 2;
  Topology cells{plane ? Topology::Kind::quadrilaterals : Topology::Kind::hexahedra, {}};
  for (const auto& own : particles_.cells) {
    constexpr std::array<std::size_t, 8> vtk{0, 1, 3, 2, 4, 5, 7, 6};
    std::array<std::size_t, 8> cell{};
    for (std::size_t c = 0; c < (plane ? 4u : 8u); ++c) cell[c] = std::size_t(own[vtk[c]]);
    cells.cells.push_back(cell);
  }
  for (const auto& [i, j, k] : lattice.place) {
    std::array<std::size_t, 8> cell{};
    bool whole = true;
    for (int c = 0; c < (plane ? 4 : 8) && whole; ++c) {
      const int corner = lattice.particle(i + ((c + 1) / 2 % 2), j + (c / 2 % 2), k + c / 4);  // VTK order
      whole = corner >= 0 && std::size_t(corner) < particles_.size();  // no mirrored ones
      cell[c] = std::size_t(corner);
    }
    if (whole) cells.cells.push_back(cell);
  }
  return boundary_of(cells);
}

std::optional<Trouble> ParticleBody::inside_out(const AlignedVector<double>& det, const double* u) const {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < particles_.size(); ++i)
    if (!(det[i] >= det[worst])) worst = i;
  if (det[worst] > 0) return std::nullopt;
  return Trouble{fmt::format("particle {} has turned inside out: its volume is {:.3g} times what it was", worst, det[worst]),
                 "the body is crushed or torn there, more than the first neighbours can tell: try a finer spacing, a gentler load, or sph-classic-share, "
                 "whose neighbours follow", place_now(worst, u)};
}

Point ParticleBody::place_now(std::size_t particle, const double* u) const {
  Point x = particles_.position[particle];
  for (int c = 0; c < particles_.dim; ++c) x[c] += u[layout_.at(particle, c)];
  return x;
}

const double* ParticleBody::fill_mirrored(const double* u) const {
  mirrored_.assign(u, u + layout_.size);
  for (std::size_t k = 0; k < particles_.mirrored.size(); ++k)
    for (int c = 0; c < particles_.dim; ++c)
      mirrored_[layout_.at(particles_.size() + k, c)] = particles_.mirrored[k].sign[c] * u[layout_.at(particles_.mirrored[k].of, c)];
  return mirrored_.data();
}

}  // namespace femsph::sph
