// Nearly incompressible bodies, and elements whose cells are not in line with the axes.
// Cook's membrane (48 wide, 44 high at the clamp, 16 at the free end, raised by 44): converged corner
// displacement
//   plane stress, E 1, nu 1/3, F 1: 25.18 with full Q1 n = 8/16/32/64 at 22.67/24.27/24.84/25.04; plane
//   strain, E 240.565, nu 0.4999, F 100: 8.066.

#include <gtest/gtest.h>

#include "fem_support.hpp"
#include "model/scene/shapes/mesh.hpp"

namespace femsph::test {
namespace {

/// n x n cells on a quadrilateral given by its lexicographic corners.
CellMesh cells_between(int n, int m, const std::array<Point, 4>& corner) {
  CellMesh mesh;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / m;
      Point p{};
      for (int c = 0; c < 2; ++c)
        p[c] = (1 - t) * ((1 - s) * corner[0][c] + s * corner[1][c]) +
               t * ((1 - s) * corner[2][c] + s * corner[3][c]);
      mesh.vertices.push_back(p);
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      mesh.cells.push_back({a, a + 1, a + n + 1, a + n + 2, 0, 0, 0, 0});
    }
  return mesh;
}

double cook(Element element, int n, Plane plane, double young, double poisson, double load) {
  const std::array<Point, 4> corner{Point{0, 0, 0}, Point{48, 44, 0}, Point{0, 44, 0}, Point{48, 60, 0}};
  Scene scene = scene_of(
      std::make_shared<MeshShape>(cells_between(n, n, corner), "cook"), plane, young, poisson);
  scene.supports.push_back({Place{0, {"x-"}, {}, {}}, {true, true, true}});
  scene.loads.push_back({Place{0, {"x+"}, {}, {}}, {0, load, 0}, {}});
  fem::Options options;
  options.element = element;
  const auto d = fem::discretize(scene, 0, options);
  return value_at(*d, static_displacement(*d, scene), {48, 60, 0}, 1);
}

TEST(FemCook, FullElementInPlaneStress) {
  EXPECT_NEAR(cook(Element::full, 8, Plane::stress, 1, 1.0 / 3, 1), 22.67, 0.01);
  EXPECT_NEAR(cook(Element::full, 16, Plane::stress, 1, 1.0 / 3, 1), 24.27, 0.01);
  EXPECT_NEAR(cook(Element::full, 32, Plane::stress, 1, 1.0 / 3, 1), 24.84, 0.01);
}

TEST(FemCook, AssumedStrainsConvergeFromCoarseMeshes) {
  // The cells are skew here, where four-node elements lose accuracy: half of the full element's 10 %
  // at n = 8.
  for (const Element element : {Element::assumed_strain, Element::one_point}) {
    EXPECT_NEAR(cook(element, 8, Plane::stress, 1, 1.0 / 3, 1) / 25.18, 1, 0.05);
    EXPECT_NEAR(cook(element, 32, Plane::stress, 1, 1.0 / 3, 1) / 25.18, 1, 0.01);
  }
}

TEST(FemCook, NearlyIncompressibleLocksFullIntegrationAndReducedShear) {
  EXPECT_LT(cook(Element::full, 8, Plane::strain, 240.565, 0.4999, 100), 0.65 * 8.066);
  EXPECT_LT(cook(Element::sri, 8, Plane::strain, 240.565, 0.4999, 100),
            0.65 * 8.066);  // the shear alone is reduced
  for (const Element element : {Element::assumed_strain, Element::one_point}) {
    EXPECT_NEAR(cook(element, 8, Plane::strain, 240.565, 0.4999, 100) / 8.066, 1, 0.06);
    EXPECT_NEAR(cook(element, 16, Plane::strain, 240.565, 0.4999, 100) / 8.066, 1, 0.03);
    EXPECT_NEAR(cook(element, 32, Plane::strain, 240.565, 0.4999, 100) / 8.066, 1, 0.015);
  }
}

TEST(FemAxes, ElementsDoNotDependOnTheOrientationOfTheBody) {
  // The cantilever turned by 30 degrees, load and tip with it: the deflection is the same. (Cells in line
  // with its axes, so that clamp and load sit on named places: the clamp is given node by node.)
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  const auto turned = [&](double x, double y) { return Point{c * x - s * y, s * x + c * y, 0}; };
  for (const Element element : all_elements) {
    double tips[2];
    for (const bool turn : {false, true}) {
      const auto at = [&](double x, double y) { return turn ? turned(x, y) : Point{x, y, 0}; };
      Scene scene = scene_of(std::make_shared<MeshShape>(
                                 cells_between(20, 2, {at(0, 0), at(1, 0), at(0, 0.1), at(1, 0.1)}), "bar"),
                             Plane::stress, 210e9, 0.3, 0.1);
      for (const double y : {0.0, 0.05, 0.1})
        scene.supports.push_back({Place{0, {}, at(0, y), {}}, {true, true, true}});
      const Point down = at(0, -25e3);
      scene.loads.push_back({Place{0, {}, at(1, 0.1), {}}, down, {}});
      fem::Options options;
      options.element = element;
      const auto d = fem::discretize(scene, 0, options);
      const auto u = static_displacement(*d, scene);
      const Point tip = at(1, 0.05);
      tips[turn] = (value_at(*d, u, tip, 0) * down[0] + value_at(*d, u, tip, 1) * down[1]) / 25e3;
    }
    EXPECT_NEAR(tips[1] / tips[0], 1, 1e-6) << element.word;
  }
}

TEST(FemAxes, EnergyOfHexahedraTurnsWithThem) {
  // Distorted cells under a random displacement, and the same turned by 40 degrees about (1, 2, 3): energies
  // are equal.
  const double angle = 0.7, n = std::sqrt(14.0), a[3] = {1 / n, 2 / n, 3 / n};
  const auto turned = [&](const Point& x) {  // Rodrigues
    const double along = (1 - std::cos(angle)) * (a[0] * x[0] + a[1] * x[1] + a[2] * x[2]);
    Point y;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      y[i] = std::cos(angle) * x[i] + along * a[i] + std::sin(angle) * (a[j] * x[k] - a[k] * x[j]);
    }
    return y;
  };
  fem::Options options;
  options.divisions = {2, 2, 2};
  options.distortion = 0.2;
  const auto box = fem::discretize(box_scene(Plane::none, {1, 0.8, 1.3}, 1.0, 0.3), 0, options);
  CellMesh mesh, turned_mesh;
  mesh.dim = 3;
  for (std::size_t i = 0; i < box->layout().points; ++i) mesh.vertices.push_back(box->position(i));
  for (const auto& cell : box->topology().cells) {
    const auto v = [&](int k) { return static_cast<int>(cell[k]); };
    mesh.cells.push_back({v(0), v(1), v(3), v(2), v(4), v(5), v(7), v(6)});
  }
  turned_mesh = mesh;
  for (Point& p : turned_mesh.vertices) p = turned(p);
  for (const Element element : all_elements) {
    options.element = element;
    const auto energy = [&](const CellMesh& cells, bool turn) {
      const auto d = fem::discretize(
          scene_of(std::make_shared<MeshShape>(cells, "brick"), Plane::none, 1.0, 0.3), 0, options);
      std::vector<double> u(d->layout().size, 0.0);
      for (std::size_t i = 0; i < d->layout().points; ++i) {
        // the same field at the same material point, whatever the numbering: undo the turn of the place first
        Point x = d->position(i);
        if (turn)
          for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
            if (std::hypot(turned_mesh.vertices[k][0] - x[0], turned_mesh.vertices[k][1] - x[1],
                           turned_mesh.vertices[k][2] - x[2]) < 1e-9) {
              x = mesh.vertices[k];
              break;
            }
        Point w{std::sin(3 * x[0] + x[1]), x[2] * x[0], std::cos(x[1] + 2 * x[2])};
        if (turn) w = turned(w);
        for (int c = 0; c < 3; ++c) u[d->layout().at(i, c)] = w[c];
      }
      return d->energies(u.data()).strain + d->energies(u.data()).hourglass;
    };
    options.distortion = 0;
    EXPECT_NEAR(energy(turned_mesh, true) / energy(mesh, false), 1, 1e-12) << element.word;
  }
}

