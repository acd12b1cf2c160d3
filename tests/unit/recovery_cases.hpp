#pragma once
// Bodies, exact fields and a quick static solver for what is read of stress: the same for both methods.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "model/numerics/array.hpp"
#include "model/numerics/principal.hpp"
#include "model/numerics/vectors.hpp"
#include "model/results/flow_limit.hpp"
#include "model/results/recovery.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/shapes/box.hpp"
#include "model/scene/shapes/mesh.hpp"

namespace femsph::test {

using Flat = AlignedVector<double>;

inline constexpr double E = 210e9, nu = 0.3;

inline Scene recovery_scene(std::shared_ptr<const Shape> shape, Plane plane,
                            std::optional<Plasticity> plasticity = {}) {
  Scene s;
  s.plane = plane;
  s.materials["m"] = Material{"m", E, nu, 7850.0, plasticity ? LawParameters(*plasticity) : LawParameters()};
  s.bodies.push_back(Body{"body", std::move(shape), 1.0, "m"});
  return s;
}

/// A mesh of (n0 x n1 (x n2)) cells of the unit square or cube, carried by `map`, its inner vertices moved by
/// up to `distortion` of a cell.
inline std::shared_ptr<const Shape> mapped(int dim, std::array<int, 3> n,
                                           const std::function<Point(Point)>& map, double distortion = 0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-distortion, distortion);
  CellMesh mesh;
  mesh.dim = dim;
  if (dim == 2) n[2] = 0;
  const auto at = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        Point p{double(i), double(j), double(k)};
        for (std::size_t a = 0; a < std::size_t(dim); ++a) {
          if (p[a] > 0 && p[a] < n[a]) p[a] += off(random);
          p[a] /= n[a];
        }
        mesh.vertices.push_back(map(p));
      }
  for (int k = 0; k < std::max(n[2], 1); ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 8> cell{};
        for (int v = 0; v < 1 << dim; ++v)
          cell[std::size_t(v)] = at(i + (v & 1), j + (v >> 1 & 1), k + (v >> 2));
        mesh.cells.push_back(cell);
      }
  return std::make_shared<MeshShape>(std::move(mesh), "made by the test");
}

/// Displacements that are given at some points: at each point, for each component, a value or none.
using Given = std::function<std::array<std::optional<double>, 3>(const Point&)>;

/// The flat vector with the given displacements, under the forces: conjugate gradients on stiffness(), scaled
/// by the mass.
inline Flat static_solution(const Discretization& d, const Given& given, const Flat& forces,
                            double tolerance = 1e-10) {
  const Layout& at = d.layout();
  Flat x(at.size, 0.0),
      r = forces, free(at.size, 0.0), scale(at.size, 0.0), z(at.size, 0.0), Kp(at.size, 0.0);
  for (std::size_t i = 0; i < at.points; ++i) {
    const auto values = given(d.position(i));
    for (int c = 0; c < at.dim; ++c) {
      const std::size_t s = at.at(i, c);
      scale[s] = 1 / d.mass()[i];
      if (values[std::size_t(c)])
        x[s] = *values[std::size_t(c)];
      else
        free[s] = 1;
    }
  }
  d.stiffness(x.data(), Kp.data());
  double rz = 0;
  const auto precondition = [&] {
    double sum = 0;
    for (std::size_t s = 0; s < at.size; ++s) r[s] *= free[s], z[s] = scale[s] * r[s], sum += r[s] * z[s];
    return sum;
  };
  for (std::size_t s = 0; s < at.size; ++s) r[s] -= Kp[s];
  rz = precondition();
  Flat p = z;
  const double stop = tolerance * tolerance * rz;
  for (int turn = 0; turn < 100000 && rz > stop; ++turn) {
    d.stiffness(p.data(), Kp.data());
    double pKp = 0;
    for (std::size_t s = 0; s < at.size; ++s) pKp += p[s] * Kp[s] * free[s];
    for (std::size_t s = 0; s < at.size; ++s) x[s] += rz / pKp * p[s], r[s] -= rz / pKp * Kp[s];
    const double next = precondition();
    for (std::size_t s = 0; s < at.size; ++s) p[s] = z[s] + next / rz * p[s];
    rz = next;
  }
  return x;
}

