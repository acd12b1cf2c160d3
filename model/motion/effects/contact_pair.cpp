#include "model/motion/effects/contact_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/bodies/motion.hpp"
#include "model/numerics/parallel.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

ContactPair::ContactPair(const Scene& scene, const Contact& contact, const std::array<Party, 2>& parties,
                         const std::vector<MovingBody>& bodies)
    : scene_(scene), contact_(contact) {
  constexpr double share =
      0.25;  // of rho c^2 / d: the contact is as compliant as four spacings of the softer body
  kappa_ = spacing_ = std::numeric_limits<double>::infinity();
  double thickness = std::numeric_limits<double>::infinity();
  for (const Party& party : parties)
    if (!party.rigid)
      thickness = std::min(
          thickness, scene.dim() == 2 ? scene.bodies[bodies[party.index].index].thickness : 1.0);
  for (int s = 0; s < 2; ++s) {
    sides_[s].party = parties[s];
    if (parties[s].rigid) continue;
    const MovingBody& body = bodies[parties[s].index];
    const Discretization& d = *body.discretization;
    const double density = scene.material_of(scene.bodies[body.index]).density;
    sides_[s].surface.emplace_back(body, density, thickness);
    if (sides_[s].surface[0].facets.empty())
      fail(fmt::format("body \"{}\" has no boundary between its points", body.name), d.position(0));
    kappa_ = std::min(
        kappa_, share * contact.stiffness * density * d.wave_speed() * d.wave_speed() / d.spacing());
    spacing_ = std::min(spacing_, d.spacing());
    wave_speed_ = std::max(wave_speed_, d.wave_speed());
  }
  skin_ = 0.3 * spacing_;
  depth_ = 0.5 * spacing_;
  overhang_ = 0.05 * spacing_;
  slack_ = 1e-9 * spacing_;  // bodies that touch at the start do so only up to rounding errors
  for (int s = 0; s < 2; ++s) {
    if (parties[s].rigid) continue;
    const double mine = sides_[s].surface[0].facet_area(),
                 other = parties[1 - s].rigid ? 0.0 : sides_[1 - s].surface[0].facet_area();
    const double weight = parties[1 - s].rigid ? 1.0 : other / (mine + other);
    passes_.push_back(
        {s, weight, std::vector<PointHistory>(sides_[s].surface[0].point.size()), {}, {}, {}, {}});
  }
}

void ContactPair::fail(const std::string& what, const Point& at) const {
  throw MotionError(fmt::format(
      "{}:{}:{}: contact \"{}\": {}, at ({:.6g}, {:.6g}, {:.6g}) m", scene_.file, contact_.source.line,
      contact_.source.column, contact_.name, what, at[0], at[1], at[2]));
}

double ContactPair::add_springs(std::size_t index, const MovingBody& body,
                                const std::vector<RigidBody>& rigids, double frequency2,
                                AlignedVector<double>& springs) const {
  double limit = std::numeric_limits<double>::infinity();
  for (const Pass& pass : passes_) {
    const Side& side = sides_[pass.from];
    if (side.party.index != index) continue;
    const Party& other = sides_[1 - pass.from].party;
    const Surface& surface = side.surface[0];
    double bound = 4 * pass.weight;  // theta = 1: 2 from this pass, 2 from the other, which loads no point
                                     // more than this one
    if (other.rigid) {
      const RigidBody& rigid = rigids[other.index];
      double area = 0;
      for (const Point& a : surface.area) area += norm(a);
      area = std::min(area, rigid.surface() * surface.thickness);
      const double own = kappa_ * area / rigid.least_mass();  // 1/s^2
      const double theta = own < 0.5 * frequency2 ? own / (frequency2 - own) : 1.0;
      bound = 1 + theta;
      if (own > 0) limit = std::min(limit, 2 / std::sqrt((1 + 1 / theta) * own));
    }
    const Layout& at = body.discretization->layout();
    for (std::size_t p = 0; p < surface.point.size(); ++p)
      for (int c = 0; c < at.dim; ++c)
        springs[at.at(surface.point[p], c)] += bound * kappa_ *
                                               std::min(norm(surface.area[p]), surface.area_limit[p]);
  }
  return limit;
}

void ContactPair::add_forces(std::vector<MovingBody>& moving, std::vector<RigidBody>& rigid, long step,
                             double dt) {
  const Bodies bodies{moving, rigid};
  stored_ = 0;
  touching_ = 0;
  force_ = {};
  if (step >= next_search_) search(bodies, step, dt);
  for (Side& side : sides_)
    if (!side.party.rigid) side.surface[0].move_active(moving[side.party.index]);
  for (Pass& pass : passes_) {
    pass.forces.resize(pass.points.size());
    const auto look = [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        pass.forces[k] = force_on_point(
            bodies, pass, k, pass.histories[pass.points[k]], step, step == 0 ? 0.0 : dt);
    };
    parallel_for(pass.points.size(), 8, look,
                 16);  // a point costs about as much as the forces of 16 particles of a plane body
  }
  for (const Pass& pass : passes_)
    for (std::size_t k = 0; k < pass.points.size(); ++k) apply(bodies, pass, k, step);
  if (touching_ == 0) return;
  for (Side& side : sides_)
    if (!side.party.rigid) side.surface[0].add_forces_to(moving[side.party.index]);
}

