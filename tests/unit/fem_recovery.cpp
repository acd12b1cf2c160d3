// The one rule for reading stress (model/results/recovery.hpp), on the material points of the elements.

#include <gtest/gtest.h>

#include <map>

#include "fem_support.hpp"
#include "model/scene/shapes/box.hpp"
#include "tests/unit/recovery_cases.hpp"

namespace femsph::test {
namespace {

const std::vector<Element>& all_of_them = all_elements;

std::unique_ptr<Discretization> mesh_of(const Scene& scene, Element element,
                                        std::array<int, 3> divisions = {}) {
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
  for (const int dim : {2, 3}) {
    double most = 0;
    for (const Element element : all_of_them)
      for (const double aspect : {1.0, 5.0, 30.0}) {
        const std::array<int, 3> n{6, 5, 4};
        const auto map = [&](const Point& p) {
          return Point{aspect * p[0] + 0.3 * p[1], p[1] - 0.1 * p[2], 0.7 * p[2] + 0.2 * p[0]};
        };
        const Scene scene = recovery_scene(
            mapped(
                dim, n,
                [&](Point p) {
                  return map(dim == 3 ? p : Point{p[0], p[1], 0});
                },
                0.25),
            dim == 2 ? Plane::stress : Plane::none);
        const auto d = mesh_of(scene, element);
        const Recovery rule(d->material_units());
        const auto linear = [&](const Point& x) {
          return 1 + 2 * x[0] / aspect - 3 * x[1] + (dim == 3 ? 1.5 * x[2] : 0.0);
        };
        for (const Point& place : places(dim)) {
          const Point p = map(place);
          double sum = 0, value = 0, size = 0;
          for (const Weight& w : rule.weights(p))
            sum += w.weight, size += std::abs(w.weight),
                value += w.weight * linear(d->material_position(w.point));
          EXPECT_NEAR(sum, 1, 1e-12);
          EXPECT_NEAR(value, linear(p), 1e-12);
          most = std::max(most, size);
        }
      }
    EXPECT_LT(most, dim == 2 ? 6.0 : 9.0);  // at corners, which extrapolate along every axis: errors of the
                                            // points may grow so many times at most
  }
}

/// On cells four times as long along the radius as across.
double at_hole(Element element, int nr, double& raw) {
  constexpr double outer = 4;
  const double dr = (outer - 1) / nr;
  const int nt = int(std::lround(0.5 * M_PI * 4 / dr));
  const Scene scene = recovery_scene(
      mapped(2, {nr, nt, 0},
             [&](Point p) {
               const double r = 1 + (outer - 1) * p[0], t = 0.5 * M_PI * p[1];
               return Point{p[1] == 1 ? 0 : r * std::cos(t), r * std::sin(t), 0};
             }),
      Plane::stress);
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

/// Exactly 3. The raw reading of one point a cell, whose radius is the shortest edge, sees the first cell
/// alone: 1.6 for 3.
TEST(FemRecovery, ConcentrationAtAHole) {
  for (const Element element : {Element::one_point, Element::full})
    for (const auto& [nr, percent] : {std::pair{12, 6.0}, std::pair{24, 2.0}, std::pair{48, 0.5}}) {
      double raw;
      EXPECT_NEAR(at_hole(element, nr, raw), 3, 3 * percent / 100) << element.word;
      if (element == Element::one_point && nr == 12) {
        EXPECT_LT(raw, 2);
      }
    }
}

/// Exactly -1. Second order at the wall; on cells out of shape, whose stress has lost the mesh's symmetry and
/// with it an order, near all the same.
TEST(FemRecovery, WallOfAThickRing) {
  for (const Element element : all_of_them) {
    const auto wall = [&](int n, double distortion) {
      return wall_of(*mesh_of(recovery_scene(quarter_ring(2, n, distortion), Plane::strain), element));
    };
    const WallErrors coarse = wall(8, 0), fine = wall(16, 0);
    EXPECT_LT(std::abs(coarse.wall), 6.5);
    EXPECT_LT(std::abs(coarse.mid_arc), 6.5);
    EXPECT_LT(std::abs(fine.wall), 2);
    EXPECT_LT(std::abs(fine.mid_arc), 2);
    EXPECT_GT(std::log2(coarse.mid_arc / fine.mid_arc), 1.7);
    EXPECT_GT(std::log2(coarse.l2 / fine.l2), 1.7);
    for (const int n : {16, 32}) {
      const WallErrors rough = wall(n, 0.2);
      EXPECT_LT(std::abs(rough.wall), 2);
      EXPECT_LT(std::abs(rough.mid_arc), 2);
    }
  }
}

/// The same in space, read on an edge of the slice and at one of its corners.
TEST(FemRecovery, WallOfATubeInSpace) {
  for (const Element element : all_of_them) {
    const auto wall = [&](int n) {
      return wall_of(*mesh_of(recovery_scene(quarter_ring(3, n), Plane::none), element));
    };
    const WallErrors coarse = wall(8), fine = wall(16);
    EXPECT_LT(std::abs(coarse.wall), 6.5);
    EXPECT_LT(std::abs(coarse.mid_arc), 6.5);
    EXPECT_LT(std::abs(fine.wall), 2);
    EXPECT_LT(std::abs(fine.mid_arc), 2);
    EXPECT_GT(std::log2(coarse.l2 / fine.l2), 1.7);
  }
}

TEST(FemRecovery, SectionOfACantilever) {
  for (const Element element : all_of_them) {
    const auto section = [&](int ny) {
      return section_of(*mesh_of(cantilever_scene(), element, {4 * ny, ny, 0}));
    };
    const SectionErrors coarse = section(4), fine = section(16);
    EXPECT_GT(0.5 * std::log2(coarse.xy / fine.xy), 1.8);
    EXPECT_LT(0.5 * std::log2(coarse.raw_xy / fine.raw_xy),
              element == Element::one_point ? 2.0 : 1.1);  // what the rule is for
    if (element == Element::full || element == Element::sri)
      EXPECT_GT(0.5 * std::log2(coarse.xx / fine.xx), 1.9);
    else
      EXPECT_LT(fine.xx, 0.01);  // these bend exactly
  }
}

/// Ideally plastic, and hardening: nothing that is read lies above the yield curve, not by round-off.
TEST(FemRecovery, PlasticBendingStaysOnTheYieldCurve) {
  for (const Element element : all_of_them) {
    std::map<int, PlasticErrors> e;
    for (const int ny : {2, 4, 8, 16}) {
      e[ny] = plastic_section_of(*mesh_of(plastic_scene(), element, {3 * ny, ny, 0}));
      EXPECT_LT(e[ny].most, 1 + 1e-12);
      EXPECT_GT(e[ny].most, 0.999);
      EXPECT_LT(
          plastic_section_of(*mesh_of(plastic_scene(0.02 * E), element, {3 * ny, ny, 0}), 0.02 * E).most,
          1 + 1e-12);
    }
    EXPECT_GT(e[2].raw_most, 1.2);
    EXPECT_LT(e[8].l2, 2);
    EXPECT_LT(e[16].l2, 1);
  }
}

/// Where a clamped side meets a free one stress grows as r^(lambda - 1), lambda = 0.76 (Williams 1952): 1.18
/// times with every halving, and no faster.
TEST(FemRecovery, ClampedCornerGrowsAsWilliamsSays) {
  for (const Element element : all_of_them) {
    const auto corner = [&](int ny) {
      const auto d = mesh_of(
          recovery_scene(std::make_shared<Box>(2, Point{0, -0.5, 0}, Point{2, 1, 0}), Plane::stress), element,
          {2 * ny, ny, 0});
      const auto given = [&](const Point& x) {
        std::array<std::optional<double>, 3> u{};
        if (x[0] < 1e-12) u[0] = u[1] = 0;
        return u;
      };
      const Flat u = static_solution(
          *d, given,
          traction(
              *d, [](const Point& x) { return x[0] > 2 - 1e-9; },
              [](const Point&) {
                return Point{1, 0, 0};
              }));
      return read_at(*d, Recovery(d->material_units()), u, {0, 0.5, 0}, Plane::stress).stress[0];
    };
    EXPECT_NEAR(corner(32) / corner(16), std::pow(2, 1 - 0.76), 0.01);
  }
}

/// u = sin(k . x) at the nodes, as a wave has it, on cells out of shape by 20 %: on the surface and inside.
TEST(FemRecovery, SmoothWave) {
  for (const Element element : all_of_them) {
    std::map<int, std::array<double, 2>> errors;
    for (const int ny : {4, 8, 16}) {
      const Scene scene = recovery_scene(
          mapped(
              2, {4 * ny, ny, 0},
              [](Point p) {
                return Point{4 * p[0], p[1], 0};
              },
              0.2),
          Plane::stress);
      const auto d = mesh_of(scene, element);
      const auto phase = [](const Point& x) { return 2 * x[0] + x[1] + 0.3; };
      const Flat u = flat_field(*d, [&](const Point& x) {
        return Point{std::sin(phase(x)), 0.5 * std::sin(phase(x)), 0};
      });
      const Recovery rule(d->material_units());
      for (const int inside : {0, 1}) {
        double e = 0, raw = 0, size = 0;
        for (int i = 0; i <= 40; ++i) {
          const Point p{i / 10.0, inside ? 0.47 : 0.0, 0};
          const double exact = E / (1 - nu * nu) * (2 + nu * 0.5) * std::cos(phase(p));
          e += std::pow(read_at(*d, rule, u, p, Plane::stress).stress[0] - exact, 2),
              raw += std::pow(raw_at(*d, u, p)[0] - exact, 2), size += exact * exact;
        }
        EXPECT_LT(e, raw);
        errors[ny][std::size_t(inside)] = 100 * std::sqrt(e / size);
      }
    }
    EXPECT_LT(errors[4][0], 6);
    EXPECT_LT(errors[8][0], 1.5);
    EXPECT_LT(errors[16][0], 0.8);
    EXPECT_LT(errors[16][1], 0.5);
  }
}

/// Uniaxial stress that varies over the height alone, read on edges, faces and inside. Elements that bend
/// have it exactly on bricks.
TEST(FemRecovery, BendingInSpace) {
  for (const Element element : all_of_them) {
    const auto bending = [&](int n, double distortion) {
      return bending_in_space(*mesh_of(recovery_scene(square_bar(n, distortion), Plane::none), element));
    };
    const SpaceBending coarse = bending(4, 0), fine = bending(8, 0), rough = bending(8, 0.2);
    EXPECT_LT(coarse.xx, 0.5);
    EXPECT_LT(fine.xx, 0.2);
    EXPECT_LT(coarse.any, 1.5);
    EXPECT_LT(fine.any, 0.75);
    EXPECT_LT(rough.xx, 1.2);
    EXPECT_LT(rough.any, 2.5);
    if (element == Element::one_point || element == Element::assumed_strain) {
      EXPECT_LT(coarse.any, 1e-4);
    }
  }
}

/// Also in large motion, where laws speak of Kirchhoff's stress and the state of Cauchy's.
TEST(FemRecovery, PointsKeepToTheirBounds) {
  for (const int dim : {2, 3})
    for (const bool large : {false, true})
      for (const auto& [name, law] : plastic_laws()) {
        SCOPED_TRACE(std::string(name) + (large ? " large" : " small"));
        Scene scene = recovery_scene(std::make_shared<Box>(dim, Point{}, Point{1, 1, dim == 3 ? 1.0 : 0.0}),
                                     dim == 2 ? Plane::strain : Plane::none, law);
        scene.large_motion = large;
        const auto d = mesh_of(scene, Element::assumed_strain, {4, 4, dim == 3 ? 4 : 0});
        expect_bounds(*d, law, large ? 0.2 : 0.02);
      }
}

}  // namespace
}  // namespace femsph::test
