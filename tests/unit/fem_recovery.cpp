// The one rule for reading stress (model/motion/recovery.hpp), on the material points of the elements.

#include <gtest/gtest.h>

#include "fem/fem.hpp"
#include "tests/unit/recovery_cases.hpp"

namespace femsph::test {
namespace {

using fem::Element;
const std::vector<Element> all_of_them{Element::full, Element::sri, Element::one_point, Element::assumed_strain};

std::unique_ptr<Discretization> mesh_of(const Scene& scene, Element element, std::array<int, 3> divisions = {}) {
  fem::Options options;
  options.element = element;
  options.divisions = divisions;
  return fem::discretize(scene, 0, options);
}

/// Corners, edges, faces and inner places of the unit cube (or square).
std::vector<Point> places(int dim) {
  std::vector<Point> out;
  const std::vector<double> at{0, 0.031, 0.5, 0.77, 1};
  for (const double x : at)
    for (const double y : at)
      for (const double z : dim == 3 ? at : std::vector<double>{0}) out.push_back({x, y, z});
  return out;
}

TEST(FemRecovery, LinearFieldsAreExactOnAnyCells) {
  double most = 0;
  for (const int dim : {2, 3})
    for (const Element element : all_of_them)
      for (const double aspect : {1.0, 5.0, 30.0}) {
        const std::array<int, 3> n{6, 5, 4};
        const auto map = [&](const Point& p) { return Point{aspect * p[0] + 0.3 * p[1], p[1] - 0.1 * p[2], 0.7 * p[2] + 0.2 * p[0]}; };
        const Scene scene = recovery_scene(mapped(dim, n, [&](Point p) { return map(dim == 3 ? p : Point{p[0], p[1], 0}); }, 0.25), dim == 2 ? Plane::stress : Plane::none);
        const auto d = mesh_of(scene, element);
        const Recovery rule(d->material_units());
        const auto linear = [&](const Point& x) { return 1 + 2 * x[0] / aspect - 3 * x[1] + (dim == 3 ? 1.5 * x[2] : 0.0); };
        for (const Point& place : places(dim)) {
          const Point p = map(place);
          double sum = 0, value = 0, size = 0;
          for (const Weight& w : rule.weights(p)) sum += w.weight, size += std::abs(w.weight), value += w.weight * linear(d->material_position(w.point));
          EXPECT_NEAR(sum, 1, 1e-12);
          EXPECT_NEAR(value, linear(p), 1e-12);
          most = std::max(most, size);
        }
      }
  EXPECT_LT(most, 6.0);
  RecordProperty("most", std::to_string(most));
  std::printf("largest sum of |w| %g\n", most);
}

double at_hole(Element element, int nr, double& raw) {
  constexpr double outer = 4;
  const double dr = (outer - 1) / nr;
  const int nt = int(std::lround(0.5 * M_PI * 4 / dr));
  const Scene scene = recovery_scene(mapped(2, {nr, nt, 0}, [&](Point p) {
    const double r = 1 + (outer - 1) * p[0], t = 0.5 * M_PI * p[1];
    return Point{p[1] == 1 ? 0 : r * std::cos(t), r * std::sin(t), 0};
  }), Plane::stress);
  const auto d = mesh_of(scene, element);
  const auto given = [&](const Point& x) {
    std::array<std::optional<double>, 3> u{};
    const Point exact = Kirsch::displacement(x);
    if (norm(x) > outer - 1e-9) return decltype(u){exact[0], exact[1], {}};
    if (x[0] < 1e-12) u[0] = 0;
    if (x[1] < 1e-12) u[1] = 0;
    return u;
  };
  const Flat u = static_solution(*d, given, Flat(d->layout().size, 0.0));
  raw = raw_at(*d, u, {0, 1, 0})[0];
  return read_at(*d, Recovery(d->material_units()), u, {0, 1, 0}, Plane::stress).stress[0];
}

TEST(FemRecovery, ConcentrationAtAHole) {
  for (const Element element : {Element::one_point, Element::full})
    for (const int nr : {12, 24, 48}) {
      double raw;
      const double rule = at_hole(element, nr, raw);
      std::printf("hole element %d nr %d raw %.3f rule %.3f\n", int(element), nr, raw, rule);
    }
}

TEST(FemRecovery, WallOfAThickRing) {
  for (const Element element : all_of_them)
    for (const int n : {4, 8, 16, 32}) {
      const Scene scene = recovery_scene(mapped(2, {n, int(std::lround(n * 0.75 * M_PI)), 0}, [&](Point p) {
        const double r = 1 + p[0], t = 0.5 * M_PI * p[1];
        return Point{p[1] == 1 ? 0 : r * std::cos(t), r * std::sin(t), 0};
      }), Plane::strain);
      const auto d = mesh_of(scene, element);
      const auto given = [&](const Point& x) {
        std::array<std::optional<double>, 3> u{};
        if (x[0] < 1e-12) u[0] = 0;
        if (x[1] < 1e-12) u[1] = 0;
        return u;
      };
      const Flat f = traction(*d, [](const Point& x) { return norm(x) < 1 + 1e-9; }, [](const Point& x) { return (1 / norm(x)) * x; });
      const Flat u = static_solution(*d, given, f);
      const Recovery rule(d->material_units());
      double wall[2], l2 = 0, size = 0;
      const auto radial = [&](double r, double angle) {
        const Point p{r * std::cos(angle), r * std::sin(angle), 0};
        const auto s = read_at(*d, rule, u, p, Plane::strain).stress;
        const double c = std::cos(angle), si = std::sin(angle);
        return c * c * s[0] + si * si * s[1] + 2 * c * si * s[3];
      };
      wall[0] = radial(1, 0), wall[1] = radial(1, 0.25 * M_PI);
      for (int i = 0; i <= 40; ++i) {
        const double r = 1 + i / 40.0, e = radial(r, 0) - Lame::radial(r);
        l2 += e * e, size += Lame::radial(r) * Lame::radial(r);
      }
      std::printf("ring element %d n %d wall %.2f %% (mid-arc %.2f), L2 %.2f %%\n", int(element), n, -100 * (wall[0] + 1), -100 * (wall[1] + 1), 100 * std::sqrt(l2 / size));
    }
}

TEST(FemRecovery, SectionOfACantilever) {
  for (const Element element : all_of_them)
    for (const int ny : {2, 4, 8, 16}) {
      const Scene scene = recovery_scene(std::make_shared<Box>(2, Point{0, -0.5, 0}, Point{4, 1, 0}), Plane::stress);
      const auto d = mesh_of(scene, element, {4 * ny, ny, 0});
      const auto given = [&](const Point& x) {
        std::array<std::optional<double>, 3> u{};
        if (x[0] > 1e-12) return u;
        const Point exact = Bending::displacement(x);
        return decltype(u){exact[0], exact[1], {}};
      };
      const Flat f = traction(*d, [](const Point& x) { return x[0] > 4 - 1e-9; }, [](const Point& x) { return Point{0, Bending::xy(x), 0}; });
      const Flat u = static_solution(*d, given, f);
      const Recovery rule(d->material_units());
      double e[4]{}, size[2]{};
      for (int i = 0; i <= 40; ++i) {
        const Point p{2, -0.5 + i / 40.0, 0};
        const auto s = read_at(*d, rule, u, p, Plane::stress).stress, r = raw_at(*d, u, p);
        e[0] += std::pow(r[0] - Bending::xx(p), 2), e[1] += std::pow(s[0] - Bending::xx(p), 2), size[0] += std::pow(Bending::xx(p), 2);
        e[2] += std::pow(r[3] - Bending::xy(p), 2), e[3] += std::pow(s[3] - Bending::xy(p), 2), size[1] += std::pow(Bending::xy(p), 2);
      }
      std::printf("section element %d ny %d sxx raw %.3f rule %.3f %%, sxy raw %.3f rule %.3f %%\n", int(element), ny, 100 * std::sqrt(e[0] / size[0]),
                  100 * std::sqrt(e[1] / size[0]), 100 * std::sqrt(e[2] / size[1]), 100 * std::sqrt(e[3] / size[1]));
    }
}

}  // namespace
}  // namespace femsph::test
