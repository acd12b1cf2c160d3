// A body with symmetry planes is one half (or a quarter) of the whole: for a displacement field of the half
// and its mirror image in the whole, accelerations agree in every particle and the energies are a half (a
// quarter), to round-off.

#include <gtest/gtest.h>

#include <map>

#include "model/motion/bodies/critical_step.hpp"
#include "model/scene/shapes/box.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

struct HalfCase {
  const char* name;
  Plane plane;
  std::vector<const char*> planes;
  sph::Options options;
};

std::vector<HalfCase> half_cases() {
  using sph::Boundary, sph::MassRule;
  std::vector<HalfCase> out;
  const std::vector<std::pair<const char*, sph::Options>> options{
      {"share", classic(0.01, MassRule::share)},
      {"full", classic(0.01, MassRule::full)},
      {"trapezoid", classic(0.01, MassRule::trapezoid)},
      {"weight", classic(0.01, MassRule::share, Boundary::weight)},
      {"corrected", corrected(0.01)},
      {"corrected, h = 2 d", corrected(0.01, 2.0)}};
  for (const auto& [name, o] : options)
    for (bool lists : {false, true}) {
      sph::Options option = o;
      option.force_lists = lists;
      if (lists && o.formulation == "classic") option.viscosity = {3, 3, 1};
      out.push_back({name, Plane::stress, {"x-"}, option});
      out.push_back({name, Plane::strain, {"x+", "y-"}, option});
      if (o.smoothing == 1) out.push_back({name, Plane::none, {"x-", "z-"}, option});
    }
  return out;
}

/// The half [0, a] and the whole, mirrored in its planes.
struct Pair {
  Scene half, whole;
  std::vector<std::pair<int, double>> planes;  ///< axis, position

  Pair(const HalfCase& c, bool large) {
    const int dim = c.plane == Plane::none ? 3 : 2;
    const Point size = dim == 3 ? Point{0.07, 0.05, 0.06} : Point{0.13, 0.11, 0};
    half = whole = box_scene(c.plane, size, large);
    Point lower{}, all = size;
    half.bodies[0].shape = std::make_shared<Box>(dim, lower, size);
    for (const char* side : c.planes) {
      const int axis = side[0] - 'x';
      half.symmetries.push_back({Place{0, {side}, {}, {}, {}}});
      planes.emplace_back(axis, side[1] == '+' ? size[axis] : 0.0);
      if (side[1] == '-') lower[axis] = -size[axis];
      all[axis] = 2 * size[axis];
    }
    whole.bodies[0].shape = std::make_shared<Box>(dim, lower, all);
    const double row = dim == 3 ? 0.02 : 0.033;  // across x, between two rows in the plane
    half.bars.push_back(
        {"bar", 0, {0, row, 0.02 * (dim - 2)}, {size[0], row, 0.02 * (dim - 2)}, 2e-4, "steel"});
    whole.bars.push_back(half.bars[0]);
    whole.bars[0].from[0] = lower[0];
    whole.bars[0].to[0] = lower[0] + all[0];
    if (dim == 3) {  // the whole has its mirror image too
      whole.bars.push_back(whole.bars[0]);
      whole.bars[1].from[2] = whole.bars[1].to[2] = -0.02;
    } else if (c.planes.size() == 2) {
      whole.bars.push_back(whole.bars[0]);
      whole.bars[1].from[1] = whole.bars[1].to[1] = -row;
    }
  }
};

/// Random at the points, without the normal component on the planes.
AlignedVector<double> field(const Pair& pair, const Discretization& d, unsigned seed, double size) {
  AlignedVector<double> u = random_vector(d, seed, size);
  for (std::size_t i = 0; i < d.layout().points; ++i)
    for (const auto& [axis, at] : pair.planes)
      if (std::abs(d.position(i)[axis] - at) < 1e-9) u[d.layout().at(i, axis)] = 0;
  return u;
}

std::array<long, 3> key(const Point& p) {
  return {std::lround(p[0] * 1e6), std::lround(p[1] * 1e6), std::lround(p[2] * 1e6)};
}

/// Point of the half that a point of the whole mirrors, and the signs of its components.
std::pair<std::size_t, Point> image(const Pair& pair,
                                    const std::map<std::array<long, 3>, std::size_t>& in_half, Point p) {
  Point sign{1, 1, 1};
  for (const auto& [axis, at] : pair.planes) {
    const double inside = at == 0 ? 1 : -1;
    if ((p[axis] - at) * inside < -1e-9) p[axis] = 2 * at - p[axis], sign[axis] = -1;
  }
  return {in_half.at(key(p)), sign};
}

