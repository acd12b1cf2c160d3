#include "model/motion/effects/mean_supports.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace femsph {

MeanSupports::MeanSupports(Motion& motion) {
  for (MovingBody& body : motion.bodies)
    for (const Support& support : motion.scene.supports)
      if (support.place.body == body.index && support.mean) place(motion, body, support);
}

void MeanSupports::place(const Motion& motion, MovingBody& body, const Support& support) {
  const Scene& scene = motion.scene;
  const Layout& at = body.discretization->layout();
  const std::vector<Weight> points = motion.points_of(body, support.place, "support");
  for (int c = 0; c < at.dim; ++c) {
    if (!support.fixed[c]) continue;
    MeanHold hold{std::size_t(&body - motion.bodies.data()), {}, {}};
    for (const Weight& w : points) {
      const std::size_t slot = at.at(w.point, c);
      hold.inverse_mass += w.weight * w.weight * body.inverse_mass[slot];
      for (const MovingBody::Driven& driven : body.driven)
        if (driven.slot == slot && driven.velocity != 0) {
          const Source& other = scene.supports[driven.support].place.source;
          throw InputError(
              scene.file,
              {Fault{support.place.source.line, support.place.source.column,
                     fmt::format("this support holds the mean along {} of a place of body \"{}\" where the "
                                 "one at {}:{}:{} moves points; expected places that do not meet",
                                 "xyz"[c], body.name, scene.file, other.line, other.column)}});
        }
      if (body.inverse_mass[slot] == 0) continue;  // fixed by another support
      if (std::find(body.constrained.begin(), body.constrained.end(), slot) != body.constrained.end())
        throw MotionError(fmt::format(
            "{}:{}:{}: two supports with mode = \"mean\" share a point of body \"{}\"; keep their places "
            "apart",
            scene.file, support.place.source.line, support.place.source.column, body.name));
      hold.slots.push_back(slot);
      hold.weights.push_back(w.weight);
    }
    body.constrained.insert(body.constrained.end(), hold.slots.begin(), hold.slots.end());
    if (!hold.slots.empty()) holds_.push_back(std::move(hold));
  }
}

/// A fixed mean starts at rest.
void MeanSupports::constrain_start(Motion& motion) {
  for (const MeanHold& hold : holds_) {
    MovingBody& body = motion.bodies[hold.body];
    double sum = 0;
    for (std::size_t k = 0; k < hold.slots.size(); ++k) sum += hold.weights[k] * body.v[hold.slots[k]];
    for (std::size_t k = 0; k < hold.slots.size(); ++k)
      body.v[hold.slots[k]] -= hold.weights[k] * body.inverse_mass[hold.slots[k]] * sum / hold.inverse_mass;
  }
}

void MeanSupports::constrain(Motion& motion) {
  for (MeanHold& hold : holds_) {
    MovingBody& body = motion.bodies[hold.body];
    const auto project = [&](AlignedVector<double>& f) {
      double sum = 0;
      for (std::size_t k = 0; k < hold.slots.size(); ++k)
        sum += hold.weights[k] * body.inverse_mass[hold.slots[k]] * f[hold.slots[k]];
      const double reaction = -sum / hold.inverse_mass;
      for (std::size_t k = 0; k < hold.slots.size(); ++k) f[hold.slots[k]] += reaction * hold.weights[k];
      return reaction;
    };
    hold.reaction = project(body.f);
    if (!body.viscous.empty()) hold.reaction += project(body.viscous);
  }
}

void MeanSupports::each_reaction(const Motion& motion, const MovingBody& body,
                                 const std::function<void(std::size_t slot, double)>& take) const {
  for (const MeanHold& hold : holds_)
    if (&motion.bodies[hold.body] == &body)
      for (std::size_t k = 0; k < hold.slots.size(); ++k)
        take(hold.slots[k], hold.reaction * hold.weights[k]);
}

}  // namespace femsph
