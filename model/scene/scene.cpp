#include "model/scene/scene.hpp"

#include <algorithm>
#include <cmath>

namespace femsph {

Law Material::law(Plane plane) const { return LinearElastic::make(young, poisson, density, plane); }

double TimeHistory::at(double t) const {
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  if (next == 0) return factor.front();
  if (next == std::ptrdiff_t(time.size())) return factor.back();
  const double share = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return factor[next - 1] + share * (factor[next] - factor[next - 1]);
}

bool Region::contains(const Point& p, double tolerance) const {
  for (int a = 0; a < 3; ++a)
    if (p[a] < lower[a] - tolerance || p[a] > upper[a] + tolerance) return false;
  return true;
}

int Bar::axis() const {
  int longest = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(to[a] - from[a]) > std::abs(to[longest] - from[longest])) longest = a;
  return longest;
}

std::vector<Support> Scene::holds() const {
  std::vector<Support> all = supports;
  for (const Symmetry& s : symmetries) {
    Support hold;
    hold.place = s.place;
    hold.fixed[s.axis()] = true;
    all.push_back(hold);
  }
  return all;
}

std::vector<std::string> Scene::effects() const {
  std::vector<std::string> on;
  const auto add = [&](bool asked, const char* name) {
    if (asked) on.emplace_back(name);
  };
  add(large_motion, "finite rotation");
  add(!supports.empty(), "supports");
  add(!symmetries.empty(), "symmetry");
  add(!bars.empty(), "bars");
  add(!loads.empty(), "loads");
  add(!initial_velocities.empty(), "initial velocity");
  add(gravity.has_value(), "gravity");
  add(damping.has_value(), "damping");
  add(settling && settling->method == SettlingMethod::damping, "settling by damping");
  add(settling && settling->method == SettlingMethod::kinetic, "settling by kinetic damping");
  return on;
}

}  // namespace femsph
