#include "model/results/history_columns.hpp"

#include <fmt/format.h>

namespace femsph {
namespace {

/// Adds columns, each with a new name. Names of probes, rigid bodies and supports can give equal columns: a
/// probe "support_foot_force" and a support "foot".
struct Columns {
  const Scene& scene;
  History history{};

  void add(const std::string& name, const std::string& unit) {
    if (history.has(name))
      throw InputError(
          scene.file, {Fault{0, 0,
                             fmt::format("the history would have two columns \"{}\"; expected another name "
                                         "for the probe, rigid body or support that gives one of them",
                                         name)}});
    history.add(name, unit);
  }
};

}  // namespace

const std::vector<std::string>& energy_columns() {
  static const std::vector<std::string> all = {
      "kinetic_energy", "strain_energy", "hourglass_energy", "external_work", "damping_loss",
      "viscosity_loss", "plastic_work",  "contact_energy",   "friction_loss"};
  return all;
}

std::vector<std::size_t> holds_with_reactions(const Scene& scene) {
  const std::vector<Support> holds = scene.holds();
  std::vector<std::size_t> all;
  for (std::size_t h = 0; h < holds.size(); ++h)
    if (!holds[h].mean && !scene.bodies[holds[h].place.body].rigid) all.push_back(h);
  return all;
}

History history_columns(const Scene& scene) {
  Columns to{scene};
  to.add("time", "s");
  for (const Probe& probe : scene.probes)
    for (const std::string& c : component_names(*probe.quantity, scene.dim()))
      to.add(probe.name + "_" + c, probe.quantity->unit);
  for (std::size_t e = 0; e < 6; ++e) to.add(energy_columns()[e], "J");
  to.add("energy_imbalance", "J");
  if (scene.is_plastic()) to.add("plastic_work", "J");
  const std::string axes = scene.dim() == 2 ? "xy" : "xyz", turns = scene.dim() == 2 ? "z" : "xyz";
  for (const char a : axes) to.add(fmt::format("momentum_{}", a), "kg m/s");
  for (const char a : turns) to.add(fmt::format("angular_momentum_{}", a), "kg m^2/s");
  for (const Body& body : scene.bodies) {
    if (!body.rigid) continue;
    for (const char a : axes) to.add(fmt::format("{}_{}", body.name, a), "m");
    for (const char a : axes) to.add(fmt::format("{}_v{}", body.name, a), "m/s");
    if (scene.dim() == 2) to.add(body.name + "_turn", "rad");
  }
  if (!scene.contacts.empty()) to.add("contact_energy", "J"), to.add("friction_loss", "J");
  for (const Contact& contact : scene.contacts)
    for (const char a : axes) to.add(fmt::format("contact_{}_force_{}", contact.name, a), "N");
  const std::vector<Support> holds = scene.holds();
  for (const std::size_t h : holds_with_reactions(scene)) {
    const std::string& name = holds[h].name;
    if (name.empty()) continue;
    for (const char a : axes) to.add(fmt::format("support_{}_force_{}", name, a), "N");
    for (const char a : turns) to.add(fmt::format("support_{}_moment_{}", name, a), "N m");
    for (const char a : axes) to.add(fmt::format("support_{}_centroid_{}", name, a), "m");
  }
  return std::move(to.history);
}

}  // namespace femsph
