// The physical stabilization of the one-point cell (fem/elements/one_point.hpp): where it equals other
// elements, where it is exact, that no mode is free, and how a bent cell yields.

#include <gtest/gtest.h>

#include <numbers>

#include "fem_support.hpp"
#include "model/scene/shapes/mesh.hpp"

namespace femsph::test {
namespace {

std::unique_ptr<Discretization> body_of(const Scene& scene, Element element,
                                        std::array<int, 3> divisions = {},
                                        std::optional<double> hourglass = {}, double distortion = 0) {
  fem::Options options;
  options.element = element;
  options.divisions = divisions;
  options.hourglass = hourglass;
  options.distortion = distortion;
  return fem::discretize(scene, 0, options);
}

/// One cell of the given lexicographic corners.
std::shared_ptr<const Shape> cell_of(const std::vector<Point>& corners) {
  CellMesh mesh;
  mesh.dim = corners.size() == 4 ? 2 : 3;
  mesh.vertices = corners;
  mesh.cells.push_back({0, 1, 2, 3, 4, 5, 6, 7});
  if (mesh.dim == 2) mesh.cells[0] = {0, 1, 2, 3, 0, 0, 0, 0};
  return std::make_shared<MeshShape>(mesh, "cell");
}

double energy(const Discretization& d, const std::vector<double>& u) {
  return d.energies(u.data()).strain + d.energies(u.data()).hourglass;
}

TEST(FemStabilization, IsTheAssumedStrainElementOnRectanglesAndBoxes) {
  // Linear fields in place of points: the same integral, (1/3) of the square of a linear strain, whatever the
  // cells' ratio of sides.
  for (const Plane plane : {Plane::stress, Plane::strain, Plane::none})
    for (const double poisson : {0.0, 0.3, 0.4999}) {
      const Scene scene = box_scene(plane, {1.7, 0.4, plane == Plane::none ? 0.9 : 0.0}, 1.0, poisson, 0.3);
      const auto one = body_of(scene, Element::one_point, {3, 2, 2}),
                 assumed = body_of(scene, Element::assumed_strain, {3, 2, 2});
      const auto u = random_field(*one, 1.0), f = stiffness(*one, u), g = stiffness(*assumed, u);
      for (std::size_t i = 0; i < f.size(); ++i)
        ASSERT_NEAR(f[i], g[i], 1e-12 * largest(g)) << static_cast<int>(plane) << " " << poisson;
    }
}

TEST(FemStabilization, AParallelogramBendsExactly) {
  // Pure bending along x: u = k x y, v = -k (x^2 + nu y^2) / 2. The stress is E k y alone, so the energy of a
  // parallelogram of half height b is E k^2 b^2 / 6 of its area, and the one-point cell must hold no less and
  // no more, however skew it is.
  const double b = 0.35, k = 0.01, nu = 0.3;
  for (const double skew : {0.0, 0.2, 0.9}) {
    std::vector<Point> corners;
    for (const double y : {-b, b})
      for (const double x : {-1.0, 1.0}) corners.push_back({x + skew * y / b, y, 0});
    const auto d = body_of(scene_of(cell_of(corners), Plane::stress, 2.0, nu), Element::one_point);
    const auto u = field(*d, [&](const Point& x) {
      return Point{k * x[0] * x[1], -k * (x[0] * x[0] + nu * x[1] * x[1]) / 2, 0};
    });
    const double exact = 2.0 * k * k * b * b / 6 * 4 * b;
    EXPECT_NEAR(energy(*d, u) / exact, 1, 1e-12) << skew;
    EXPECT_NEAR(d->energies(u.data()).hourglass / exact, 1, 1e-12);  // all of it in the linear strain
  }
}

TEST(FemStabilization, ABoxTwistsAndBendsToBothSidesExactly) {
  // Plates of half thickness h (z): spherical bending w = -k (x^2 + y^2) / 2 has E / (1 - nu) k z in both
  // directions, twisting w = t x y the shear -2 mu t z.
  const double a = 1.1, b = 0.7, h = 0.2, k = 0.01, E = 2.0, nu = 0.3, mu = E / (2 * (1 + nu)),
               volume = 8 * a * b * h;
  std::vector<Point> corners;
  for (const double z : {-h, h})
    for (const double y : {-b, b})
      for (const double x : {-a, a}) corners.push_back({x, y, z});
  const auto d = body_of(scene_of(cell_of(corners), Plane::none, E, nu), Element::one_point);
  const auto bent = field(*d, [&](const Point& x) {
    return Point{k * x[0] * x[2], k * x[1] * x[2],
                 -k * (x[0] * x[0] + x[1] * x[1]) / 2 - nu / (1 - nu) * k * x[2] * x[2]};
  });
  EXPECT_NEAR(energy(*d, bent) / (E / (1 - nu) * k * k * h * h / 3 * volume), 1, 1e-12);
  const auto twisted = field(*d, [&](const Point& x) {
    return Point{-k * x[1] * x[2], -k * x[0] * x[2], k * x[0] * x[1]};
  });
  // The hourglass mode that only hexahedra have: u = -k y z, v = -k x z, w = k x y. Shears 2 e_xy = -2 k z;
  // the two others vanish.
  EXPECT_NEAR(energy(*d, twisted) / (0.5 * mu * 4 * k * k * h * h / 3 * volume), 1, 1e-12);
}

/// Sorted eigenvalues of a symmetric matrix, by Jacobi's rotations.
std::vector<double> eigenvalues(std::vector<std::vector<double>> K) {
  const std::size_t n = K.size();
  for (int sweep = 0; sweep < 30; ++sweep)
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (K[p][q] == 0) continue;
        const double theta = (K[q][q] - K[p][p]) / (2 * K[p][q]),
                     t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1 / std::hypot(t, 1.0), s = t * c;
        for (std::size_t i = 0; i < n; ++i) {
          const double x = K[i][p], y = K[i][q];
          K[i][p] = c * x - s * y, K[i][q] = s * x + c * y;
        }
        for (std::size_t i = 0; i < n; ++i) {
          const double x = K[p][i], y = K[q][i];
          K[p][i] = c * x - s * y, K[q][i] = s * x + c * y;
        }
      }
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(K[i][i]);
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> stiffness_eigenvalues(const Discretization& d) {
  const Layout& l = d.layout();
  std::vector<std::size_t> dof;
  for (std::size_t i = 0; i < l.points; ++i)
    for (int c = 0; c < l.dim; ++c) dof.push_back(l.at(i, c));
  std::vector<std::vector<double>> K;
  for (const std::size_t k : dof) {
    std::vector<double> unit(l.size, 0.0);
    unit[k] = 1;
    const auto y = stiffness(d, unit);
    K.emplace_back();
    for (const std::size_t j : dof) K.back().push_back(y[j]);
  }
  return eigenvalues(K);
}

TEST(FemStabilization, AFreeCellHasItsRigidMotionsAndNoOtherFreeMode) {
  // 3 of 8 in the plane, 6 of 24 in space, on a distorted cell; and no mode stiffer than the stiffest of full
  // integration, so the critical step is not less.
  const std::vector<Point> flat{{0, 0, 0}, {1.3, 0.1, 0}, {-0.2, 0.8, 0}, {1.0, 1.1, 0}};
  std::vector<Point> solid = flat;
  for (const Point& p : flat) solid.push_back({1.1 * p[0] + 0.1, 0.9 * p[1], 0.7 + 0.1 * p[0]});
  for (const double poisson : {0.0, 0.3, 0.4999})
    for (const Plane plane : {Plane::stress, Plane::strain, Plane::none}) {
      const Scene scene = scene_of(cell_of(plane == Plane::none ? solid : flat), plane, 1.0, poisson);
      const auto one = stiffness_eigenvalues(*body_of(scene, Element::one_point)),
                 full = stiffness_eigenvalues(*body_of(scene, Element::full));
      const std::size_t rigid = plane == Plane::none ? 6 : 3;
      for (std::size_t k = 0; k < rigid; ++k) EXPECT_NEAR(one[k], 0, 1e-13 * one.back());
      EXPECT_GT(one[rigid], 0.01);  // Young's modulus is 1, the sides about 1
      EXPECT_LE(one.back(), full.back() * (1 + 1e-12));
    }
}

TEST(FemStabilization, TheCoefficientChoosesFlanaganAndBelytschkosControl) {
  // The mode xi eta of a square of side 2, amplitude q along x: 1/2 c M V (sum of (dN/dx)^2) 4 q^2, M =
  // lambda + 2 mu at nu = 0.3, V = 4, the sum 4 (1/16 + 1/16) = 1/2. (8 c M / 2 q^2.) And nothing at all for
  // 0.
  const LinearElastic steel = LinearElastic::make(2.0, 0.3, 7850, Plane::strain);
  const Scene scene = scene_of(
      cell_of({{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}), Plane::strain, 2.0, 0.3);
  const auto energy_of = [&](std::optional<double> coefficient) {
    const auto d = body_of(scene, Element::one_point, {}, coefficient);
    return energy(*d, field(*d, [](const Point& x) { return Point{0.1 * x[0] * x[1], 0, 0}; }));
  };
  EXPECT_NEAR(energy_of(0.05), 0.05 * (steel.lambda + 2 * steel.mu) * 4 * 0.01, 1e-15);
  EXPECT_EQ(energy_of(0.0), 0);
  EXPECT_NEAR(energy_of({}), 4.0 / 6 * 2.0 / (1 - 0.09) * 0.01, 1e-15);  // V/6 E/(1 - nu^2) q^2 / l
}

TEST(FemStabilization, ABentCellYieldsAsAPlasticSection) {
  // u = k x y in a cell 2a x 2b of an ideally plastic material, plane stress: no mean strain; elastic up to
  // k_y = Y / (E b), then M = M_y (3/2 - (k_y/k)^2 / 2), M_y = 2/3 Y b^2 t, carried by the corners' forces: M
  // = 2 b F. The energy is the integral of M by the angle 2 a k.
  const double a = 0.8, b = 0.5, Y = 1e-3, E = 2.0, first = Y / (E * b), moment = 2.0 / 3 * Y * b * b;
  for (const bool large : {false, true}) {
    Scene scene = scene_of(cell_of({{-a, -b, 0}, {a, -b, 0}, {-a, b, 0}, {a, b, 0}}), Plane::stress, E, 0.3);
    scene.materials.at("m").parameters = Plasticity{Y, 0};
    scene.large_motion = large;
    const auto d = body_of(scene, Element::one_point);
    double before = 0, held = 0;
    for (const double x : {0.5, 1.0, 1.5, 3.0, 10.0}) {
      const double k = x * first,
                   tolerance = large ? 1e-4 : 1e-10;  // large: the strain k b is 5e-3, once squared
      const auto bend = [&](double curvature) {
        return field(*d, [&](const Point& p) { return Point{curvature * p[0] * p[1], 0, 0}; });
      };
      const double exact = x <= 1 ? x * moment : moment * (1.5 - 0.5 / (x * x));
      const auto f = force(*d, bend(k));
      for (std::size_t i = 0; i < 4; ++i) {
        const Point p = d->position(i);
        EXPECT_NEAR(-f[d->layout().at(i, 0)] * p[0] * p[1] / (a * b), exact / (2 * b), tolerance * moment / b)
            << x;
      }
      for (int n = 0; n < 1000; ++n) {  // Simpson
        const double h = (k - before) / 1000, at = before + n * h;
        const auto M = [&](double c) {
          return c <= first ? c / first * moment : moment * (1.5 - 0.5 * first * first / (c * c));
        };
        held += h / 6 * (M(at) + 4 * M(at + h / 2) + M(at + h)) * 2 * a;
      }
      before = k;
      EXPECT_NEAR(d->energies(bend(k).data()).hourglass, held, 1e-6 * held) << x;
    }
  }
}

TEST(FemStabilization, FlowSoftensACellAndTheLossIsPlasticWork) {
  // A cell is pulled and bent at once, far beyond yield. Its point flows to p, which leaves the secant's
  // share Y / (Y + 3 mu p) of the elastic stiffness (while its fibres do not yield by bending); and the work
  // of the corners' forces is what the cell holds and has lost, to the first order of the step.
  const double Y = 1e-3, E = 2.0, nu = 0.3;
  Scene scene = scene_of(cell_of({{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}), Plane::stress, E, nu);
  scene.materials.at("m").parameters = Plasticity{Y, 0.1};
  double gap[2];
  for (const int steps : {200, 400}) {
    const auto d = body_of(scene, Element::one_point);
    std::vector<double> u(d->layout().size, 0.0), f(u.size(), 0.0);
    double work = 0;
    for (int n = 1; n <= steps; ++n) {
      const double t = static_cast<double>(n) / steps;
      const auto next = field(*d, [&](const Point& x) {
        return Point{5e-3 * t * x[0] + 3e-4 * t * t * x[0] * x[1], -2e-3 * t * x[1], 0};
      });
      const auto g = force(*d, next);
      for (std::size_t i = 0; i < u.size(); ++i) work -= 0.5 * (f[i] + g[i]) * (next[i] - u[i]);
      u = next, f = g;
    }
    const Energies held = d->energies(u.data());
    const double p = state_of(*d, u).plastic[0], yield = Y + 0.1 * p,
                 ratio = yield / (yield + 3 * E / (2 * (1 + nu)) * p);
    ASSERT_LT(ratio, 0.3);
    EXPECT_NEAR(held.hourglass, ratio * 4.0 / 6 * E * 9e-8, 1e-12 * held.hourglass);
    gap[steps / 400] = std::abs(work - held.strain - held.hourglass - held.plastic) / held.hourglass;
  }
  EXPECT_LT(gap[1], 0.01);
  EXPECT_LT(gap[1], 0.6 * gap[0]);
}

/// Quarter ring of mean radius 20 and thickness 1, clamped at y = 0, 1 N radial in y at its upper end: the
/// deflection there.
double ring(Element element, int around, int over, bool solid, std::optional<double> hourglass = {}) {
  const double young = 1e4;
  CellMesh mesh;
  mesh.dim = solid ? 3 : 2;
  for (int z = 0; z <= solid; ++z)
    for (int i = 0; i <= around; ++i)
      for (int j = 0; j <= over; ++j) {
        const double angle = 0.5 * std::numbers::pi * i / around, r = 20.5 - static_cast<double>(j) / over;
        mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), static_cast<double>(z)});
      }
  const int layer = (around + 1) * (over + 1);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < over; ++j) {
      const int n = i * (over + 1) + j, m = n + over + 1;
      mesh.cells.push_back({n + 1, n, m + 1, m, 0, 0, 0, 0});
      if (solid) mesh.cells.back() = {n + 1, n, m + 1, m, n + 1 + layer, n + layer, m + 1 + layer, m + layer};
    }
  Scene scene = scene_of(
      std::make_shared<MeshShape>(mesh, "ring"), solid ? Plane::none : Plane::stress, young, 0.0);
  scene.supports.push_back({Place{0, {"y-"}, {}, {}}, {true, true, true}});
  scene.loads.push_back({Place{0, {"x-"}, {}, {}}, {0, 1, 0}, {}});
  const auto d = body_of(scene, element, {}, hourglass);
  return value_at(*d, static_displacement(*d, scene, 1e-8), {0, 20, solid ? 0.5 : 0.0}, 1);
}

TEST(FemStabilization, AThinRingOfOneOrTwoCellsBends) {
  // Castigliano, M = F R cos, N = F cos, Q = F sin: pi F R^3 / (4 E I) (1 + I/A R^2 ..), of which I / (A R^2)
  // = 1/4800 for the normal force and 1.2 * 2 / 4800 for the shear (nu = 0); the curvature of the fibres is
  // as small. Together less than 0.1 %.
  const double exact = std::numbers::pi / 4 * 8000 / (1e4 / 12);
  EXPECT_NEAR(ring(Element::one_point, 32, 1, false) / exact, 1, 0.005);
  EXPECT_NEAR(ring(Element::one_point, 64, 2, false) / exact, 1, 0.005);
  EXPECT_NEAR(ring(Element::one_point, 32, 1, true) / exact, 1, 0.005);
  EXPECT_GT(ring(Element::one_point, 32, 1, false, 0.05) / exact, 2);  // with control by a coefficient
  EXPECT_LT(ring(Element::full, 32, 1, false) / exact, 0.9);
}

}  // namespace
}  // namespace femsph::test