TEST(FemCook, ALayerOfHexahedraHeldFlatIsPlaneStrain) {
  // One cell deep and u_z = 0 everywhere: every element must give the tip of its plane-strain quadrilateral
  // (load per depth alike).
  const std::array<Point, 4> corner{Point{0, 0, 0}, Point{48, 44, 0}, Point{0, 44, 0}, Point{48, 60, 0}};
  const CellMesh flat = cells_between(6, 6, corner);
  CellMesh mesh = flat;
  mesh.dim = 3;
  const int n = static_cast<int>(flat.vertices.size());
  for (const Point& p : flat.vertices) mesh.vertices.push_back({p[0], p[1], 5.0});
  for (auto& cell : mesh.cells)
    for (int a = 0; a < 4; ++a) cell[a + 4] = cell[a] + n;
  for (const Element element : all_elements) {
    Scene scene = scene_of(std::make_shared<MeshShape>(mesh, "layer"), Plane::none, 240.565, 0.4999);
    scene.supports.push_back({Place{0, {"x-"}, {}, {}}, {true, true, true}});
    scene.supports.push_back({Place{0, {}, {}, {}}, {false, false, true}});
    scene.loads.push_back({Place{0, {"x+"}, {}, {}}, {0, 500, 0}, {}});
    fem::Options options;
    options.element = element;
    const auto d = fem::discretize(scene, 0, options);
    const double tip = value_at(*d, static_displacement(*d, scene, 1e-11), {48, 60, 0}, 1);
    EXPECT_NEAR(tip / cook(element, 6, Plane::strain, 240.565, 0.4999, 100), 1, 1e-6) << element.word;
  }
}

}  // namespace
}  // namespace femsph::test