/// Forces of a traction on some of the boundary: on each facet whose points all satisfy `on`, integrated by
/// Gauss with the hat functions (plane bodies).
inline Flat traction(const Discretization& d, const std::function<bool(const Point&)>& on,
                     const std::function<Point(const Point&)>& t) {
  const Layout& at = d.layout();
  Flat f(at.size, 0.0);
  for (const Facet& facet : d.boundary()) {
    const std::size_t i = facet.points[0], j = facet.points[1];
    const Point a = d.position(i), b = d.position(j);
    if (!on(a) || !on(b)) continue;
    for (const auto& [s, w] : {std::pair{0.5 - std::sqrt(0.15), 5.0 / 18}, std::pair{0.5, 8.0 / 18},
                               std::pair{0.5 + std::sqrt(0.15), 5.0 / 18}}) {
      const Point here = t(a + s * (b - a));
      for (int c = 0; c < 2; ++c) {
        f[at.at(i, c)] += (1 - s) * w * norm(b - a) * here[std::size_t(c)];
        f[at.at(j, c)] += s * w * norm(b - a) * here[std::size_t(c)];
      }
    }
  }
  return f;
}

inline Flat flat_field(const Discretization& d, const std::function<Point(const Point&)>& u) {
  Flat x(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i) {
    const Point v = u(d.position(i));
    for (int c = 0; c < d.layout().dim; ++c) x[d.layout().at(i, c)] = v[std::size_t(c)];
  }
  return x;
}

/// What is read at p by the rule.
inline Recovered read_at(const Discretization& d, const Recovery& rule, const Flat& u, const Point& p,
                         Plane plane) {
  const std::vector<Weight> weights = rule.weights(p);
  std::vector<std::size_t> points;
  for (const Weight& w : weights) points.push_back(w.point);
  MaterialState state;
  d.material_state(u.data(), points, state);
  return recovered(weights, state, plane);
}
/// And as the discretization interpolates.
inline std::array<double, 6> raw_at(const Discretization& d, const Flat& u, const Point& p) {
  const std::vector<Weight> weights = d.material_interpolation(p);
  std::vector<std::size_t> points;
  for (const Weight& w : weights) points.push_back(w.point);
  MaterialState state;
  d.material_state(u.data(), points, state);
  std::array<double, 6> s{};
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t c = 0; c < 6; ++c) s[c] += weights[k].weight * state.stress[k][c];
  return s;
}

/// The plate with a hole of radius 1 under a tension of 1 along x (Kirsch 1898; plane stress).
struct Kirsch {
  static Point displacement(const Point& x) {
    const double r = norm(x), t = std::atan2(x[1], x[0]), k = (3 - nu) / (1 + nu), mu = E / (2 * (1 + nu)),
                 r3 = r * r * r;
    return {(r * (k + 1) * std::cos(t) + 2 / r * ((1 + k) * std::cos(t) + std::cos(3 * t)) -
             2 / r3 * std::cos(3 * t)) /
                (8 * mu),
            (r * (k - 3) * std::sin(t) + 2 / r * ((1 - k) * std::sin(t) + std::sin(3 * t)) -
             2 / r3 * std::sin(3 * t)) /
                (8 * mu),
            0};
  }
};

/// Lame's thick ring, 1 within 2, under a pressure of 1 inside; plane strain.
struct Lame {
  static constexpr double a = 1, b = 2;
  static double radial(double r) { return a * a / (b * b - a * a) * (1 - b * b / (r * r)); }
  static double hoop(double r) { return a * a / (b * b - a * a) * (1 + b * b / (r * r)); }
};

/// A beam of height 1 and length 4 from x = 0 under a shear force of 1 downwards at its end (Timoshenko &
/// Goodier, Theory of Elasticity, 21), y from its axis.
struct Bending {
  static constexpr double L = 4, I = 1.0 / 12;
  static double xx(const Point& p) { return (L - p[0]) * p[1] / I; }
  static double xy(const Point& p) { return -(0.25 - p[1] * p[1]) / (2 * I); }
  static Point displacement(const Point& p) {
    const double x = p[0], y = p[1], mu = E / (2 * (1 + nu)), rest = -1 / (8 * I * mu);
    return {
        (L * x - 0.5 * x * x) * y / (E * I) + (nu / (6 * E * I) - 1 / (6 * I * mu)) * -y * y * y,
        -nu * (L - x) * y * y / (2 * E * I) - L * x * x / (2 * E * I) + x * x * x / (6 * E * I) + rest * x,
        0};
  }
};

