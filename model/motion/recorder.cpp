#include "model/motion/recorder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace femsph {

namespace {

bool on_material(Quantity q) { return q != Quantity::displacement && q != Quantity::velocity; }
bool scalar(Quantity q) { return q == Quantity::plastic_strain || q == Quantity::equivalent_stress; }

double scalar_of(const MaterialState& state, Quantity q, std::size_t k) {
  if (q == Quantity::equivalent_stress) return von_mises(state.stress[k]);
  return state.plastic.empty() ? 0.0 : state.plastic[k];
}

std::vector<Weight> weights_at(const March& march, std::size_t body, Quantity quantity, const Point& p) {
  const Discretization& d = *march.body(body).discretization;
  return on_material(quantity) ? d.material_interpolation(p) : d.interpolation(p);
}

}  // namespace

std::vector<std::string> component_names(Quantity quantity, int dim) {
  if (scalar(quantity)) return {"equivalent"};
  if (on_material(quantity)) {
    if (dim == 2) return {"xx", "yy", "zz", "xy"};
    return {"xx", "yy", "zz", "xy", "yz", "zx"};
  }
  if (dim == 2) return {"x", "y"};
  return {"x", "y", "z"};
}

std::string unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::displacement: return "m";
    case Quantity::velocity: return "m/s";
    case Quantity::stress:
    case Quantity::equivalent_stress: return "Pa";
    case Quantity::strain:
    case Quantity::plastic_strain: break;
  }
  return "1";
}

Recorder::Recorder(const March& march) {
  const Scene& scene = march.scene();
  history_.add("time", "s");
  for (const Probe& probe : scene.probes) {
    probes_.push_back({probe.name, probe.body, probe.quantity, weights_at(march, probe.body, probe.quantity, probe.point)});
    for (const std::string& c : component_names(probe.quantity, scene.dim())) history_.add(probe.name + "_" + c, unit_of(probe.quantity));
  }
  for (const char* energy : {"kinetic_energy", "strain_energy", "hourglass_energy", "external_work", "damping_loss", "viscosity_loss"})
    history_.add(energy, "J");
  if (scene.is_plastic()) history_.add("plastic_work", "J");
  const std::string axes = scene.dim() == 2 ? "xy" : "xyz";
  for (const RigidBody& body : march.rigid_bodies()) {
    for (const char a : axes) history_.add(fmt::format("{}_{}", body.name, a), "m");
    for (const char a : axes) history_.add(fmt::format("{}_v{}", body.name, a), "m/s");
    if (scene.dim() == 2) history_.add(body.name + "_turn", "rad");
  }
  if (!scene.contacts.empty()) history_.add("contact_energy", "J"), history_.add("friction_loss", "J");
  for (const Contact& contact : scene.contacts)
    for (const char a : axes) history_.add(fmt::format("contact_{}_force_{}", contact.name, a), "N");
  for (const Support& support : scene.supports) {
    if (support.name.empty()) continue;
    reactions_.push_back({&support, {}});
    for (const Weight& w : march.body(support.place.body).discretization->points_of(support.place)) reactions_.back().points.push_back(w.point);
    for (const char a : axes) history_.add(fmt::format("support_{}_force_{}", support.name, a), "N");
    for (const char a : scene.dim() == 2 ? std::string("z") : axes) history_.add(fmt::format("support_{}_moment_{}", support.name, a), "N m");
  }
  for (const Section& section : scene.sections) {
    Line line{&section, {}, {}};
    double length = 0;
    for (int c = 0; c < 3; ++c) length += (section.to[c] - section.from[c]) * (section.to[c] - section.from[c]);
    length = std::sqrt(length);
    for (int k = 0; k < section.count; ++k) {
      const double s = section.count > 1 ? double(k) / (section.count - 1) : 0.0;
      Point p;
      for (int c = 0; c < 3; ++c) p[c] = section.from[c] + s * (section.to[c] - section.from[c]);
      line.distance.push_back(s * length);
      line.points.push_back({section.name, section.body, section.quantity, weights_at(march, section.body, section.quantity, p)});
    }
    lines_.push_back(std::move(line));
  }
}

