// Before the first step: where supports and loads act, masses, the step, the start.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/critical_step.hpp"
#include "model/motion/march.hpp"
#include "model/motion/mass_properties.hpp"
#include "model/numerics/parallel.hpp"
#include "model/numerics/vectors.hpp"

namespace femsph {

March::March(const Scene& scene, std::vector<std::unique_ptr<Discretization>> bodies,
             const MarchOptions& options)
    : scene_(scene) {
  adaptive_damping_ = scene.settling && scene.settling->method == SettlingMethod::damping &&
                      !scene.settling->rate;
  kinetic_damping_ = scene.settling && scene.settling->method == SettlingMethod::kinetic;
  damping_rate_ = scene.settling && scene.settling->rate ? *scene.settling->rate
                                                         : scene.damping.value_or(0.0);
  price_.threads = threads();
  PhaseTimer timer(price_, "critical step");
  std::size_t next = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (scene.bodies[b].rigid) continue;
    MovingBody body;
    body.name = scene.bodies[b].name;
    body.index = b;
    body.discretization = std::move(bodies.at(next++));
    place_supports_and_loads(body, b);
    price_.units += body.discretization->units();
    price_.bytes += body.discretization->bytes() +
                    sizeof(double) * (4 * body.u.size() + body.viscous.size() + body.mass.size());
    bodies_.push_back(std::move(body));
  }
  warnings_ = scene.warnings;
  for (const MovingBody& body : bodies_) {
    for (const std::string& text : body.discretization->warnings())
      warnings_.push_back(fmt::format("body \"{}\": {}", body.name, text));
    if (const std::string text = mass_warning(scene, body.index, *body.discretization); !text.empty())
      warnings_.push_back(text);
  }
  place_rigid_bodies_and_contacts();
  find_critical_step();
  if (!std::isfinite(critical_))
    throw MotionError("nothing in this scene can move: every displacement is held, or no body has stiffness");
  dt_ = next_dt_ = smallest_step_ = options.step.value_or(options.safety * critical_);
  critical_now_ = critical_;
  safety_ = options.safety;
  given_step_ = options.step.has_value();
  follows_ = scene.large_motion && std::any_of(bodies_.begin(), bodies_.end(), [](const MovingBody& b) {
               return b.discretization->stiffening(b.u.data()).has_value();
             });
  price_.dt = dt_;
  if (dt_ > critical_)
    throw MotionError(fmt::format(
        "the step {:.4g} s is over the limit: the largest stable step is {:.4g} s; march with "
        "--safety 0.9 instead",
        dt_, critical_));
  if (!(scene.duration / dt_ < 1e12))
    throw MotionError(fmt::format(
        "a duration of {:.4g} s takes {:.2g} steps of {:.4g} s, which no machine marches; "
        "shorten [time] duration, or take a coarser spacing",
        scene.duration, scene.duration / dt_, dt_));
}

std::vector<Weight> March::points_of(const MovingBody& body, const Place& place, const char* what) const {
  std::vector<Weight> points = body.discretization->points_of(place);
  if (points.empty())
    throw MotionError(fmt::format(
        "{}:{}:{}: this {} finds no point of body \"{}\" ({}); use a finer spacing or another place",
        scene_.file, place.source.line, place.source.column, what, body.name,
        body.discretization->describe()));
  return points;
}

void March::place_supports_and_loads(MovingBody& body, std::size_t index) {
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  for (auto* vector : {&body.u, &body.v, &body.f, &body.inverse_mass}) vector->assign(at.size, 0.0);
  if (d.has_viscosity()) body.viscous.assign(at.size, 0.0);
  if (scene_.settling || scene_.damping) body.mass.assign(at.size, 0.0);
  for (std::size_t i = 0; i < at.points; ++i)
    for (int c = 0; c < at.dim; ++c) {
      body.inverse_mass[at.at(i, c)] = 1 / d.mass()[i];
      if (!body.mass.empty()) body.mass[at.at(i, c)] = d.mass()[i];
    }
  hold_and_drive(body, index);
  for (const InitialDisplacement& start : scene_.initial_displacements)
    if (start.body == index)
      for (std::size_t i = 0; i < at.points; ++i) {
        const Point u = start.at(d.position(i));
        for (int c = 0; c < at.dim; ++c) body.u[at.at(i, c)] = u[c];
      }
  for (const Support& support : scene_.supports)
    if (support.place.body == index && support.mean)
      place_mean_support(body, support, points_of(body, support.place, "support"));
  for (std::size_t l = 0; l < scene_.loads.size(); ++l) {
    const Load& load = scene_.loads[l];
    if (load.place.body != index) continue;
    if (load.pressure != 0) {
      place_pressure(body, l);
      continue;
    }
    for (const Weight& w : points_of(body, load.place, "load"))
      for (int c = 0; c < at.dim; ++c)
        if (load.force[c] != 0) body.loads.push_back({at.at(w.point, c), w.weight * load.force[c], l});
  }
}