inline Scene cantilever_scene() {
  return recovery_scene(std::make_shared<Box>(2, Point{0, -0.5, 0}, Point{4, 1, 0}), Plane::stress);
}

/// Errors in percent of the section in the middle of the cantilever, L2, by the rule and raw.
struct SectionErrors {
  double xx, xy, raw_xx, raw_xy;
};
inline SectionErrors section_of(const Discretization& d) {
  const auto given = [&](const Point& x) {
    std::array<std::optional<double>, 3> u{};
    if (x[0] > 1e-12) return u;
    const Point exact = Bending::displacement(x);
    return decltype(u){exact[0], exact[1], {}};
  };
  const Flat f = traction(
      d, [](const Point& x) { return x[0] > 4 - 1e-9; },
      [](const Point& x) {
        return Point{0, Bending::xy(x), 0};
      });
  const Flat u = static_solution(d, given, f);
  const Recovery rule(d.material_units());
  double e[4]{}, size[2]{};
  for (int i = 0; i <= 40; ++i) {
    const Point p{2, -0.5 + i / 40.0, 0};
    const auto s = read_at(d, rule, u, p, Plane::stress).stress, r = raw_at(d, u, p);
    e[0] += std::pow(s[0] - Bending::xx(p), 2), e[1] += std::pow(s[3] - Bending::xy(p), 2);
    e[2] += std::pow(r[0] - Bending::xx(p), 2), e[3] += std::pow(r[3] - Bending::xy(p), 2);
    size[0] += std::pow(Bending::xx(p), 2), size[1] += std::pow(Bending::xy(p), 2);
  }
  const auto percent = [&](int k) { return 100 * std::sqrt(e[k] / size[k % 2]); };
  return {percent(0), percent(1), percent(2), percent(3)};
}

/// Lame's ring, a quarter of n x m cells, or in space a slice of it (n x m x 2) held between planes.
inline std::shared_ptr<const Shape> quarter_ring(int dim, int n, double distortion = 0) {
  return mapped(
      dim, {n, int(std::lround(n * 0.75 * M_PI)), 2},
      [&](Point p) {
        const double r = 1 + p[0], t = 0.5 * M_PI * p[1];
        return Point{p[1] == 1 ? 0 : r * std::cos(t), r * std::sin(t), p[2] * 2 / n};
      },
      distortion);
}
struct WallErrors {
  double wall, mid_arc,
      l2;  ///< radial stress at r = 1 on a straight side and at 45 degrees; L2 along that radius; percent
};
inline WallErrors wall_of(const Discretization& d) {
  const int dim = d.layout().dim;
  const auto given = [&](const Point& x) {
    std::array<std::optional<double>, 3> u{};
    if (x[0] < 1e-12) u[0] = 0;
    if (x[1] < 1e-12) u[1] = 0;
    if (dim == 3) u[2] = 0;  // plane strain
    return u;
  };
  Flat f(d.layout().size, 0.0);
  if (dim == 2)
    f = traction(
        d, [](const Point& x) { return norm(x) < 1 + 1e-9; },
        [](const Point& x) { return (1 / norm(x)) * x; });
  else
    for (const Facet& facet : d.boundary()) {
      Point x[4];
      bool on = true;
      for (std::size_t k = 0; k < 4; ++k)
        x[k] = d.position(facet.points[k]), on = on && std::hypot(x[k][0], x[k][1]) < 1 + 1e-9;
      const Point area = 0.5 * cross(x[2] - x[0], x[3] - x[1]);
      for (std::size_t k = 0; on && k < 4; ++k)
        for (int c = 0; c < 3; ++c) f[d.layout().at(facet.points[k], c)] -= 0.25 * area[std::size_t(c)];
    }
  const Flat u = static_solution(d, given, f);
  const Recovery rule(d.material_units());
  const auto radial = [&](double r, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto stress = read_at(d, rule, u, {r * c, r * s, 0}, dim == 2 ? Plane::strain : Plane::none).stress;
    return c * c * stress[0] + s * s * stress[1] + 2 * c * s * stress[3];
  };
  double l2 = 0, size = 0;
  for (int i = 0; i <= 20; ++i) {
    const double r = 1 + i / 20.0;
    l2 += std::pow(radial(r, 0.25 * M_PI) - Lame::radial(r), 2), size += std::pow(Lame::radial(r), 2);
  }
  return {-100 * (radial(1, 0) + 1), -100 * (radial(1, 0.25 * M_PI) + 1), 100 * std::sqrt(l2 / size)};
}

