// The mean dilatation of corrected SPH: the force is the derivative of the energy in small and large motion,
// momenta are kept, uniform states are left as they are, and the pressure of a nearly incompressible ring no
// longer alternates from layer to layer (Lame's solution).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/input/faults.hpp"
#include "model/scene/shapes/round.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

struct LockingCase {
  const char* name;
  Plane plane;
  bool large, lists;
  double jitter = 0;
  bool mirrored = false;
};

const std::vector<LockingCase>& locking_cases() {
  static const std::vector<LockingCase> all = {
      {"plane strain", Plane::strain, false, false},
      {"plane strain, lists", Plane::strain, false, true},
      {"jittered", Plane::strain, false, true, 0.2},
      {"plane strain, large", Plane::strain, true, false},
      {"space", Plane::none, false, false},
      {"space, large, jittered", Plane::none, true, true, 0.2},
      {"symmetry", Plane::strain, false, false, 0, true},
      {"symmetry, large, lists", Plane::strain, true, true, 0, true}};
  return all;
}

Scene scene_of(const LockingCase& c, double poisson = 0.49) {
  Scene s = box_scene(
      c.plane, c.plane == Plane::none ? Point{0.06, 0.05, 0.04} : Point{0.11, 0.08, 0}, c.large);
  s.materials["steel"].poisson = poisson;
  if (c.mirrored) s.symmetries.push_back({Place{0, {"x-"}, {}, {}, {}}});
  return s;
}
sph::Options options_of(const LockingCase& c) {
  sph::Options o = corrected(0.01);
  o.dilatation = sph::Dilatation::mean;
  o.force_lists = c.lists;
  o.jitter = c.jitter;
  return o;
}
/// Normal motion of particles on the plane of symmetry is held by the march.
void hold(const LockingCase& c, const Discretization& d, AlignedVector<double>& x) {
  for (std::size_t i = 0; c.mirrored && i < d.layout().points; ++i)
    if (std::abs(d.position(i)[0] - 0.01) < 1e-9) x[d.layout().at(i, 0)] = 0;
}

TEST(MeanDilatation, ForceIsTheDerivativeOfTheEnergy) {
  for (const LockingCase& c : locking_cases()) {
    const Scene scene = scene_of(c);
    const auto d = sph::discretize(scene, 0, options_of(c));
    auto u = random_vector(*d, 1, c.large ? 1e-3 : 1e-5), v = random_vector(*d, 2, 1.0);
    hold(c, *d, u), hold(c, *d, v);
    const double step = c.large ? 1e-8 : 1e-6;
    const auto energy = [&](double s) {
      auto x = u;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += s * v[i];
      const Energies e = d->energies(x.data());
      return e.strain + e.hourglass;
    };
    const double slope = (energy(step) - energy(-step)) / (2 * step), work = -dot(force(*d, u), v);
    EXPECT_NEAR(slope, work, 1e-6 * std::abs(work)) << c.name;
  }
}

TEST(MeanDilatation, KeepsMomenta) {
  for (const LockingCase& c : locking_cases()) {
    if (c.mirrored) continue;
    const auto d = sph::discretize(scene_of(c), 0, options_of(c));
    const auto u = random_vector(*d, 3, c.large ? 1e-3 : 1e-5), f = force(*d, u);
    double sum[3] = {}, moment[3] = {}, size = 0;
    for (std::size_t i = 0; i < d->layout().points; ++i) {
      Point x = d->position(i), g{};
      for (int k = 0; k < d->layout().dim; ++k) {
        g[k] = f[d->layout().at(i, k)], sum[k] += g[k], size += std::abs(g[k]);
        if (c.large) x[k] += u[d->layout().at(i, k)];
      }
      for (int k = 0; k < 3; ++k)
        moment[k] += x[(k + 1) % 3] * g[(k + 2) % 3] - x[(k + 2) % 3] * g[(k + 1) % 3];
    }
    for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(sum[k]), 1e-12 * size) << c.name;
    for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(moment[k]), 1e-12 * size) << c.name;
  }
}

// Linear displacements: the mean is the value itself, so that force and stress are those of the particles'
// own volumes.
TEST(MeanDilatation, LeavesUniformStatesAlone) {
  for (const LockingCase& c : locking_cases()) {
    if (c.mirrored) continue;
    sph::Options local = options_of(c);
    local.dilatation = sph::Dilatation::local;
    const Scene scene = scene_of(c);
    const auto a = sph::discretize(scene, 0, options_of(c)), b = sph::discretize(scene, 0, local);
    const double A[3][3] = {{1e-3, 2e-3, 0}, {-5e-4, -4e-3, 1e-3}, {0, 2e-3, 1e-3}};
    const auto u = linear_vector(*a, A), f = force(*a, u), g = force(*b, u);
    for (std::size_t i = 0; i < f.size(); ++i) ASSERT_NEAR(f[i], g[i], 1e-11 * largest(g)) << c.name;
    std::vector<std::size_t> all(a->material_points());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    MaterialState p, q;
    a->material_state(u.data(), all, p), b->material_state(u.data(), all, q);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < 6; ++k)
        ASSERT_NEAR(p.stress[i][k], q.stress[i][k], 1e-11 * von_mises(q.stress[i])) << c.name;
  }
}

