// What is done before the first step: bodies, effects, the critical time step, initial velocities.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/motion/bodies/critical_step.hpp"
#include "model/motion/bodies/mass_properties.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph {

March::March(const Scene& scene, std::vector<std::unique_ptr<Discretization>> bodies,
             const MarchOptions& options)
    : motion_{scene} {
  adaptive_damping_ = scene.settling && scene.settling->method == SettlingMethod::damping &&
                      !scene.settling->rate;
  kinetic_damping_ = scene.settling && scene.settling->method == SettlingMethod::kinetic;
  motion_.damping_rate = scene.settling && scene.settling->rate ? *scene.settling->rate
                                                                : scene.damping.value_or(0.0);
  motion_.price.threads = threads();
  PhaseTimer timer(motion_.price, "critical step");
  std::size_t next = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (scene.bodies[b].rigid) continue;
    add_body(b, std::move(bodies.at(next++)));
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].rigid) motion_.rigid.emplace_back(scene, b);
  effects_ = EffectList(motion_);
  for (const Effect* effect : effects_.all()) motion_.price.bytes += effect->bytes();
  warnings_ = scene.warnings;
  for (const MovingBody& body : motion_.bodies) {
    for (const std::string& text : body.discretization->warnings())
      warnings_.push_back(fmt::format("body \"{}\": {}", body.name, text));
    if (const std::string text = mass_warning(scene, body.index, *body.discretization); !text.empty())
      warnings_.push_back(text);
  }
  find_critical_step();
  if (!std::isfinite(critical_))
    throw MotionError("nothing in this scene can move: every displacement is held, or no body has stiffness");
  motion_.dt = motion_.next_dt = smallest_step_ = options.step.value_or(options.safety * critical_);
  critical_now_ = critical_;
  safety_ = options.safety;
  given_step_ = options.step.has_value();
  follows_ = scene.large_motion &&
             std::any_of(motion_.bodies.begin(), motion_.bodies.end(), [](const MovingBody& b) {
               return b.discretization->stiffening(b.u.data()).has_value();
             });
  motion_.price.dt = motion_.dt;
  if (motion_.dt > critical_)
    throw MotionError(fmt::format(
        "the step {:.4g} s is over the limit: the largest stable step is {:.4g} s; march with "
        "--safety 0.9 instead",
        motion_.dt, critical_));
  if (!(scene.duration / motion_.dt < 1e12))
    throw MotionError(fmt::format(
        "a duration of {:.4g} s takes {:.2g} steps of {:.4g} s, which no machine marches; "
        "shorten [time] duration, or take a coarser spacing",
        scene.duration, scene.duration / motion_.dt, motion_.dt));
}

void March::add_body(std::size_t index, std::unique_ptr<Discretization> discretization) {
  const Scene& scene = motion_.scene;
  MovingBody body;
  body.name = scene.bodies[index].name;
  body.index = index;
  body.discretization = std::move(discretization);
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  for (auto* vector : {&body.u, &body.v, &body.f, &body.inverse_mass}) vector->assign(at.size, 0.0);
  if (d.has_viscosity()) body.viscous.assign(at.size, 0.0);
  if (scene.settling || scene.damping) body.mass.assign(at.size, 0.0);
  for (std::size_t i = 0; i < at.points; ++i)
    for (int c = 0; c < at.dim; ++c) {
      body.inverse_mass[at.at(i, c)] = 1 / d.mass()[i];
      if (!body.mass.empty()) body.mass[at.at(i, c)] = d.mass()[i];
    }
  motion_.price.units += d.units();
  motion_.price.bytes += d.bytes() +
                         sizeof(double) * (4 * body.u.size() + body.viscous.size() + body.mass.size());
  motion_.bodies.push_back(std::move(body));
}

/// The smallest critical step of the bodies, with springs that bound the stiffness which effects add. A
/// contact that opens within a step creates an energy of up to (omega dt)^2 of that of the point, with
/// omega^2 = k / m of its spring; omega dt <= 1.1 limits that (by trial: with 1.4 the energy of a chattering
/// contact doubled).
void March::find_critical_step() {
  critical_ = critical_alone_ = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < motion_.bodies.size(); ++b) {
    const MovingBody& body = motion_.bodies[b];
    const double alone = femsph::critical_step(*body.discretization, body.inverse_mass);
    critical_alone_ = std::min(critical_alone_, alone);
    double with = alone;
    AlignedVector<double> springs(effects_.with(Hook::add_springs).empty() ? 0 : body.u.size(), 0.0);
    for (const Effect* effect : effects_.with(Hook::add_springs))
      with = std::min(with, effect->add_springs(motion_, b, 4 / (alone * alone), springs));
    double own = 0;
    for (std::size_t i = 0; i < springs.size(); ++i) own = std::max(own, springs[i] * body.inverse_mass[i]);
    if (own > 0)
      with = std::min({with, 1.1 / std::sqrt(own),
                       femsph::critical_step(*body.discretization, body.inverse_mass, springs)});
    critical_ = std::min(critical_, with);
  }
}

/// Computes v(-1/2), half a step before the start, such that the mean of v(-1/2) and v(+1/2) is v(0).
void March::start_velocities() {
  const auto [keep, push] = motion_.leap(motion_.dt);
  for (Effect* effect : effects_.all()) effect->start(motion_);
  for (Effect* effect : effects_.all()) effect->constrain_start(motion_);
  for (MovingBody& body : motion_.bodies)
    for (std::size_t i = 0; i < body.v.size(); ++i) {
      const double force = body.viscous.empty() ? body.f[i] : body.f[i] + body.viscous[i];
      body.v[i] = (2 * body.v[i] - push * body.inverse_mass[i] * force) / (1 + keep);
    }
  for (Effect* effect : effects_.with(Hook::find_reactions)) effect->find_reactions(motion_);
  for (RigidBody& body : motion_.rigid) body.start_from(keep, push);
  const Kinetic k = kinetic();
  initial_energy_ = k.energy;
  initial_whole_ = k.energy + energy_of_half_a_kick();
  const auto strained = [](const Effect* effect) { return effect->strains_the_start(); };
  if (std::any_of(effects_.all().begin(), effects_.all().end(),
                  strained)) {  // the energy stored and dissipated by initial displacements
    const Ledger l = ledger();
    initial_energy_ += l.strain + l.hourglass + l.plastic;
    initial_whole_ += l.strain + l.hourglass + l.plastic;
  }
  start_damping_ = k.damping;
  start_viscosity_ = k.viscosity;
}

long March::planned_steps() const {
  return motion_.since_step +
         std::max(
             1L, std::lround(std::ceil((motion_.scene.duration - motion_.since_time) / motion_.dt - 1e-9)));
}

}  // namespace femsph