/// A beam of height 1 bent without shear, fibres in the state of the law at their strain: k x y along x,
/// plane stress; ideally plastic, the core elastic up to 0.3 of the height from the axis. What is read over
/// the height against the law at the exact strain.
struct PlasticErrors {
  double most, raw_most, l2, raw_l2;  ///< largest von Mises stress over the yield stress at the plastic
                                      ///< strain that is read there (raw: at none); error of xx in percent
};
inline Scene plastic_scene(double hardening = 0) {
  Plasticity p;
  p.yield = 1e-3 * E;
  p.hardening = hardening;
  return recovery_scene(std::make_shared<Box>(2, Point{0, -0.5, 0}, Point{3, 1, 0}), Plane::stress, p);
}
inline PlasticErrors plastic_section_of(Discretization& d, double hardening = 0) {
  const double Y = 1e-3 * E, curvature = Y / E / 0.3;
  const int steps = 10;
  Flat u(d.layout().size, 0.0), f(d.layout().size, 0.0), v(d.layout().size, 0.0);
  for (int n = 1; n <= steps; ++n) {
    const double k = curvature * n / steps;
    u = flat_field(d, [&](const Point& x) {
      return Point{
          k * (x[0] - 1.5) * x[1], -0.5 * k * (x[0] - 1.5) * (x[0] - 1.5) - 0.5 * nu * k * x[1] * x[1], 0};
    });
    d.internal_force(u.data(), v.data(), 0, f.data(), nullptr);
  }
  const Recovery rule(d.material_units());
  PlasticErrors out{};
  double e = 0, r = 0, size = 0;
  for (int i = 0; i <= 40; ++i) {
    const Point p{1.5, -0.5 + i / 40.0, 0};
    const Recovered here = read_at(d, rule, u, p, Plane::stress);
    const auto s = here.stress, raw = raw_at(d, u, p);
    Plastic law{LinearElastic::make(E, nu, 7850.0, Plane::stress),
                Plasticity{Y, hardening, TensionRule::none, 0, Integration::return_mapping, {}}, 0};
    Symmetric<double, 2> stress{}, by{curvature * p[1] / steps, -nu * curvature * p[1] / steps, 0};
    double history[4]{};
    for (int n = 0; n < steps; ++n) law.update<double, 2>(by, stress, history);
    e += std::pow(s[0] - stress[0], 2), r += std::pow(raw[0] - stress[0], 2), size += stress[0] * stress[0];
    out.most = std::max(out.most, von_mises(s) / (Y + hardening * here.plastic)),
    out.raw_most = std::max(out.raw_most, von_mises(raw) / Y);
  }
  out.l2 = 100 * std::sqrt(e / size), out.raw_l2 = 100 * std::sqrt(r / size);
  return out;
}