Projection ContactPair::project(Bodies bodies, const Pass& pass, int piece, const Point& x) const {
  const Side& other = sides_[1 - pass.from];
  if (other.party.rigid) return bodies.rigid[other.party.index].project(piece, x);
  const Surface& surface = other.surface[0];
  return project_onto_facet(surface.dim, surface.corners(surface.facets[std::size_t(piece)]), x);
}

bool ContactPair::find_piece(Bodies bodies, const Pass& pass, std::size_t k, PointHistory& history,
                             Projection& found) const {
  const Surface& own = sides_[pass.from].surface[0];
  const std::size_t p = pass.points[k];
  if (history.piece >=
      0) {  // a point keeps its piece until it has left it, so that normals do not jump at edges
    found = project(bodies, pass, history.piece, own.now[p]);
    if (found.beyond <= (history.touches ? overhang_ : 1e-6 * spacing_)) return found.gap < -slack_;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int c = pass.begin[k]; c < pass.begin[k + 1]; ++c) {
    const Projection s = project(bodies, pass, pass.pieces[std::size_t(c)], own.now[p]);
    const double distance = s.gap * s.gap + s.beyond * s.beyond;
    if (s.gap < -depth_ || distance >= nearest || dot(own.area[p], s.normal) > -0.1 * norm(own.area[p]))
      continue;
    nearest = distance;
    found = s;
    history.piece = pass.pieces[std::size_t(c)];
  }
  return nearest < std::numeric_limits<double>::infinity() && found.gap < -slack_ &&
         found.beyond <= overhang_;
}

ContactPair::PointForce ContactPair::force_on_point(Bodies bodies, const Pass& pass, std::size_t k,
                                                    PointHistory& history, long step, double dt) const {
  const Surface& own = sides_[pass.from].surface[0];
  const std::size_t p = pass.points[k];
  PointForce on_point;
  const bool inside = find_piece(bodies, pass, k, history, on_point.at);
  const double area = inside ? std::min(own.area_limit[p], -dot(own.area[p], on_point.at.normal)) : 0.0;
  on_point.depth = -on_point.at.gap - slack_;
  if (inside && step == 0 && on_point.depth > 1e-6 * spacing_) {
    on_point.kind = PointForce::Kind::overlap;
  } else if (inside && on_point.depth > depth_) {
    on_point.kind = PointForce::Kind::too_deep;
  } else if (area <= 0) {
    release(bodies, pass, p, history, dt, on_point);
  } else {
    const double stiffness = pass.weight * kappa_ * area, pressing = stiffness * on_point.depth;
    on_point.kind = PointForce::Kind::press;
    on_point.force = pressing * on_point.at.normal;
    on_point.stored = 0.5 * stiffness * on_point.depth * on_point.depth;
    history.touches = true;
    if (contact_.friction > 0) add_friction(bodies, pass, p, history, stiffness, pressing, dt, on_point);
  }
  return on_point;
}

void ContactPair::apply(Bodies bodies, const Pass& pass, std::size_t k, long step) {
  const PointForce& on_point = pass.forces[k];
  loss_ += on_point.slip;
  if (on_point.kind == PointForce::Kind::none) return;
  Surface& own = sides_[pass.from].surface[0];
  const std::size_t p = pass.points[k];
  if (on_point.kind == PointForce::Kind::overlap)
    fail(fmt::format("the bodies overlap by {:.4g} mm at the start; expected them apart or touching",
                     1e3 * on_point.depth),
         own.now[p]);
  if (on_point.kind == PointForce::Kind::too_deep)
    fail(fmt::format("a point went {:.4g} mm deep at step {}, more than half a spacing; raise its stiffness, "
                     "or take a finer spacing",
                     1e3 * on_point.depth, step),
         own.now[p]);
  stored_ += on_point.stored;
  deepest_ = std::max(deepest_, on_point.depth);
  ++touching_;
  own.force[p] = own.force[p] + on_point.force;
  force_ = force_ + (pass.from == 1 ? 1.0 : -1.0) * on_point.force;
  apply_reaction(bodies, pass, pass.histories[p].piece, on_point.at, own.now[p], on_point.force);
}

