#include "model/motion/effects/loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/numerics/vectors.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph {
namespace {

using namespace scene_reader;

KeyTable load_keys() {
  return {"[[loads]]", "A force on a place, or a pressure on a side.",
          place_keys({{"force", key_holds::vector(dimension::force),
                       "The total force; it is distributed over the nodes or particles of the place.", false,
                       "unless \"pressure\" is given"},
                      {"pressure", key_holds::quantity(dimension::pressure),
                       "Instead of a force: the pressure on one side, positive inwards, on its undeformed "
                       "area. Only with motion = \"small\"."},
                      history_key("the load")})};
}

void read_loads(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("loads")) {
    const auto place = read_place(fields, reading);
    const bool by_pressure = fields.has("pressure");
    const bool needs_force = !by_pressure && !fields.misspelt({"pressure"});
    const auto force = fields.vector(
        "force", needs_force ? Need::required : Need::optional, dimension::force, reading.dim);
    const auto pressure = fields.quantity("pressure", Need::optional, dimension::pressure);
    const auto history = read_history(fields);
    fields.done();
    if (by_pressure && force)
      fields.fault("pressure", "both \"force\" and \"pressure\"; expected one of them");
    const bool shape_known =
        place && reading.scene.bodies[place->body].shape;  // with a faulty shape its sides are not known
    if (by_pressure && place && (shape_known || place->point) && place->sides.size() != 1)
      fields.fault("pressure", "\"pressure\" needs one side of a body; expected at = \"x+\" or the like");
    if (by_pressure && reading.scene.large_motion)
      fields.fault(
          "pressure", "\"pressure\" follows no large motion; expected motion = \"small\", or a \"force\"");
    if (place && (force || pressure) && history)
      reading.scene.loads.push_back({*place, force.value_or(Point{}), *history, pressure.value_or(0)});
  }
}

}  // namespace

EffectEntry loads_effect() {
  EffectEntry e{{"loads", "a force on a place or a pressure on a side, times a history"}};
  e.asked_by = "[[loads]]";
  e.on = [](const Scene& s) { return !s.loads.empty(); };
  e.tables = {load_keys(), history_keys("[loads.history]", "a load")};
  e.read = read_loads;
  e.outside = true;
  e.listed_off = false;
  e.make = make_effect<Loads>;
  return e;
}

Loads::Loads(Motion& motion) : scene_(motion.scene), nodal_(motion.bodies.size()) {
  for (const MovingBody& body : motion.bodies)
    for (std::size_t l = 0; l < scene_.loads.size(); ++l) {
      if (scene_.loads[l].place.body != body.index) continue;
      if (scene_.loads[l].pressure != 0)
        share_out_pressure(motion, body, l);
      else
        share_out(motion, body, l);
    }
}

void Loads::share_out(const Motion& motion, const MovingBody& body, std::size_t l) {
  const Load& load = scene_.loads[l];
  const Layout& at = body.discretization->layout();
  auto& nodal = nodal_[std::size_t(&body - motion.bodies.data())];
  for (const Weight& w : motion.points_of(body, load.place, "load"))
    for (int c = 0; c < at.dim; ++c)
      if (load.force[c] != 0) nodal.push_back({at.at(w.point, c), w.weight * load.force[c], l});
}

/// -p A, with A the outward area vector of each point's part of the place.
void Loads::share_out_pressure(const Motion& motion, const MovingBody& body, std::size_t l) {
  const Discretization& d = *body.discretization;
  const Layout& at = d.layout();
  const Place& place = scene_.loads[l].place;
  const double thickness = at.dim == 2 ? scene_.bodies[body.index].thickness : 1.0,
               pressure = scene_.loads[l].pressure;
  const std::vector<PointArea> areas = d.outward_areas(place);
  if (areas.empty())
    throw MotionError(fmt::format(
        "{}:{}:{}: this pressure finds no piece of the boundary of body \"{}\" ({}); use a finer spacing",
        scene_.file, place.source.line, place.source.column, body.name, d.describe()));
  auto& nodal = nodal_[std::size_t(&body - motion.bodies.data())];
  for (const PointArea& part : areas)
    for (int c = 0; c < at.dim; ++c)
      if (part.area[c] != 0) nodal.push_back({at.at(part.point, c), -pressure * thickness * part.area[c], l});
}

void Loads::push_body(const Motion& motion, MovingBody& body) {
  for (const NodalLoad& load : on(motion, body))
    body.f[load.slot] += load.force * scene_.loads[load.load].history.at(motion.time());
}

void Loads::push_rigid(const Motion& motion, RigidBody& body) {
  for (const Load& load : scene_.loads)
    if (load.place.body == body.index) body.force = body.force + load.history.at(motion.time()) * load.force;
}

void Loads::work_on_body(const Motion& motion, const MovingBody& body, double& work) const {
  const double now = motion.time(), next = motion.time_of(motion.step + 1);
  for (const NodalLoad& load : on(motion, body)) {
    const TimeHistory& h = scene_.loads[load.load].history;
    work += load.force * 0.5 * (h.at(now) + h.at(next)) * motion.dt * body.v[load.slot];
  }
}

void Loads::work_on_rigid(const Motion& motion, const RigidBody& body, double& work) const {
  const double now = motion.time(), next = motion.time_of(motion.step + 1);
  for (const Load& load : scene_.loads)
    if (load.place.body == body.index)
      work += 0.5 * (load.history.at(now) + load.history.at(next)) * motion.dt *
              dot(load.force, body.velocity);
}

bool Loads::changes_after(double t) const {
  return std::any_of(scene_.loads.begin(), scene_.loads.end(), [&](const Load& load) {
    const TimeHistory& h = load.history;
    double last = 0;  // s: the last change of the history
    for (std::size_t k = 1; k < h.factor.size(); ++k)
      if (h.factor[k] != h.factor[k - 1]) last = h.time[k];
    return last > t;
  });
}

void Loads::each_force(const Motion& motion, const MovingBody& body, const TakeForce& take) const {
  for (const NodalLoad& load : on(motion, body)) {
    const auto [point, c] = component_of(body.discretization->layout(), load.slot);
    Point f{};
    f[c] = load.force * scene_.loads[load.load].history.at(motion.time());
    take(point, f);
  }
}

Point Loads::excess_force(const Motion& motion, const MovingBody& body) const {
  Point more{};  // than the total of the scene
  for (const NodalLoad& load : on(motion, body))
    if (scene_.loads[load.load].pressure == 0) {
      Point f{};
      f[component_of(body.discretization->layout(), load.slot).second] =
          load.force * scene_.loads[load.load].history.at(motion.time());
      more = more + f;
    }
  for (const Load& load : scene_.loads)
    if (load.place.body == body.index && load.pressure == 0)
      more = more - load.history.at(motion.time()) * load.force;
  return more;
}

void Loads::each_force_on_rigid(const Motion& motion, const RigidBody& body,
                                const std::function<void(const Point&)>& take) const {
  for (const Load& load : scene_.loads)
    if (load.place.body == body.index) take(load.history.at(motion.time()) * load.force);
}

void Loads::size_on_body(const Motion& motion, const MovingBody& body, double& sum) const {
  for (const NodalLoad& load : on(motion, body))
    sum += std::abs(load.force * scene_.loads[load.load].history.at(motion.time()));
}

void Loads::size_on_rigid(const Motion& motion, const RigidBody& body, double& sum) const {
  for (const Load& load : scene_.loads)
    if (load.place.body == body.index)
      sum += std::abs(load.history.at(motion.time())) * sum_of_magnitudes(load.force);
}

}  // namespace femsph