// A few points' state is that of all points'.
TEST(MeanDilatation, StateOfSomePoints) {
  for (const LockingCase& c : locking_cases()) {
    const auto d = sph::discretize(scene_of(c), 0, options_of(c));
    auto u = random_vector(*d, 4, c.large ? 1e-3 : 1e-5);
    hold(c, *d, u);
    std::vector<std::size_t> all(d->material_points()), some{3, 17, 18, d->material_points() - 1};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    MaterialState one, other;
    d->material_state(u.data(), all, one), d->material_state(u.data(), some, other);
    for (std::size_t k = 0; k < some.size(); ++k) EXPECT_EQ(one.stress[some[k]], other.stress[k]) << c.name;
  }
}

// When it is taken: where the body keeps its volume.
TEST(MeanDilatation, IsTakenWhereTheVolumeIsKept) {
  const LockingCase strain{"", Plane::strain, false, false}, stress{"", Plane::stress, false, false};
  const auto memory = [&](const LockingCase& c, double poisson, bool plastic, sph::Dilatation kind) {
    Scene s = scene_of(c, poisson);
    if (plastic) s.materials["steel"].parameters = Plasticity{3e8, 0};
    sph::Options o = corrected(0.01);
    o.dilatation = kind;
    return sph::discretize(s, 0, o)->bytes();
  };
  using enum sph::Dilatation;
  EXPECT_EQ(memory(strain, 0.3, false, automatic), memory(strain, 0.3, false, local));
  EXPECT_LT(
      memory(strain, 0.3, false, local), memory(strain, 0.3, false, mean));  // no memory for what is off
  EXPECT_EQ(memory(strain, 0.45, false, automatic), memory(strain, 0.45, false, mean));
  EXPECT_EQ(memory(strain, 0.3, true, automatic), memory(strain, 0.3, true, mean));
  EXPECT_EQ(memory(stress, 0.49, true, automatic), memory(stress, 0.49, true, local));
  EXPECT_THROW(memory(stress, 0.49, false, mean), Refusal);
}

/// Largest error of the pressure in a quarter ring under inner pressure, over that pressure; plane strain, nu
/// = 0.4999.
double pressure_error(sph::Dilatation kind, int across) {
  const double a = 0.1, b = 0.2, poisson = 0.4999, load = 1e6;
  Scene s = box_scene(Plane::strain, {1, 1, 0});
  s.bodies[0].shape = std::make_shared<Round>(2, Round::Size{{}, a, b, 0, 2, Round::Part::quarter});
  s.bodies[0].thickness = 1;
  s.materials["steel"].poisson = poisson;
  s.symmetries = {{Place{0, {"x-"}, {}, {}, {}}}, {Place{0, {"y-"}, {}, {}, {}}}};
  sph::Options o = corrected((b - a) / across);
  o.dilatation = kind;
  const auto d = sph::discretize(s, 0, o);
  const Layout& layout = d->layout();
  std::vector<char> held(layout.size, 1);
  for (std::size_t i = 0; i < layout.points; ++i)
    for (int c = 0; c < 2; ++c) held[layout.at(i, c)] = d->position(i)[c] < 1e-9;
  AlignedVector<double> r(layout.size, 0.0), x = r, p, kp = r;
  for (const PointArea& part : d->outward_areas({0, {"inner"}, {}, {}, {}}))
    for (int c = 0; c < 2; ++c) r[layout.at(part.point, c)] -= load * part.area[c];
  const auto take_held = [&](AlignedVector<double>& y) {
    for (std::size_t i = 0; i < y.size(); ++i)
      if (held[i]) y[i] = 0;
  };
  take_held(r);
  p = r;
  double rr = dot(r, r);
  const double stop = 1e-20 * rr;
  for (int turn = 0; turn < 20000 && rr > stop; ++turn) {  // conjugate gradients
    d->stiffness(p.data(), kp.data());
    take_held(kp);
    const double step = rr / dot(p, kp);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * p[i], r[i] -= step * kp[i];
    const double next = dot(r, r);
    for (std::size_t i = 0; i < x.size(); ++i) p[i] = r[i] + next / rr * p[i];
    rr = next;
  }
  EXPECT_LE(rr, stop);
  std::vector<std::size_t> all(d->material_points());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  MaterialState state;
  d->material_state(x.data(), all, state);
  const double exact = -2 * (1 + poisson) / 3 * load * a * a / (b * b - a * a);
  double worst = 0;
  for (const auto& t : state.stress)
    worst = std::max(worst, std::abs(-(t[0] + t[1] + t[2]) / 3 - exact) / load);
  return worst;
}

TEST(MeanDilatation, PressureOfANearlyIncompressibleRing) {
  const double coarse = pressure_error(sph::Dilatation::mean, 8),
               fine = pressure_error(sph::Dilatation::mean, 16);
  EXPECT_LT(coarse, 0.05);
  EXPECT_LT(fine, 0.5 * coarse);
  EXPECT_GT(pressure_error(sph::Dilatation::local, 8),
            1.0);  // without it: several times the load, alternating
}

}  // namespace
}  // namespace femsph::test