/// A square bar in space, 1 x 1 in section and 3 long, bent about z: its ends moved as St Venant has them,
/// its sides free. L2 of xx along an edge's line over the height, and the largest of all six components
/// anywhere on the section, in percent of the largest stress.
struct SpaceBending {
  double xx, any;
};
inline SpaceBending bending_in_space(const Discretization& d) {
  const auto exact = [](const Point& p) {
    const double x = p[0] - 1.5, y = p[1] - 0.5, z = p[2] - 0.5;
    return Point{x * y, -0.5 * (x * x + nu * (y * y - z * z)), -nu * y * z};
  };
  const auto given = [&](const Point& p) {
    std::array<std::optional<double>, 3> u{};
    if (p[0] > 1e-9 && p[0] < 3 - 1e-9) return u;
    const Point at = exact(p);
    return decltype(u){at[0], at[1], at[2]};
  };
  const Flat u = static_solution(d, given, Flat(d.layout().size, 0.0), 1e-8);
  const Recovery rule(d.material_units());
  SpaceBending out{};
  double e = 0, size = 0;
  for (int i = 0; i <= 10; ++i)
    for (const double z : {0.0, 0.3, 1.0}) {
      const Point p{1.55, i / 10.0, z};
      auto s = read_at(d, rule, u, p, Plane::none).stress;
      s[0] -= E * (p[1] - 0.5);
      if (z == 0) e += s[0] * s[0], size += std::pow(E * (p[1] - 0.5), 2);
      for (const double c : s) out.any = std::max(out.any, 100 * std::abs(c) / (0.5 * E));
    }
  out.xx = 100 * std::sqrt(e / size);
  return out;
}
inline std::shared_ptr<const Shape> square_bar(int n, double distortion) {
  return mapped(
      3, {3 * n, n, n},
      [](Point p) {
        return Point{3 * p[0], p[1], p[2]};
      },
      distortion);
}

/// Laws whose bounds differ.
inline std::vector<std::pair<const char*, Plasticity>> plastic_laws() {
  Plasticity metal, sign, principal, none, hot;
  metal.yield = 1e-3 * E, metal.hardening = 0.05 * E;
  sign.yield = principal.yield = 1e-3 * E;
  sign.tension = TensionRule::sign, principal.tension = TensionRule::principal;
  sign.tensile_strength = principal.tensile_strength = 2e-4 * E;
  none = metal, none.integration = Integration::tangent;
  hot.yield = 1e-3 * E;
  hot.johnson_cook = JohnsonCook{2e-3 * E, 0.5, 0.05, 1.0, 1, 0, 0, 0, 0};
  return {{"metal", metal}, {"sign", sign}, {"principal", principal}, {"none", none}, {"Johnson-Cook", hot}};
}

/// Drives a body far beyond yield, in a way that no two points share, and compares the stress of its points
/// with what they say they can bear: none lies above, and where the law has a bound, some lie on it.
inline void expect_bounds(Discretization& d, const Plasticity& law, double size) {
  Flat u(d.layout().size, 0.0), v(d.layout().size, 0.0), f(d.layout().size, 0.0);
  for (int n = 1; n <= 20; ++n) {
    const double s = size * n / 20;
    u = flat_field(d, [&](const Point& x) {
      return Point{
          s * (x[0] * x[1] - 0.5 * x[0] * x[0]), s * (0.3 * x[1] * x[1] - x[0]), s * x[2] * (x[0] - x[1])};
    });
    d.internal_force(u.data(), v.data(), 1e-3, f.data(), nullptr);
  }
  std::vector<std::size_t> all(d.material_points());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  MaterialState state;
  d.material_state(u.data(), all, state);
  ASSERT_EQ(state.flow_stress.size(), all.size());
  EXPECT_EQ(state.tensile_flow_stress.empty(), law.tension != TensionRule::sign);
  EXPECT_EQ(state.tensile_strength.empty(), law.tension != TensionRule::principal);
  double nearest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& s = state.stress[i];
    const bool tension = s[0] + s[1] + s[2] > 0 && !state.tensile_flow_stress.empty();
    const double share = von_mises(s) / (tension ? state.tensile_flow_stress[i] : state.flow_stress[i]);
    EXPECT_LT(share, 1 + 1e-11);
    nearest = std::max(nearest, share);
    if (state.tensile_strength.empty()) continue;
    const double cut = principal_values(s)[0] / state.tensile_strength[i];
    EXPECT_LT(cut, 1 + 1e-11);
    nearest = std::max(nearest, cut);
  }
  if (law.integration == Integration::return_mapping)
    EXPECT_NEAR(nearest, 1, 1e-11);
  else
    EXPECT_EQ(nearest, 0);
}

}  // namespace femsph::test
