#include "model/results/recorder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/numerics/principal.hpp"
#include "model/results/flow_limit.hpp"
#include "model/results/recovery.hpp"

namespace femsph {

namespace {

double scalar_of(const MaterialState& state, Quantity q, std::size_t k) {
  if (q == Quantity::equivalent_stress) return von_mises(state.stress[k]);
  return state.plastic.empty() ? 0.0 : state.plastic[k];
}

/// The recoveries of bodies, made when first asked for, and gone once all weights are known.
class Recoveries {
 public:
  explicit Recoveries(const March& march) : march_(march) {}
  /// Null if the body has no units.
  const Recovery* of(std::size_t body) {
    const auto [known, fresh] = made_.try_emplace(body);
    if (fresh)
      if (MaterialUnits units = march_.body(body).discretization->material_units(); !units.place.empty())
        known->second.emplace(std::move(units));
    return known->second ? &*known->second : nullptr;
  }

 private:
  const March& march_;
  std::map<std::size_t, std::optional<Recovery>> made_;
};

}  // namespace

Recorder::Recorder(const March& march) {
  const Scene& scene = march.scene();
  const auto add = [&](const std::string& name, const std::string& unit) { add_column(scene, name, unit); };
  Recoveries recoveries(march);
  const auto reading_at = [&](const auto& observed, const Point& p) {
    Reading reading{observed.name, observed.body, observed.quantity, {}};
    const Discretization& d = *march.body(observed.body).discretization;
    if (!on_material(observed.quantity)) {
      reading.weights = d.interpolation(p);
      return reading;
    }
    const Recovery* rule = observed.reading == StressReading::raw ? nullptr : recoveries.of(observed.body);
    reading.raw = !rule;
    reading.weights = rule ? rule->weights(p) : d.material_interpolation(p);
    return reading;
  };
  add("time", "s");
  for (const Probe& probe : scene.probes) {
    probes_.push_back(reading_at(probe, probe.point));
    for (const std::string& c : component_names(probe.quantity, scene.dim()))
      add(probe.name + "_" + c, unit_of(probe.quantity));
  }
  for (const char* energy : {"kinetic_energy", "strain_energy", "hourglass_energy", "external_work",
                             "damping_loss", "viscosity_loss"})
    add(energy, "J");
  add("energy_imbalance", "J");
  if (scene.is_plastic()) add("plastic_work", "J");
  const std::string axes = scene.dim() == 2 ? "xy" : "xyz", turns = scene.dim() == 2 ? "z" : "xyz";
  for (const char a : axes) add(fmt::format("momentum_{}", a), "kg m/s");
  for (const char a : turns) add(fmt::format("angular_momentum_{}", a), "kg m^2/s");
  for (const RigidBody& body : march.rigid_bodies()) {
    for (const char a : axes) add(fmt::format("{}_{}", body.name, a), "m");
    for (const char a : axes) add(fmt::format("{}_v{}", body.name, a), "m/s");
    if (scene.dim() == 2) add(body.name + "_turn", "rad");
  }
  if (!scene.contacts.empty()) add("contact_energy", "J"), add("friction_loss", "J");
  for (const Contact& contact : scene.contacts)
    for (const char a : axes) add(fmt::format("contact_{}_force_{}", contact.name, a), "N");
  const std::vector<Support> holds = scene.holds();
  for (std::size_t h = 0; h < holds.size(); ++h) {
    if (holds[h].mean || scene.bodies[holds[h].place.body].rigid) continue;
    reactions_.push_back(reaction_of(march, h));
    const std::string& name = holds[h].name;
    if (name.empty()) continue;
    reported_.push_back(reactions_.size() - 1);
    for (const char a : axes) add(fmt::format("support_{}_force_{}", name, a), "N");
    for (const char a : turns) add(fmt::format("support_{}_moment_{}", name, a), "N m");
    for (const char a : axes) add(fmt::format("support_{}_centroid_{}", name, a), "m");
  }
  for (const Section& section : scene.sections) {
    Line line{&section, {}, {}};
    double length = 0;
    for (int c = 0; c < 3; ++c)
      length += (section.to[c] - section.from[c]) * (section.to[c] - section.from[c]);
    length = std::sqrt(length);
    for (int k = 0; k < section.count; ++k) {
      const double s = section.count > 1 ? double(k) / (section.count - 1) : 0.0;
      Point p;
      for (int c = 0; c < 3; ++c) p[c] = section.from[c] + s * (section.to[c] - section.from[c]);
      line.distance.push_back(s * length);
      line.points.push_back(reading_at(section, p));
    }
    lines_.push_back(std::move(line));
  }
}

/// Names of probes, rigid bodies and supports may meet in a column: "support_foot_force" and "foot".
void Recorder::add_column(const Scene& scene, const std::string& name, const std::string& unit) {
  if (history_.has(name))
    throw InputError(
        scene.file, {Fault{0, 0,
                           fmt::format("the history would have two columns \"{}\"; expected another name "
                                       "for the probe, rigid body or support that gives one of them",
                                       name)}});
  history_.add(name, unit);
}

/// What the rule has read of stress and strain (recovery.hpp): equivalent and principal stresses are those of
/// the stress.
std::vector<double> Recorder::read_material(const March& march, const Reading& reading) const {
  const MovingBody& body = march.body(reading.body);
  std::vector<std::size_t> points;
  for (const Weight& w : reading.weights) points.push_back(w.point);
  MaterialState state;
  body.discretization->material_state(body.u.data(), points, state);
  if (reading.raw && is_scalar(reading.quantity)) {
    double value = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      value += reading.weights[k].weight * scalar_of(state, reading.quantity, k);
    return {value};
  }
  if (reading.raw) state.flow_stress.clear();
  const Recovered here = recovered(reading.weights, state, march.scene().plane);
  switch (reading.quantity) {
    case Quantity::equivalent_stress:
      return {von_mises(here.stress)};
    case Quantity::plastic_strain:
      return {here.plastic};
    case Quantity::principal_stress: {
      const std::array<double, 3> principal = principal_values(here.stress);
      return {principal.begin(), principal.end()};
    }
    default:
      break;
  }
  const auto& values = reading.quantity == Quantity::stress ? here.stress : here.strain;
  return {values.begin(), values.begin() + (march.scene().dim() == 2 ? 4 : 6)};
}

std::vector<double> Recorder::read(const March& march, const Reading& reading) const {
  const MovingBody& body = march.body(reading.body);
  const Discretization& d = *body.discretization;
  const int dim = march.scene().dim();
  if (on_material(reading.quantity)) return read_material(march, reading);
  std::vector<double> out(dim, 0.0);
  const Layout& at = d.layout();
  for (const Weight& w : reading.weights)
    for (int c = 0; c < dim; ++c) {
      const std::size_t slot = at.at(w.point, c);
      out[c] += w.weight *
                (reading.quantity == Quantity::displacement ? body.u[slot] : march.velocity(body, slot));
    }
  return out;
}

void Recorder::sample(const March& march) {
  std::size_t column = 0;
  const auto put = [&](double value) { history_.columns[column++].values.push_back(value); };
  put(march.time());
  for (const Reading& probe : probes_)
    for (double value : read(march, probe)) put(value);
  const Ledger l = march.ledger();
  for (double energy : {l.kinetic, l.strain, l.hourglass, l.external, l.damping, l.viscosity, l.imbalance()})
    put(energy);
  if (march.scene().is_plastic()) put(l.plastic);
  const int dim = march.scene().dim(), turn = dim == 2 ? 2 : 0;
  const Momentum p = momentum(march);
  for (int c = 0; c < dim; ++c) put(p.linear[c]);
  for (int c = turn; c < 3; ++c) put(p.angular[c]);
  for (const RigidBody& body : march.rigid_bodies()) {
    for (int c = 0; c < dim; ++c) put(body.centre()[c]);
    for (int c = 0; c < dim; ++c) put(march.velocity(body)[c]);
    if (dim == 2) put(body.angle);
  }
  if (!march.scene().contacts.empty()) put(l.contact), put(l.friction);
  for (const Point& force : march.contact_forces())
    for (int c = 0; c < dim; ++c) put(force[c]);
  for (const std::size_t k : reported_) {
    const auto [force, moment] = reactions_[k].resultant(march);
    const Point centroid = reactions_[k].centroid(march);
    for (int c = 0; c < dim; ++c) put(force[c]);
    for (int c = turn; c < 3; ++c) put(moment[c]);
    for (int c = 0; c < dim; ++c) put(centroid[c]);
  }
  const Balance now = femsph::balance(march, reactions_);
  balance_.force = std::max(balance_.force, now.force);
  balance_.moment = std::max(balance_.moment, now.moment);
}

void Recorder::state(Archive& archive) {
  for (Column& column : history_.columns) archive(column.name, column.values);
  archive.below("balance", [&] {
    archive("force", balance_.force);
    archive("moment", balance_.moment);
  });
}

std::map<std::string, Profile> Recorder::profiles(const March& march) const {
  std::map<std::string, Profile> out;
  for (const Line& line : lines_) {
    Profile p;
    p.name = line.section->name;
    p.time = march.time();
    p.distance = line.distance;
    for (const std::string& c : component_names(line.section->quantity, march.scene().dim()))
      p.columns.push_back({c, unit_of(line.section->quantity), {}});
    for (const Reading& point : line.points) {
      const std::vector<double> values = read(march, point);
      for (std::size_t c = 0; c < values.size(); ++c) p.columns[c].values.push_back(values[c]);
    }
    out.emplace(line.section->name, std::move(p));
  }
  return out;
}

}  // namespace femsph
