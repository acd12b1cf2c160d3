#pragma once
// Elastic bodies with a known stress, and how far off it is read: the same for both methods.

#include "recovery_support.hpp"

namespace femsph::test {

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

/// u = sin(k . x), as a wave has it, on a body 4 x 1 in plane stress.
struct WaveErrors {
  double percent, of_raw;  ///< L2 along the body, of xx; its square over that of the raw reading
};
/// Read along the lower surface, or `inside` along y = 0.47.
inline WaveErrors wave_of(const Discretization& d, bool inside) {
  const auto phase = [](const Point& x) { return 2 * x[0] + x[1] + 0.3; };
  const Flat u = flat_field(d, [&](const Point& x) {
    return Point{std::sin(phase(x)), 0.5 * std::sin(phase(x)), 0};
  });
  const Recovery rule(d.material_units());
  double e = 0, raw = 0, size = 0;
  for (int i = 0; i <= 40; ++i) {
    const Point p{i / 10.0, inside ? 0.47 : 0.0, 0};
    const double exact = E / (1 - nu * nu) * (2 + nu * 0.5) * std::cos(phase(p));
    e += std::pow(read_at(d, rule, u, p, Plane::stress).stress[0] - exact, 2);
    raw += std::pow(raw_at(d, u, p)[0] - exact, 2), size += exact * exact;
  }
  return {100 * std::sqrt(e / size), e / raw};
}

/// A body 2 x 1 in plane stress, y from its axis, to be clamped on x = 0 and pulled at x = 2.
inline Scene pulled_scene() {
  return recovery_scene(std::make_shared<Box>(2, Point{0, -0.5, 0}, Point{2, 1, 0}), Plane::stress);
}
/// Its stress xx at p under a traction of 1.
inline double pulled_stress(const Discretization& d, const Point& p) {
  const auto given = [&](const Point& x) {
    std::array<std::optional<double>, 3> u{};
    if (x[0] < 1e-12) u[0] = u[1] = 0;
    return u;
  };
  const Flat u = static_solution(
      d, given,
      traction(
          d, [](const Point& x) { return x[0] > 2 - 1e-9; },
          [](const Point&) {
            return Point{1, 0, 0};
          }));
  return read_at(d, Recovery(d.material_units()), u, p, Plane::stress).stress[0];
}

}  // namespace femsph::test