std::vector<double> Recorder::read(const March& march, const Reading& reading) const {
  const MovingBody& body = march.body(reading.body);
  const Discretization& d = *body.discretization;
  const int dim = march.scene().dim();
  if (on_material(reading.quantity)) {
    std::vector<std::size_t> points;
    for (const Weight& w : reading.weights) points.push_back(w.point);
    MaterialState state;
    d.material_state(body.u.data(), points, state);
    if (scalar(reading.quantity)) {
      double value = 0;
      for (std::size_t k = 0; k < points.size(); ++k) value += reading.weights[k].weight * scalar_of(state, reading.quantity, k);
      return {value};
    }
    const auto& values = reading.quantity == Quantity::stress ? state.stress : state.strain;
    std::vector<double> out(dim == 2 ? 4 : 6, 0.0);
    for (std::size_t k = 0; k < points.size(); ++k)
      for (std::size_t c = 0; c < out.size(); ++c) out[c] += reading.weights[k].weight * values[k][c];
    return out;
  }
  std::vector<double> out(dim, 0.0);
  const Layout& at = d.layout();
  for (const Weight& w : reading.weights)
    for (int c = 0; c < dim; ++c) {
      const std::size_t slot = at.at(w.point, c);
      // Velocity at the whole step: the last half step's and half a kick.
      out[c] += w.weight * (reading.quantity == Quantity::displacement ? body.u[slot]
                                                                       : body.v[slot] + 0.5 * march.dt() * body.inverse_mass[slot] * body.f[slot]);
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
  for (double energy : {l.kinetic, l.strain, l.hourglass, l.external, l.damping, l.viscosity}) put(energy);
  if (march.scene().is_plastic()) put(l.plastic);
  const int dim = march.scene().dim();
  for (const RigidBody& body : march.rigid_bodies()) {
    for (int c = 0; c < dim; ++c) put(body.centre()[c]);
    for (int c = 0; c < dim; ++c) put(body.velocity_now(march.dt())[c]);
    if (dim == 2) put(body.angle);
  }
  if (!march.scene().contacts.empty()) put(l.contact), put(l.friction);
  for (const Point& force : march.contact_forces())
    for (int c = 0; c < dim; ++c) put(force[c]);
  for (const Reaction& at : reactions_) {
    const auto [force, moment] = reaction(march, at);
    for (int c = 0; c < dim; ++c) put(force[c]);
    for (int c = dim == 2 ? 2 : 0; c < 3; ++c) put(moment[c]);
  }
}

/// The reaction balances every other force on a held component, which has no inertia of its own in the march.
std::array<Point, 2> Recorder::reaction(const March& march, const Reaction& at) const {
  const MovingBody& body = march.body(at.support->place.body);
  const Layout& layout = body.discretization->layout();
  const auto place = [&](std::size_t i) {
    Point x = body.discretization->position(i);
    for (int c = 0; c < layout.dim; ++c) x[c] += body.u[layout.at(i, c)];
    return x;
  };
  Point middle{};
  for (const std::size_t i : at.points)
    for (int c = 0; c < layout.dim; ++c) middle[c] += place(i)[c] / double(at.points.size());
  std::array<Point, 2> sum{};
  for (const std::size_t i : at.points) {
    Point f{}, arm = place(i);
    for (int c = 0; c < layout.dim; ++c) {
      const std::size_t slot = layout.at(i, c);
      if (at.support->fixed[c]) f[c] = -body.f[slot] - (body.viscous.empty() ? 0.0 : body.viscous[slot]);
      arm[c] -= middle[c];
    }
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      sum[0][c] += f[c];
      sum[1][c] += arm[a] * f[b] - arm[b] * f[a];
    }
  }
  return sum;
}

void Recorder::state(Archive& archive) {
  for (Column& column : history_.columns) archive(column.name, column.values);
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