void compare_half_and_whole(const HalfCase& c, bool large) {
  const Pair pair(c, large);
  const auto half = sph::discretize(pair.half, 0, c.options),
             whole = sph::discretize(pair.whole, 0, c.options);
  const auto u = field(pair, *half, 3, 1e-5), v = field(pair, *half, 4, 1.0);
  std::map<std::array<long, 3>, std::size_t> in_half;
  for (std::size_t i = 0; i < half->layout().points; ++i) in_half[key(half->position(i))] = i;
  const int dim = half->layout().dim;
  AlignedVector<double> U(whole->layout().size, 0.0), V = U;
  for (std::size_t i = 0; i < whole->layout().points; ++i) {
    const auto [j, sign] = image(pair, in_half, whole->position(i));
    for (int a = 0; a < dim; ++a) {
      U[whole->layout().at(i, a)] = sign[a] * u[half->layout().at(j, a)];
      V[whole->layout().at(i, a)] = sign[a] * v[half->layout().at(j, a)];
    }
  }
  const auto forces = [](Discretization& d, const auto& at, const auto& velocity) {
    AlignedVector<double> f(at.size(), 0.0), g(d.has_viscosity() ? at.size() : 0, 0.0);
    d.internal_force(at.data(), velocity.data(), 0, f.data(), g.empty() ? nullptr : g.data());
    for (std::size_t i = 0; i < g.size(); ++i) f[i] += g[i];
    return f;
  };
  const auto f = forces(*half, u, v), F = forces(*whole, U, V);
  double mass = 0, all_mass = 0, scale = 0;
  for (double m : half->mass()) mass += m;
  for (double m : whole->mass()) all_mass += m;
  for (std::size_t i = 0; i < F.size(); ++i) scale = std::max(scale, std::abs(F[i]));
  const double parts = std::pow(2.0, double(pair.planes.size())),
               typical = all_mass / double(whole->layout().points);
  EXPECT_NEAR(mass * parts, all_mass, 1e-12 * all_mass) << c.name;
  for (std::size_t i = 0; i < whole->layout().points; ++i) {
    const auto [j, sign] = image(pair, in_half, whole->position(i));
    for (int a = 0; a < dim; ++a) {
      const bool held = std::any_of(
          pair.planes.begin(), pair.planes.end(), [&, axis = a, k = j](const auto& p) {
            return p.first == axis && std::abs(half->position(k)[axis] - p.second) < 1e-9;
          });
      if (held) continue;
      ASSERT_NEAR(F[whole->layout().at(i, a)] / whole->mass()[i],
                  sign[a] * f[half->layout().at(j, a)] / half->mass()[j], 1e-11 * scale / typical)
          << c.name << " point " << i << " component " << a;
    }
  }
  EXPECT_NEAR(parts * half->energies(u.data()).strain, whole->energies(U.data()).strain,
              1e-12 * whole->energies(U.data()).strain)
      << c.name;
  EXPECT_NEAR(parts * half->energies(u.data()).hourglass, whole->energies(U.data()).hourglass,
              1e-12 * whole->energies(U.data()).strain)
      << c.name;
}

TEST(SphSymmetry, HalfEqualsWhole) {
  for (const HalfCase& c : half_cases()) compare_half_and_whole(c, false);
}

TEST(SphSymmetry, HalfEqualsWholeWithFiniteRotation) {
  for (const HalfCase& c : half_cases())
    if (c.options.formulation == "corrected") compare_half_and_whole(c, true);
}

// The stiffness that bounds the step is the derivative of the force at rest, bars and mirrored particles
// included.
TEST(SphSymmetry, StiffnessIsTheForceOfALinearBody) {
  for (const HalfCase& c : half_cases()) {
    if (c.options.viscosity.on()) continue;
    const Pair pair(c, false);
    const auto d = sph::discretize(pair.half, 0, c.options);
    const auto u = field(pair, *d, 8, 1e-5);
    const auto f = force(*d, u);
    AlignedVector<double> y(u.size(), 0.0);
    d->stiffness(u.data(), y.data());
    for (std::size_t i = 0; i < f.size(); ++i) ASSERT_NEAR(y[i], -f[i], 1e-13 * largest(f)) << c.name;
    EXPECT_NEAR(
        0.5 * dot(u, y), d->energies(u.data()).strain + d->energies(u.data()).hourglass, 1e-11 * dot(u, y))
        << c.name;
  }
}

// With finite rotation the force is still the derivative of the energy: central differences, error of order
// step^2.
TEST(SphSymmetry, ForceOfBarsIsTheDerivativeOfTheirEnergy) {
  for (HalfCase c : half_cases()) {
    if (c.options.formulation != "corrected" || c.options.force_lists) continue;
    c.options.hourglass = 0;
    const Pair pair(c, true);
    const auto d = sph::discretize(pair.half, 0, c.options);
    const auto u = field(pair, *d, 5, 1e-4), w = field(pair, *d, 6, 1e-4);
    AlignedVector<double> right = u, left = u;
    const double step = 1e-4;
    for (std::size_t i = 0; i < u.size(); ++i) right[i] += step * w[i], left[i] -= step * w[i];
    const double derivative = (d->energies(right.data()).strain - d->energies(left.data()).strain) /
                              (2 * step);
    EXPECT_NEAR(
        derivative, -dot(force(*d, u), w), 1e-6 * std::abs(derivative) + 1e-9 * d->energies(u.data()).strain)
        << c.name;
  }
}

TEST(SphSymmetry, WhatCannotBeMirroredIsRefused) {
  HalfCase c{"", Plane::stress, {"x-", "x+"}, corrected(0.01)};
  Pair pair(c, false);
  pair.half.bars.clear();
  pair.half.bodies[0].shape = std::make_shared<Box>(2, Point{}, Point{0.01, 0.1, 0});
  EXPECT_THROW(sph::discretize(pair.half, 0, corrected(0.01)), std::runtime_error);
  EXPECT_THROW(
      sph::discretize(pair.half, 0, classic(0.01, sph::MassRule::share, sph::Boundary::virtual_particles)),
      std::runtime_error);
}

}  // namespace
}  // namespace femsph::test
