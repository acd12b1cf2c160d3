#pragma once
// Bodies, a quick static solver, and what is read of stress at a point: the same for both methods.

#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "model/numerics/array.hpp"
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

}  // namespace femsph::test
