#include "model/results/recorder.hpp"

#include <cmath>

#include "model/results/flow_limit.hpp"
#include "model/results/history_columns.hpp"
#include "model/results/recovery.hpp"

namespace femsph {

namespace {

StateAtPoint state_of(const MaterialState& state, std::size_t k) {
  StateAtPoint at;
  at.stress = state.stress[k], at.strain = state.strain[k];
  at.plastic = state.plastic.empty() ? 0.0 : state.plastic[k];
  return at;
}

/// The recovery of each body, made when it is first needed.
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
  history_ = history_columns(scene);
  Recoveries recoveries(march);
  const auto reading_at = [&](const auto& observed, const Point& p) {
    Reading reading{observed.name, observed.body, observed.quantity, {}};
    const Discretization& d = *march.body(observed.body).discretization;
    if (!observed.quantity->on_material) {
      reading.weights = d.interpolation(p);
      return reading;
    }
    const Recovery* rule = observed.reading == StressReading::raw ? nullptr : recoveries.of(observed.body);
    reading.raw = !rule;
    reading.weights = rule ? rule->weights(p) : d.material_interpolation(p);
    return reading;
  };
  for (const Probe& probe : scene.probes) probes_.push_back(reading_at(probe, probe.point));
  const std::vector<Support> holds = scene.holds();
  for (const std::size_t h : holds_with_reactions(scene)) {
    if (!holds[h].name.empty()) reported_.push_back(reactions_.size());
    reactions_.push_back(reaction_of(march, h));
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

/// Recovered stress and strain (recovery.hpp); equivalent and principal stresses are those of the recovered
/// stress. With the reading "raw", scalars are interpolated from their values at the material points.
std::vector<double> Recorder::read_material(const March& march, const Reading& reading) const {
  const MovingBody& body = march.body(reading.body);
  std::vector<std::size_t> points;
  for (const Weight& w : reading.weights) points.push_back(w.point);
  MaterialState state;
  body.discretization->material_state(body.u.data(), points, state);
  const Quantity& quantity = *reading.quantity;
  if (reading.raw && quantity.is_scalar()) {
    double value = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      value += reading.weights[k].weight * quantity.read(state_of(state, k))[0];
    return {value};
  }
  if (reading.raw) state.flow_stress.clear();
  const Recovered here = recovered(reading.weights, state, march.scene().plane);
  StateAtPoint at;
  at.stress = here.stress, at.strain = here.strain, at.plastic = here.plastic;
  return values_at(quantity, at, march.scene().dim());
}

std::vector<double> Recorder::read(const March& march, const Reading& reading) const {
  if (reading.quantity->on_material) return read_material(march, reading);
  const MovingBody& body = march.body(reading.body);
  const Layout& layout = body.discretization->layout();
  const int dim = march.scene().dim();
  StateAtPoint at;
  for (const Weight& w : reading.weights)
    for (int c = 0; c < dim; ++c) {
      const std::size_t slot = layout.at(w.point, c);
      at.displacement[c] += w.weight * body.u[slot];
      at.velocity[c] += w.weight * march.velocity(body, slot);
    }
  return values_at(*reading.quantity, at, dim);
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
    for (const std::string& c : component_names(*line.section->quantity, march.scene().dim()))
      p.columns.push_back({c, line.section->quantity->unit, {}});
    for (const Reading& point : line.points) {
      const std::vector<double> values = read(march, point);
      for (std::size_t c = 0; c < values.size(); ++c) p.columns[c].values.push_back(values[c]);
    }
    out.emplace(line.section->name, std::move(p));
  }
  return out;
}

}  // namespace femsph
