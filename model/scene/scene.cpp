#include "model/scene/scene.hpp"

#include <algorithm>

namespace femsph {

Law Material::law(Plane plane) const { return LinearElastic::make(young, poisson, density, plane); }

double TimeHistory::at(double t) const {
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  if (next == 0) return factor.front();
  if (next == std::ptrdiff_t(time.size())) return factor.back();
  const double share = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return factor[next - 1] + share * (factor[next] - factor[next - 1]);
}

std::vector<std::string> Scene::effects() const {
  std::vector<std::string> on;
  const auto add = [&](bool asked, const char* name) {
    if (asked) on.emplace_back(name);
  };
  add(large_motion, "finite rotation");
  add(!supports.empty(), "supports");
  add(!loads.empty(), "loads");
  add(!initial_velocities.empty(), "initial velocity");
  add(std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.rigid; }), "rigid bodies");
  add(!contacts.empty(), "contact");
  add(std::any_of(contacts.begin(), contacts.end(), [](const Contact& contact) { return contact.friction > 0; }), "friction");
  add(gravity.has_value(), "gravity");
  add(damping.has_value(), "damping");
  add(settling && settling->method == SettlingMethod::damping, "settling by damping");
  add(settling && settling->method == SettlingMethod::kinetic, "settling by kinetic damping");
  return on;
}

}  // namespace femsph
