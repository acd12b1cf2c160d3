#include "model/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace femsph {

double TimeHistory::at(double t) const {
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  if (next == 0) return factor.front();
  if (next == std::ptrdiff_t(time.size())) return factor.back();
  const double share = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return factor[next - 1] + share * (factor[next] - factor[next - 1]);
}

namespace {

Point product(const Matrix& a, const Point& x) {
  Point y{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) y[i] += a[i][j] * x[j];
  return y;
}

}  // namespace

Point InitialVelocity::at(const Point& p) const {
  const Point r{p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]};
  Point v = product(gradient, r);
  const double amplitude = profile ? std::sin(2 * std::acos(-1.0) * (p[profile->axis] - profile->origin) /
                                              profile->wavelength)
                                   : 1.0;
  for (int c = 0; c < 3; ++c) {
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    v[c] = amplitude * (v[c] + velocity[c] + spin[a] * r[b] - spin[b] * r[a]);
  }
  return v;
}

Point InitialDisplacement::at(const Point& p) const {
  return product(gradient, {p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]});
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

std::array<bool, 3> Scene::mirrored_axes(std::optional<std::size_t> body) const {
  std::array<bool, 3> axes{};
  for (const Symmetry& s : symmetries)
    if (!body || s.place.body == *body) axes[s.axis()] = true;
  return axes;
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

LinearElastic elastic_of(const Scene& scene, std::size_t body, const std::string& what) {
  const Material& material = scene.material_of(scene.bodies.at(body));
  const Law law = material.law(scene.plane);
  if (const auto* elastic = std::get_if<LinearElastic>(&law)) return *elastic;
  throw Refusal(
      what + " is linear elastic; the material \"" + material.name + "\" is " + material.entry().name);
}

bool Scene::is_plastic() const {
  const auto yields = [&](const std::string& material) { return materials.at(material).yields(); };
  return std::any_of(bodies.begin(), bodies.end(),
                     [&](const Body& body) { return !body.rigid && yields(body.material); }) ||
         std::any_of(bars.begin(), bars.end(), [&](const Bar& bar) { return yields(bar.material); });
}

/// Each name once. Of the law of a bar only the yield stress counts.
std::vector<std::string> material_effects(const Scene& scene) {
  std::vector<std::string> on;
  const auto add = [&](const std::string& name) {
    if (std::find(on.begin(), on.end(), name) == on.end()) on.push_back(name);
  };
  for (const Body& body : scene.bodies)
    if (!body.rigid)
      for (const std::string& effect : scene.material_of(body).effects()) add(effect);
  for (const Bar& bar : scene.bars)
    if (scene.materials.at(bar.material).yields()) add("plasticity");
  return on;
}

}  // namespace femsph
