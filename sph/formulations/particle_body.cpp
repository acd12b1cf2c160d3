#include "sph/formulations/particle_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "model/numerics/array.hpp"
#include "model/numerics/least_squares.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/structured.hpp"
#include "sph/operators/side_areas.hpp"
#include "sph/particles/partial_volumes.hpp"

namespace femsph::sph {

namespace {

/// How far apart in number two neighbours of a lattice can be: what a block may load beyond the first and the
/// last particle.
std::size_t reach(const Particles& p, const Kernel& kernel) {
  std::size_t far = lanes, step = 1;
  for (int a = 0; a < p.dim; ++a) {
    far += std::size_t(std::ceil(kernel.radius() / p.lattice.spacing[a])) * step;
    step *= std::size_t(p.lattice.count[a]);
  }
  return far;
}

std::vector<Weight> scaled_to_one(std::vector<Weight> out) {
  const double sum = std::accumulate(
      out.begin(), out.end(), 0.0, [](double s, const Weight& w) { return s + w.weight; });
  for (Weight& w : out) w.weight /= sum;
  return out;
}

/// The particle itself, or the one that it mirrors.
std::size_t own_of(const Particles& p, int particle) {
  const std::size_t i = std::size_t(particle);
  return i < p.size() ? i : p.mirrored[i - p.size()].of;
}

/// Calls take(place, phi) for the corners of the lattice's cell around x.
template <class Take>
void each_hat(const Particles& p, const Point& x, Take&& take) {
  const Lattice& lattice = p.lattice;
  std::array<int, 3> cell{};
  Point part{};
  for (int a = 0; a < p.dim; ++a) {
    const double t = (x[a] - lattice.origin[a]) / lattice.spacing[a];
    cell[a] = int(std::floor(t));
    part[a] = t - cell[a];
  }
  for (int v = 0; v < 1 << p.dim; ++v) {
    double phi = 1;
    std::array<int, 3> at = cell;
    for (int a = 0; a < p.dim; ++a) phi *= v >> a & 1 ? part[a] : 1 - part[a], at[a] += v >> a & 1;
    if (phi > 1e-12) take(at, phi);
  }
}

/// What each corner of a facet has of its outward area, by the shape functions: a_k = integral of N_k n, so
/// that sum x_k (x) a_k is the integral of x (x) n. Two Gauss points a direction are exact.
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

/// A flat side that a round shape does not cut itself: of its own cells, as fine as the particles, the free
/// sides that lie there.
std::vector<SidePiece> flat_side(const Shape& shape, const std::string& side, double size, double spacing) {
  const StructuredShape* structured = shape.structured();
  if (!structured) return {};
  std::array<int, 3> divisions{1, 1, 1};
  for (std::size_t a = 0; a < std::size_t(shape.dim()); ++a)
    divisions[a] = std::max(1, int(std::lround((shape.upper()[a] - shape.lower()[a]) / spacing)));
  std::vector<SidePiece> out = free_sides(structured->mesh(divisions), size);
  const auto axis = std::size_t(side[0] - 'x');
  std::erase_if(out, [&](const SidePiece& piece) {
    return !shape.on_side(side, piece.at, 1e-6 * spacing) ||
           std::abs(piece.area[axis]) < (1 - 1e-9) * piece.size;
  });
  return out;
}

/// The sides of a shape that a lattice fills in steps, each piece once, beyond those that `pieces` has.
/// Symmetry planes are none: the body goes on there.
void add_other_sides(const Shape& shape, double size, const Particles& p,
                     std::vector<std::vector<SidePiece>>& pieces) {
  const double spacing = p.spacing;
  const auto on_plane = [&](const SidePiece& piece) {
    return std::any_of(p.planes.begin(), p.planes.end(), [&](const MirrorPlane& m) {
      return std::abs(piece.at[std::size_t(m.axis)] - m.at) < 1e-6 * spacing;
    });
  };
  const auto key = [&](const Point& x) {
    std::array<long, 3> k{};
    for (std::size_t a = 0; a < 3; ++a) k[a] = std::lround(x[a] / (1e-3 * size));
    return k;
  };
  std::set<std::array<long, 3>> known;
  for (const SidePiece& piece : pieces[0]) known.insert(key(piece.at));
  const auto add = [&](std::vector<SidePiece> side) {
    std::erase_if(side, [&](const SidePiece& piece) {
      return dot(piece.area, piece.area) == 0 || on_plane(piece) || !known.insert(key(piece.at)).second;
    });
    if (!side.empty()) pieces.push_back(std::move(side));
  };
  const CellMesh* mesh = shape.cells();
  const bool named_all = shape.names_whole_boundary();
  for (const std::string& name : mesh ? mesh->groups : shape.sides()) {
    std::vector<SidePiece> side = shape.side_pieces(name, size);
    add(side.empty() && !named_all && name.size() == 2 ? flat_side(shape, name, size, spacing)
                                                       : std::move(side));
  }
  if (mesh) add(free_sides(*mesh, size));  // those without a name
}

}  // namespace

ParticleBody::ParticleBody(const Scene& scene, std::size_t body, const Options& options, Particles particles,
                           const Kernel& kernel)
    : options_(options),
      particles_(std::move(particles)),
      shape_(scene.bodies[body].shape),
      thickness_(scene.bodies[body].thickness) {
  const Material& material = scene.material_of(scene.bodies[body]);
  density_ = material.density;
  wave_speed_ = std::visit([](const auto& law) { return law.wave_speed(); }, material.law(scene.plane));
  for (std::size_t i = 0; i < particles_.size(); ++i)
    mass_.push_back(particles_.own_volume(i) * thickness_ * density_);
  const std::span<const Point> own(particles_.position.data(), particles_.size());
  const std::vector<BarRow> rows = bar_rows(scene, body, own, 1e-6 * particles_.spacing);
  bars_ = SmearedBars(rows, particles_, thickness_);
  bars_.add_mass(mass_);
  bars_text_ = femsph::describe(rows, scene);
  const std::size_t padding = reach(particles_, kernel);
  steps_ = particles_.cells.empty() && !shape_->is_box();
  layout_.points = particles_.size();
  layout_.dim = particles_.dim;
  layout_.point_stride = 1;
  layout_.offset = round_up(padding, lanes);
  layout_.component_stride = round_up(
      layout_.offset + round_up(particles_.position.size(), lanes) + padding, lanes);
  layout_.size = layout_.component_stride * std::size_t(particles_.dim);
}

std::string ParticleBody::describe() const {
  const char* formulation = options_.formulation == Formulation::corrected ? "corrected" : "classic";
  return fmt::format("{} SPH, {} particles, d = {:g} mm, h = {:g} d{}", formulation, particles_.size(),
                     particles_.spacing * 1e3, options_.smoothing, bars_text_);
}

std::size_t ParticleBody::bytes() const {
  return (mass_.size() + mirrored_.size()) * sizeof(double) + particles_.mirrored.size() * sizeof(Mirrored) +
         bars_.bytes() + particles_.position.size() * (sizeof(Point) + 2 * sizeof(double)) +
         particles_.lattice.at.size() * sizeof(int) +
         particles_.lattice.place.size() * sizeof(std::array<int, 3>);
}

std::vector<std::string> ParticleBody::warnings() const {
  std::vector<std::string> out = warnings_;
  if (!particles_.note.empty()) out.insert(out.begin(), particles_.note);
  return out;
}

/// A lattice has particles outside of the body too; none of these is on a side that the lattice meets.
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
  // A side without area on a lattice that misses it: the nearest layer stands for it.
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

std::vector<PointArea> ParticleBody::outward_areas(const Place& place) const {
  std::vector<PointArea> out;
  const double size = 0.2 * particles_.spacing;
  const bool own_operator = steps_ && options_.formulation == Formulation::corrected &&
                            options_.mass == MassRule::trapezoid;
  const Kernel kernel(options_.kernel, particles_.dim, options_.smoothing * particles_.spacing);
  if (own_operator && place.sides.empty() && !place.within && !place.point) {  // all around: side_areas.hpp
    const std::vector<Point> areas = operator_areas(particles_, kernel, options_);
    for (std::size_t i = 0; i < areas.size(); ++i) out.push_back({i, areas[i]});
    return out;
  }
  if (steps_ && place.sides.size() == 1) {
    std::vector<SidePiece> mine = shape_->side_pieces(place.sides[0], size);
    if (mine.empty() && own_operator && place.sides[0].size() == 2)
      mine = flat_side(*shape_, place.sides[0], size, particles_.spacing);
    const auto counts = [&](const SidePiece& piece) {
      return dot(piece.area, piece.area) > 0 && (!place.within || place.within->contains(piece.at, 0.0));
    };
    for (const SidePiece& piece : mine)
      if (counts(piece)) share_out(piece, out);
    if (own_operator && !out.empty()) {  // side_areas.hpp
      std::erase_if(mine, [&](const SidePiece& piece) { return !counts(piece); });
      std::vector<std::vector<SidePiece>> pieces{std::move(mine)};
      std::vector<std::vector<PointArea>> hats;
      add_other_sides(*shape_, size, particles_, pieces);
      for (const auto& side : pieces) {
        hats.emplace_back();
        for (const SidePiece& piece : side) share_out(piece, hats.back());
      }
      std::vector<Point> areas = operator_areas(particles_, kernel, options_);
      for (std::size_t i = 0; i < areas.size(); ++i)
        for (const MirrorPlane& m : particles_.planes)  // across a symmetry plane nothing moves
          if (std::abs(particles_.position[i][std::size_t(m.axis)] - m.at) < 1e-6 * particles_.spacing)
            areas[i][std::size_t(m.axis)] = 0;
      return balanced_side(particles_, pieces, hats, std::move(areas), 2 * kernel.radius());
    }
  }
  if (!out.empty() || particles_.cells.empty())
    return out.empty() ? Discretization::outward_areas(place) : out;
  std::vector<char> there(particles_.size(), 0);
  for (const Weight& w : points_of(place)) there[w.point] = 1;
  const int corners = 2 * (particles_.dim - 1);
  for (const Facet& f : boundary()) {
    if (!std::all_of(f.points.begin(), f.points.begin() + corners, [&](std::size_t p) { return there[p]; }))
      continue;
    const auto area = corner_areas(particles_, f);
    for (std::size_t k = 0; k < std::size_t(corners); ++k) out.push_back({f.points[k], area[k]});
  }
  return out;
}

std::vector<Point> ParticleBody::uniform_stress_areas() const {
  if (!options_.projection || options_.formulation != Formulation::corrected ||
      options_.mass != MassRule::trapezoid || particles_.regular || steps_)
    return {};
  std::vector<Point> out(particles_.size(), Point{});
  for (const Facet& f : boundary()) {
    const auto area = corner_areas(particles_, f);
    for (std::size_t k = 0; k < std::size_t(2 * (particles_.dim - 1)); ++k)
      out[f.points[k]] = out[f.points[k]] + area[k];
  }
  return out;
}

/// By the hat functions of the lattice, so that force and moment are those of the piece; see
/// partial_volumes.hpp.
void ParticleBody::share_out(const SidePiece& piece, std::vector<PointArea>& out) const {
  const Lattice& lattice = particles_.lattice;
  const auto give = [&](int particle, double factor) {
    Point area = factor * piece.area;
    std::size_t own = std::size_t(particle);
    if (own >= particles_.size()) {
      const Mirrored& image = particles_.mirrored[own - particles_.size()];
      for (int c = 0; c < 3; ++c) area[c] *= image.sign[c];
      own = image.of;
    }
    out.push_back({own, area});
  };
  each_hat(particles_, piece.at, [&](const std::array<int, 3>& at, double phi) {
    if (const int particle = lattice.particle(at[0], at[1], at[2]); particle >= 0) return give(particle, phi);
    const auto particle_at = [&](const std::array<int, 3>& p) { return lattice.particle(p[0], p[1], p[2]); };
    for (const auto& [heir, factor] :
         heirs(particles_.dim, at, particle_at, [&](int p) { return particles_.volume[std::size_t(p)]; }))
      give(heir, phi * factor);
  });
}

/// The particles whose cells a side cuts. They share its area by the hat functions of the lattice; what these
/// give to others goes to the particle in whose cell the piece lies. Of several sides those that all of them
/// cut. Empty if the body is a box, or a side has no area.
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
      each_hat(particles_, piece.at, [&](const std::array<int, 3>& at, double phi) {
        const int particle = particles_.lattice.particle(at[0], at[1], at[2]);
        const std::size_t own = particle < 0 ? owner : own_of(particles_, particle);
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

/// The body's own particle in whose cell x lies, or the nearest if that place has none.
std::size_t ParticleBody::owner_of(const Point& x) const {
  const Lattice& lattice = particles_.lattice;
  std::array<int, 3> at{};
  for (int a = 0; a < particles_.dim; ++a)
    at[a] = int(std::lround((x[a] - lattice.origin[a]) / lattice.spacing[a]));
  if (const int particle = lattice.particle(at[0], at[1], at[2]); particle >= 0)
    return own_of(particles_, particle);
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
          look(own_of(particles_, particle));
  for (std::size_t p = 0; p < particles_.size() && !std::isfinite(best); ++p) look(p);
  return nearest;
}

/// The area of the facets between the points of a fitted body's side, as their shape functions share it.
void ParticleBody::weigh_by_area(std::vector<Weight>& points) const {
  std::vector<double> area(particles_.size(), 0.0);
  std::vector<char> there(particles_.size(), 0);
  for (const Weight& w : points) there[w.point] = 1;
  const int corners = 2 * (particles_.dim - 1);
  for (const Facet& f : boundary()) {
    if (!std::all_of(f.points.begin(), f.points.begin() + corners, [&](std::size_t p) { return there[p]; }))
      continue;
    const auto parts = corner_areas(particles_, f);
    for (std::size_t k = 0; k < std::size_t(corners); ++k) area[f.points[k]] += norm(parts[k]);
  }
  if (std::any_of(points.begin(), points.end(), [&](const Weight& w) { return area[w.point] == 0; }))
    return;  // an inner side, or one without area
  for (Weight& w : points) w.weight = area[w.point];
}

/// Share of a particle's cell, as far as it lies in the body, that lies in the region; directions in which
/// the region is flat do not count.
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

/// Share of the full angle that the body fills at a particle. Where masses do not follow it: share of the
/// lattice's cells around that are whole.
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

/// The strain of a particle on the surface is that of a place inside, or, uncorrected, none at all: q = f^10
/// (1e-3 on a face) lets it tell no more than where there is nothing else.
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
  std::vector<char> inside(
      particles_.size(),
      1);  // what stands outside of a side that cuts the lattice would touch others too soon
  for (std::size_t i = 0; steps_ && i < inside.size(); ++i) inside[i] = in_body(i);
  for (const auto& [i, j, k] : lattice.place) {
    std::array<std::size_t, 8> cell{};
    bool whole = true;
    for (int c = 0; c < (plane ? 4 : 8) && whole; ++c) {
      const int corner = lattice.particle(i + ((c + 1) / 2 % 2), j + (c / 2 % 2), k + c / 4);  // VTK order
      whole = corner >= 0 && std::size_t(corner) < particles_.size() &&
              inside[std::size_t(corner)];  // no mirrored ones
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
  return Trouble{
      fmt::format(
          "particle {} has turned inside out: its volume is {:.3g} times what it was", worst, det[worst]),
      "the body is crushed or torn there, more than the first neighbours can tell: try a finer "
      "spacing, a gentler load, or sph-classic-share, "
      "whose neighbours follow",
      place_now(worst, u)};
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
      mirrored_[layout_.at(particles_.size() + k, c)] = particles_.mirrored[k].sign[c] *
                                                        u[layout_.at(particles_.mirrored[k].of, c)];
  return mirrored_.data();
}

}  // namespace femsph::sph
