// Supports that hold every point of a place: which components they hold, and which of these have inertia in
// the march because they move.

#include "model/motion/effects/supports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/effects/mean_supports.hpp"

namespace femsph {

namespace {

/// Whether two that hold the same component want the same of it.
bool agree(const Support& a, const Support& b, int c) {
  if (a.velocity[c] != b.velocity[c]) return false;
  return a.velocity[c] == 0 || (a.history.time == b.history.time && a.history.factor == b.history.factor);
}

std::string wish(const Support& support, int c) {
  return support.velocity[c] == 0
             ? "holds it at rest"
             : fmt::format("moves it at {:g} m/s{}", support.velocity[c],
                           support.history.time.size() > 1 ? " times its history" : "");
}

[[noreturn]] void refuse(const Scene& scene, const MovingBody& body, const Support& one, const Support& other,
                         int c, const Point& x) {
  throw InputError(
      scene.file,
      {Fault{other.place.source.line, other.place.source.column,
             fmt::format("this support {} along {} and the one at {}:{}:{} {}: both have the point ({:.6g}, "
                         "{:.6g}, {:.6g}) m of body \"{}\"; "
                         "expected supports that agree there, or places that do not meet (see \"within\")",
                         wish(other, c), "xyz"[c], scene.file, one.place.source.line, one.place.source.column,
                         wish(one, c), x[0], x[1], x[2], body.name)}});
}

void hold_components_of(const Motion& motion, const std::vector<Support>& holds, MovingBody& body) {
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  for (std::size_t h = 0; h < holds.size(); ++h) {
    if (holds[h].place.body != body.index || holds[h].mean) continue;
    for (const Weight& w : motion.points_of(body, holds[h].place, "support"))
      for (int c = 0; c < at.dim; ++c)
        if (holds[h].fixed[c]) body.held.push_back({w.point, c, h});
  }
  std::sort(body.held.begin(), body.held.end());
  for (std::size_t k = 0; k < body.held.size(); ++k) {
    const auto [point, c, h] = body.held[k];
    const std::size_t slot = at.at(point, c);
    if (k > 0 && body.held[k - 1].point == point && body.held[k - 1].component == c) {
      const Support &one = holds[body.held[k - 1].hold], &other = holds[h];
      if (agree(one, other, c)) continue;
      refuse(motion.scene, body, one, other, c, d.position(point));
    }
    double start = 0;
    for (const InitialVelocity& initial : motion.scene.initial_velocities)
      if (initial.body == body.index) start += initial.at(d.position(point))[c];
    body.inverse_mass[slot] = 0;
    if (holds[h].velocity[c] == 0 && start == 0) continue;
    body.driven.push_back({slot, holds[h].velocity[c], h, d.mass()[point], start});
    if (!body.mass.empty()) body.mass[slot] = 0;  // MovedSupports::after_kick counts its damping
  }
  std::sort(
      body.driven.begin(), body.driven.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
}

MadeEffect make_supports(Motion& motion) {
  hold_components(motion);
  auto means = std::make_unique<MeanSupports>(motion);
  if (means->holds().empty()) return {};
  return made(std::move(means));
}

}  // namespace

void hold_components(Motion& motion) {
  const std::vector<Support> holds = motion.scene.holds();
  for (MovingBody& body : motion.bodies) hold_components_of(motion, holds, body);
}

EffectEntry supports_effect() {
  EffectEntry e{{"supports", "displacements held where they start, or their mean over a place"}};
  e.asked_by = "[[supports]]";
  e.on = [](const Scene& s) { return !s.supports.empty(); };
  e.outside = true;
  e.rank_off = 0;
  e.make = make_supports;
  e.needed = [](const Motion& m) { return !m.scene.supports.empty() || !m.scene.symmetries.empty(); };
  return e;
}

}  // namespace femsph
