#pragma once
// Scenes and a static solver for the tests of fem/.

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "fem/fem.hpp"
#include "model/scene/shapes/box.hpp"
#include "state_of.hpp"

namespace femsph::test {

/// The word of an element, as fem::Options takes it.
struct Element {
  const char* word;
  operator std::string() const { return word; }
  bool operator==(const Element& other) const { return std::string_view(word) == other.word; }
  static const Element full, sri, one_point, assumed_strain;
};
inline constexpr Element Element::full{"full"}, Element::sri{"sri"}, Element::one_point{"one-point"},
    Element::assumed_strain{"assumed-strain"};
inline const std::vector<Element> all_elements{
    Element::full, Element::sri, Element::one_point, Element::assumed_strain};

/// One body of steel-like numbers.
inline Scene scene_of(std::shared_ptr<const Shape> shape, Plane plane, double young, double poisson,
                      double thickness = 1.0) {
  Scene s;
  s.plane = plane;
  s.materials["m"] = Material{"m", young, poisson, 7850.0};
  s.bodies.push_back(Body{"body", std::move(shape), thickness, "m"});
  return s;
}

inline Scene box_scene(Plane plane, Point size, double young = 210e9, double poisson = 0.3,
                       double thickness = 1.0) {
  return scene_of(
      std::make_shared<Box>(plane == Plane::none ? 3 : 2, Point{}, size), plane, young, poisson, thickness);
}

/// The cantilever 1000 x 100 x 100 mm, E 210 GPa, nu 0.3, clamped at x-, 25 kN down at the corner (x+, y+).
inline Scene cantilever() {
  Scene s = box_scene(Plane::stress, {1.0, 0.1, 0}, 210e9, 0.3, 0.1);
  s.supports.push_back({Place{0, {"x-"}, {}, {}}, {true, true, true}});
  s.loads.push_back({Place{0, {"x+", "y+"}, {}, {}}, {0, -25e3, 0}, {}});
  s.probes.push_back({"tip", 0, quantity_named("displacement"), {1.0, 0.05, 0}});
  return s;
}

/// Fills a flat nodal vector from a field over the undeformed body.
inline std::vector<double> field(const Discretization& d, const std::function<Point(const Point&)>& value) {
  std::vector<double> u(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i) {
    const Point v = value(d.position(i));
    for (int c = 0; c < d.layout().dim; ++c) u[d.layout().at(i, c)] = v[c];
  }
  return u;
}

inline std::vector<double> random_field(const Discretization& d, double size, unsigned seed = 1) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  return field(d, [&](const Point&) { return Point{uniform(engine), uniform(engine), uniform(engine)}; });
}

inline std::vector<double> force(Discretization& d, const std::vector<double>& u) {
  std::vector<double> f(d.layout().size), v(d.layout().size, 0.0);
  d.internal_force(u.data(), v.data(), 0.0, f.data(), nullptr);
  return f;
}

inline std::vector<double> stiffness(const Discretization& d, const std::vector<double>& x) {
  std::vector<double> y(d.layout().size);
  d.stiffness(x.data(), y.data());
  return y;
}

inline double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double s = 0;
  for (std::size_t i = 0; i < a.size(); ++i) s += a[i] * b[i];
  return s;
}

inline double largest(const std::vector<double>& a) {
  double m = 0;
  for (const double x : a) m = std::max(m, std::abs(x));
  return m;
}

inline double value_at(const Discretization& d, const std::vector<double>& u, const Point& p, int component) {
  double s = 0;
  for (const Weight& w : d.interpolation(p)) s += w.weight * u[d.layout().at(w.point, component)];
  return s;
}

/// Static displacement under the scene's loads: conjugate gradients on stiffness() with the fixed dofs taken
/// out, preconditioned by the lumped mass.
inline std::vector<double> static_displacement(const Discretization& d, const Scene& scene,
                                               double tolerance = 1e-9) {
  const Layout& layout = d.layout();
  std::vector<char> free(layout.size, 0);
  for (std::size_t i = 0; i < layout.points; ++i)
    for (int c = 0; c < layout.dim; ++c) free[layout.at(i, c)] = 1;
  for (const Support& support : scene.supports)
    for (const Weight& w : d.points_of(support.place))
      for (int c = 0; c < layout.dim; ++c)
        if (support.fixed[c]) free[layout.at(w.point, c)] = 0;
  std::vector<double> r(layout.size, 0.0), x(layout.size, 0.0), scale(layout.size, 0.0), z(layout.size), p;
  for (const Load& load : scene.loads)
    for (const Weight& w : d.points_of(load.place))
      for (int c = 0; c < layout.dim; ++c) r[layout.at(w.point, c)] += w.weight * load.force[c];
  for (std::size_t i = 0; i < layout.points; ++i)
    for (int c = 0; c < layout.dim; ++c) scale[layout.at(i, c)] = 1 / d.mass()[i];
  const auto precondition = [&] {
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (!free[i]) r[i] = 0;
      z[i] = scale[i] * r[i];
    }
  };
  precondition();
  p = z;
  double rz = dot(r, z);
  const double stop = tolerance * tolerance * rz;
  for (int turn = 0; turn < 200000 && rz > stop; ++turn) {
    const std::vector<double> Kp = stiffness(d, p);
    const double alpha = rz / dot(p, Kp);
    for (std::size_t i = 0; i < r.size(); ++i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * Kp[i];
    }
    precondition();
    const double next = dot(r, z);
    for (std::size_t i = 0; i < r.size(); ++i) p[i] = z[i] + next / rz * p[i];
    rz = next;
  }
  return x;
}

}  // namespace femsph::test