/// -p A, with A the outward area vector of each point's part of the place.
void March::place_pressure(MovingBody& body, std::size_t load) {
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  const Place& place = scene_.loads[load].place;
  const double thickness = at.dim == 2 ? scene_.bodies[body.index].thickness : 1.0,
               pressure = scene_.loads[load].pressure;
  const std::vector<PointArea> areas = d.outward_areas(place);
  if (areas.empty())
    throw MotionError(fmt::format(
        "{}:{}:{}: this pressure finds no piece of the boundary of body \"{}\" ({}); use a finer spacing",
        scene_.file, place.source.line, place.source.column, body.name, d.describe()));
  for (const PointArea& part : areas)
    for (int c = 0; c < at.dim; ++c)
      if (part.area[c] != 0)
        body.loads.push_back({at.at(part.point, c), -pressure * thickness * part.area[c], load});
}

void March::place_mean_support(MovingBody& body, const Support& support, const std::vector<Weight>& points) {
  const Layout& at = body.discretization->layout();
  for (int c = 0; c < at.dim; ++c) {
    if (!support.fixed[c]) continue;
    MovingBody::MeanHold hold{{}, {}, 0, 0};
    for (const Weight& w : points) {
      const std::size_t slot = at.at(w.point, c);
      hold.inverse_mass += w.weight * w.weight * body.inverse_mass[slot];
      for (const MovingBody::Driven& driven : body.driven)
        if (driven.slot == slot && driven.velocity != 0) {
          const Source& other = scene_.supports[driven.support].place.source;
          throw InputError(
              scene_.file,
              {Fault{support.place.source.line, support.place.source.column,
                     fmt::format("this support holds the mean along {} of a place of body \"{}\" where the "
                                 "one at {}:{}:{} moves points; expected places that do not meet",
                                 "xyz"[c], body.name, scene_.file, other.line, other.column)}});
        }
      if (body.inverse_mass[slot] == 0) continue;  // held by a support of its own
      for (const MovingBody::MeanHold& other : body.means)
        if (std::find(other.slots.begin(), other.slots.end(), slot) != other.slots.end())
          throw MotionError(fmt::format(
              "{}:{}:{}: two supports with mode = \"mean\" share a point of body \"{}\"; keep "
              "their places apart",
              scene_.file, support.place.source.line, support.place.source.column, body.name));
      hold.slots.push_back(slot);
      hold.weights.push_back(w.weight);
    }
    if (!hold.slots.empty()) body.means.push_back(std::move(hold));
  }
}

/// The leap-frog's first velocity belongs to half a step before the start, such that the mean of v(-1/2) and
/// v(+1/2) is v(0).
void March::start_velocities() {
  const auto [keep, push] = leap(dt_);
  for (MovingBody& body : bodies_) {
    const Layout& at = body.discretization->layout();
    for (const InitialVelocity& start : scene_.initial_velocities)
      if (start.body == body.index)
        for (std::size_t i = 0; i < at.points; ++i) {
          const Point v = start.at(body.discretization->position(i));
          for (int c = 0; c < at.dim; ++c)
            if (const std::size_t slot = at.at(i, c); body.inverse_mass[slot] != 0) body.v[slot] += v[c];
        }
    for (const MovingBody::MeanHold& hold : body.means) {  // a held mean starts at rest
      double sum = 0;
      for (std::size_t k = 0; k < hold.slots.size(); ++k) sum += hold.weights[k] * body.v[hold.slots[k]];
      for (std::size_t k = 0; k < hold.slots.size(); ++k)
        body.v[hold.slots[k]] -= hold.weights[k] * body.inverse_mass[hold.slots[k]] * sum / hold.inverse_mass;
    }
  }
  if (!ties_.empty()) ties_.match_velocities(bodies_);
  for (MovingBody& body : bodies_)
    for (std::size_t i = 0; i < body.v.size(); ++i) {
      const double force = body.viscous.empty() ? body.f[i] : body.f[i] + body.viscous[i];
      body.v[i] = (2 * body.v[i] - push * body.inverse_mass[i] * force) / (1 + keep);
    }
  find_reactions();
  for (RigidBody& body : rigid_) {
    for (const InitialVelocity& start : scene_.initial_velocities)
      if (start.body == body.index) {
        const Point v = start.at(body.centre());
        for (int c = 0; c < 3; ++c) body.velocity[c] += v[c], body.spin[c] += body.inertia[c] * start.spin[c];
      }
    body.start_from(keep, push);
  }
  const Kinetic k = kinetic();
  initial_energy_ = k.energy;
  initial_whole_ = k.energy + energy_of_half_a_kick();
  if (!scene_.initial_displacements.empty()) {  // what bringing the bodies there has stored and dissipated
    const Ledger l = ledger();
    initial_energy_ += l.strain + l.hourglass + l.plastic;
    initial_whole_ += l.strain + l.hourglass + l.plastic;
  }
  start_damping_ = k.damping;
  start_viscosity_ = k.viscosity;
}