/// Adds the friction force. The stretch of the spring follows the sliding motion; the part beyond mu f / k is
/// slip. Slip dissipates its length times the mean of the old and the new spring force, with which the energy
/// balance closes.
void ContactPair::add_friction(Bodies bodies, const Pass& pass, std::size_t p, PointHistory& history,
                               double k, double pressing, double dt, PointForce& on_point) const {
  const Side &own = sides_[pass.from], &other = sides_[1 - pass.from];
  const Projection& at = on_point.at;
  Point sliding = own.surface[0].velocity(bodies.moving[own.party.index], p);
  if (other.party.rigid) {
    sliding = sliding - bodies.rigid[other.party.index].velocity_at(own.surface[0].now[p]);
  } else {
    const Surface& surface = other.surface[0];
    const Facet& f = surface.facets[std::size_t(history.piece)];
    for (int c = 0; c < 2 * (surface.dim - 1); ++c)
      sliding = sliding - at.share[c] * surface.velocity(bodies.moving[other.party.index], f.points[c]);
  }
  Point stretch = history.stretch + dt * sliding;
  stretch = stretch - dot(stretch, at.normal) * at.normal;
  const Point trial = stretch;
  const double length = norm(trial), most = contact_.friction * pressing;
  if (k * length > most) stretch = (most / (k * length)) * trial;
  const Point pull = k * stretch;
  on_point.slip += 0.5 * dot(history.pull + pull, trial - stretch);
  history.stretch = stretch;
  history.pull = pull;
  on_point.stored += 0.5 * dot(pull, stretch);
  on_point.force = on_point.force - pull;
}

/// Applies the opposite of `force`, which acts at x, to the other body: at x on a rigid body, at the foot on
/// a facet. The shift from x to the foot would lose the moment m = (x - foot) x force, which is not zero with
/// friction. Forces c_a n on the points of the facet add it: those with sum c_a = 0 and sum c_a (x_a x n) = m
/// whose sum of squares is least.
void ContactPair::apply_reaction(Bodies bodies, const Pass& pass, int piece, const Projection& at,
                                 const Point& x, const Point& force) {
  Side& other = sides_[1 - pass.from];
  if (other.party.rigid) return bodies.rigid[other.party.index].push(x, -1.0 * force);
  Surface& surface = other.surface[0];
  const Facet& f = surface.facets[std::size_t(piece)];
  const int corners = 2 * (surface.dim - 1);
  for (int c = 0; c < corners; ++c)
    surface.force[f.points[c]] = surface.force[f.points[c]] - at.share[c] * force;
  if (contact_.friction == 0) return;
  const Point wanted = cross(at.normal, cross(x - at.foot, -1.0 * force));  // sum c_a x_a, along the facet
  Point middle{};
  for (int c = 0; c < corners; ++c) middle = middle + (1.0 / corners) * surface.now[f.points[c]];
  Point a = surface.now[f.points[1]] - surface.now[f.points[0]];
  a = a - dot(a, at.normal) * at.normal;
  a = (1 / norm(a)) * a;
  const Point b = cross(at.normal, a);
  double aa = 0, ab = 0, bb = surface.dim == 2 ? 1.0 : 0.0;
  for (int c = 0; c < corners; ++c) {
    const Point d = surface.now[f.points[c]] - middle;
    aa += dot(d, a) * dot(d, a);
    ab += dot(d, a) * dot(d, b);
    bb += dot(d, b) * dot(d, b);
  }
  const double wa = dot(wanted, a), wb = dot(wanted, b), det = aa * bb - ab * ab;
  const Point slope = ((bb * wa - ab * wb) / det) * a + ((aa * wb - ab * wa) / det) * b;
  for (int c = 0; c < corners; ++c)
    surface.force[f.points[c]] = surface.force[f.points[c]] +
                                 dot(slope, surface.now[f.points[c]] - middle) * at.normal;
}

/// A point that lifts off slips by the whole remaining stretch of its friction spring.
void ContactPair::release(Bodies bodies, const Pass& pass, std::size_t p, PointHistory& history, double dt,
                          PointForce& on_point) const {
  if (dot(history.pull, history.pull) > 0) {
    on_point.at = project(bodies, pass, history.piece, sides_[pass.from].surface[0].now[p]);
    add_friction(bodies, pass, p, history, kappa_, 0, dt, on_point);
  }
  history = {history.piece};
}

/// The present forces and depths follow from the positions; the histories and the lists of near pieces do
/// not.
void ContactPair::state(Archive& archive) {
  archive("next_search", next_search_);
  archive("friction_loss", loss_);
  archive("deepest", deepest_);
  archive("touching", touching_);  // the next step compares with it
  for (std::size_t s = 0; s < sides_.size(); ++s)
    for (Surface& surface : sides_[s].surface)
      archive.below("side_" + std::to_string(s), [&] {
        archive("now", surface.now);
        archive("area", surface.area);
        archive("active", surface.active);
      });
  for (std::size_t k = 0; k < passes_.size(); ++k)
    archive.below("pass_" + std::to_string(k), [&] {
      Pass& pass = passes_[k];
      archive("points", pass.points);
      archive("begin", pass.begin);
      archive("pieces", pass.pieces);
      archive.each("piece", pass.histories, &PointHistory::piece);
      archive.each("touches", pass.histories, &PointHistory::touches);
      archive.each("stretch", pass.histories, &PointHistory::stretch);
      archive.each("pull", pass.histories, &PointHistory::pull);
    });
}

}  // namespace femsph
