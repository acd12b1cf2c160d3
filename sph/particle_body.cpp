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
  for (double v : particles_.volume) mass_.push_back(v * thickness_ * density_);
  const std::size_t padding = reach(particles_, kernel);
  layout_.points = particles_.size();
  layout_.dim = particles_.dim;
  layout_.point_stride = 1;
  layout_.offset = round_up(padding, lanes);
  layout_.component_stride = round_up(layout_.offset + round_up(particles_.size(), lanes) + padding, lanes);
  layout_.size = layout_.component_stride * std::size_t(particles_.dim);
}

std::string ParticleBody::describe() const {
  const char* formulation = options_.formulation == Formulation::corrected ? "corrected" : "classic";
  return fmt::format("{} SPH, {} particles, d = {:g} mm, h = {:g} d", formulation, particles_.size(), particles_.spacing * 1e3, options_.smoothing);
}

std::size_t ParticleBody::bytes() const {
  return mass_.size() * sizeof(double) + particles_.position.size() * (sizeof(Point) + sizeof(double)) + particles_.lattice.at.size() * sizeof(int) +
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
      if (on) out.push_back({i, particles_.volume[i]});
    }
    if (!out.empty()) break;
  }
  const double sum = std::accumulate(out.begin(), out.end(), 0.0, [](double s, const Weight& w) { return s + w.weight; });
  for (Weight& w : out) w.weight /= sum;
  return out;
}

std::vector<Weight> ParticleBody::interpolation(const Point& p) const {
  return least_squares_weights(particles_.position, particles_.dim, p, 1.6 * particles_.spacing, 1e-6 * particles_.spacing);
}

Topology ParticleBody::topology() const { return {}; }

std::vector<Facet> ParticleBody::boundary() const {
  const Lattice& lattice = particles_.lattice;
  const bool plane = particles_.dim == 2;
  Topology cells{plane ? Topology::Kind::quadrilaterals : Topology::Kind::hexahedra, {}};
  for (const auto& [i, j, k] : lattice.place) {
    std::array<std::size_t, 8> cell{};
    bool whole = true;
    for (int c = 0; c < (plane ? 4 : 8) && whole; ++c) {
      const int corner = lattice.particle(i + ((c + 1) / 2 % 2), j + (c / 2 % 2), k + c / 4);  // VTK order
      whole = corner >= 0;
      cell[c] = std::size_t(corner);
    }
    if (whole) cells.cells.push_back(cell);
  }
  return boundary_of(cells);
}

}  // namespace femsph::sph