long March::planned_steps() const {
  return since_step_ + std::max(1L, std::lround(std::ceil((scene_.duration - since_time_) / dt_ - 1e-9)));
}

/// Internal force of each point: what the discretization gave, before loads and gravity were added.
template <class Take>
void March::internal_forces(const MovingBody& body, Take&& take) const {
  AlignedVector<double> f = body.f;
  const Layout& at = body.discretization->layout();
  const auto take_off = [&](std::size_t p, const Point& force) {
    for (int c = 0; c < at.dim; ++c) f[at.at(p, c)] -= force[c];
  };
  for (const ContactPair& contact : contacts_)
    contact.each_force(std::size_t(&body - bodies_.data()), take_off);
  ties_.each_force(std::size_t(&body - bodies_.data()), take_off);
  for (const MovingBody::NodalLoad& load : body.loads)
    f[load.slot] -= load.force * scene_.loads[load.load].history.at(time());
  for (const MovingBody::MeanHold& hold : body.means)
    for (std::size_t k = 0; k < hold.slots.size(); ++k) f[hold.slots[k]] -= hold.reaction * hold.weights[k];
  for (std::size_t i = 0; i < at.points; ++i) {
    Point p{}, x = body.discretization->position(i);
    for (int c = 0; c < at.dim; ++c) {
      p[c] = f[at.at(i, c)] - (scene_.gravity ? body.discretization->mass()[i] * (*scene_.gravity)[c] : 0.0);
      if (!body.viscous.empty()) p[c] += body.viscous[at.at(i, c)];
      x[c] += scene_.large_motion ? body.u[at.at(i, c)] : 0.0;
    }
    take(x, p);
  }
}

std::array<bool, 3> March::mirrored_axes(const MovingBody& body) const {
  std::array<bool, 3> axes{};
  for (const Symmetry& s : scene_.symmetries)
    if (s.place.body == body.index) axes[s.axis()] = true;
  return axes;
}

double March::force_imbalance() const {
  double worst = 0;
  for (const MovingBody& body : bodies_) {
    Point sum{}, size{};
    const std::array<bool, 3> mirrored = mirrored_axes(body);
    internal_forces(body, [&](const Point&, const Point& f) {
      for (int c = 0; c < 3; ++c) sum[c] += mirrored[c] ? 0.0 : f[c], size[c] += std::abs(f[c]);
    });
    const double all = size[0] + size[1] + size[2];
    if (all > 0) worst = std::max(worst, (std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2])) / all);
  }
  return worst;
}

double March::moment_imbalance() const {
  double worst = 0;
  for (const MovingBody& body : bodies_) {
    Point sum{};
    double all = 0;
    const std::array<bool, 3> mirrored = mirrored_axes(body);
    internal_forces(body, [&](const Point& x, const Point& f) {
      for (int c = 0; c < 3; ++c) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        if (mirrored[a] || mirrored[b]) continue;
        sum[c] += x[a] * f[b] - x[b] * f[a];
        all += std::abs(x[a] * f[b]) + std::abs(x[b] * f[a]);
      }
    });
    if (all > 0) worst = std::max(worst, (std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2])) / all);
  }
  return worst;
}

}  // namespace femsph
