#include "sph/formulations/particle_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "model/numerics/array.hpp"
#include "model/numerics/vectors.hpp"
#include "model/scene/shapes/structured.hpp"
#include "sph/operators/side_areas.hpp"
#include "sph/particles/lattice_hats.hpp"
#include "sph/particles/partial_volumes.hpp"

namespace femsph::sph {

namespace {

/// The largest difference between the numbers of two neighbours on a lattice, and one block more: so far
/// beyond the first and the last particle a block may load values.
std::size_t reach(const Particles& p, const Kernel& kernel) {
  std::size_t far = lanes, step = 1;
  for (int a = 0; a < p.dim; ++a) {
    far += std::size_t(std::ceil(kernel.radius() / p.lattice.spacing[a])) * step;
    step *= std::size_t(p.lattice.count[a]);
  }
  return far;
}

/// Pieces of a flat side for which a round shape gives none: the faces of its cells, as fine as the
/// particles, that lie on the side.
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

/// Adds to `pieces` the other sides of a shape whose sides cut the lattice, each piece once. Symmetry planes
/// are left out: they are not part of the surface.
void add_other_sides(const Shape& shape, double size, const Particles& p,
                     std::vector<std::vector<SidePiece>>& pieces) {
  const auto on_plane = [&](const SidePiece& piece) {
    return std::any_of(
        p.planes.begin(), p.planes.end(), [&](const MirrorPlane& m) { return p.on_plane(piece.at, m); });
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
    add(side.empty() && !named_all && name.size() == 2 ? flat_side(shape, name, size, p.spacing)
                                                       : std::move(side));
  }
  if (mesh) add(free_sides(*mesh, size));  // the sides without a name
}

}  // namespace

ParticleBody::ParticleBody(const Scene& scene, std::size_t body, const Options& options, Particles particles,
                           const Kernel& kernel)
    : options_(options),
      formulation_(formulation_named(options.formulation)),
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
  return fmt::format("{} SPH, {} particles, d = {:g} mm, h = {:g} d{}", formulation_.word, particles_.size(),
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

std::vector<PointArea> ParticleBody::outward_areas(const Place& place) const {
  std::vector<PointArea> out;
  const double size = 0.2 * particles_.spacing;
  const bool own_operator = steps_ && formulation_.corrected && options_.mass == MassRule::trapezoid;
  const Kernel kernel(options_.kernel, particles_.dim, options_.smoothing * particles_.spacing);
  if (own_operator && place.sides.empty() && !place.within &&
      !place.point) {  // the whole surface: side_areas.hpp
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
      for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = particles_.along_planes(i, areas[i]);
      return balanced_side(particles_, pieces, hats, std::move(areas), 2 * kernel.radius());
    }
  }
  if (!out.empty() || particles_.cells.empty())
    return out.empty() ? Discretization::outward_areas(place) : out;
  return facet_areas(points_of(place));
}

/// Shares the area of a piece among particles by the hat functions of the lattice, so that force and moment
/// are those of the piece; see partial_volumes.hpp.
void ParticleBody::share_out(const SidePiece& piece, std::vector<PointArea>& out) const {
  const Lattice& lattice = particles_.lattice;
  const auto give = [&](int particle, double factor) {
    Point area = factor * piece.area;
    for (int c = 0; c < 3; ++c) area[std::size_t(c)] *= particles_.sign(std::size_t(particle), c);
    out.push_back({particles_.own(std::size_t(particle)), area});
  };
  each_hat(lattice, particles_.dim, piece.at, [&](const std::array<int, 3>& at, double phi) {
    if (const int particle = lattice.particle(at[0], at[1], at[2]); particle >= 0) return give(particle, phi);
    const auto particle_at = [&](const std::array<int, 3>& p) { return lattice.particle(p[0], p[1], p[2]); };
    for (const auto& [heir, factor] :
         heirs(particles_.dim, at, particle_at, [&](int p) { return particles_.volume[std::size_t(p)]; }))
      give(heir, phi * factor);
  });
}

Topology ParticleBody::topology() const { return {}; }

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
