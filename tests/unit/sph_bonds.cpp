// SPH on updated neighbours whose bonds have a memory: the packed passes against loops over all pairs, and
// what must hold for any motion of the particles.

#include <gtest/gtest.h>

#include "sph_updated_support.hpp"

namespace femsph::test {
namespace {

sph::Options updated(double spacing) {
  sph::Options o;
  o.formulation = "updated";
  o.spacing = spacing;
  o.smoothing = 1.3;
  o.hourglass = 4;
  o.projection = false;
  return o;
}

Scene bond_scene(Plane plane, bool plastic) {
  Scene scene = box_scene(plane, plane == Plane::none ? Point{0.06, 0.05, 0.04} : Point{0.13, 0.1, 0}, true);
  if (plastic)
    scene.materials.at("steel").parameters = Plasticity{300e6, 2.1e9};
  else
    scene.materials.at("steel").parameters = NeoHookean::Parameters{};
  return scene;
}

/// The equations of sph/README.md, one pair after the other, for lists that never change.
template <int dim>
struct PlainBonds {
  using Vector = std::array<double, dim>;
  using Matrix = Tensor<double, dim>;
  const Discretization& d;
  Plastic law;
  sph::Kernel kernel;
  double spacing, thickness;
  std::vector<double> V{}, K{};
  struct Bond {
    std::size_t i, j;
    double eta, q = 0;
  };
  std::vector<Bond> bonds{};
  std::vector<Symmetric<double, dim>> tau{};
  std::vector<std::array<double, 8>> history{};

  void begin(const std::vector<double>& volumes, const std::vector<double>& whole) {
    V = volumes, K = whole;
    tau.resize(V.size()), history.resize(V.size());
    for (std::size_t i = 0; i < V.size(); ++i)
      for (std::size_t j = 0; j < V.size(); ++j) {
        const double R = length(apart_at(i, j, nullptr, nullptr, 0));
        if (i != j && R < kernel.radius() + 0.3 * spacing) bonds.push_back({i, j, R});
      }
  }
  static double length(const Vector& r) {
    double s = 0;
    for (double x : r) s += x * x;
    return std::sqrt(s);
  }
  Vector apart_at(std::size_t i, std::size_t j, const double* u, const double* v, double back) const {
    Vector r;
    for (int c = 0; c < dim; ++c) {
      const auto a = d.layout().at(i, c), b = d.layout().at(j, c);
      r[std::size_t(c)] = d.position(j)[std::size_t(c)] - d.position(i)[std::size_t(c)];
      if (u) r[std::size_t(c)] += u[b] - u[a];
      if (v) r[std::size_t(c)] -= back * (v[b] - v[a]);
    }
    return r;
  }
  double weight(double eta, double R) const {
    return kernel.steepness(eta) * std::pow(std::max(1.0, eta / R), 3);
  }
  std::vector<Matrix> moments(const AlignedVector<double>& u, const double* v, double back) const {
    std::vector<Matrix> M(V.size(), Matrix{}), B(V.size());
    for (const Bond& b : bonds) {
      const Vector r = apart_at(b.i, b.j, u.data(), v, back);
      const double w = K[b.j] * weight(b.eta, length(r));
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c) M[b.i][a][c] += w * r[std::size_t(a)] * r[std::size_t(c)];
    }
    for (std::size_t i = 0; i < M.size(); ++i) invert(M[i], B[i]);
    return B;
  }

  void step(const AlignedVector<double>& u, const AlignedVector<double>& v, double dt,
            AlignedVector<double>& f) {
    const std::size_t count = V.size();
    const std::vector<Matrix> middle = moments(u, v.data(), dt / 2);
    std::vector<Matrix> L(count, Matrix{});
    for (const Bond& b : bonds) {
      const Vector r = apart_at(b.i, b.j, u.data(), v.data(), dt / 2);
      const double w = dt * K[b.j] * weight(b.eta, length(r));
      for (int a = 0; a < dim; ++a) {
        const double dv = v[d.layout().at(b.j, a)] - v[d.layout().at(b.i, a)];
        for (int c = 0; c < dim; ++c)
          for (int k = 0; k < dim; ++k) L[b.i][a][c] += w * dv * r[std::size_t(k)] * middle[b.i][k][c];
      }
    }
    std::vector<double> kept(count, 1.0);
    std::vector<Matrix> S(count, Matrix{});
    for (std::size_t i = 0; i < count; ++i) {
      Matrix W;
      Symmetric<double, dim> D, s{};
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c)
          W[a][c] = 0.5 * (L[i][a][c] - L[i][c][a]), D(a, c) = 0.5 * (L[i][a][c] + L[i][c][a]);
      const Matrix Q = PlainUpdated<dim, Plastic>::turn(W);
      for (int a = 0; a < dim; ++a)
        for (int c = a; c < dim; ++c)
          for (int k = 0; k < dim; ++k)
            for (int l = 0; l < dim; ++l) s(a, c) += Q[a][k] * tau[i](k, l) * Q[c][l];
      const double p = law.plastic_strain(history[i].data());
      law.update(D, s, history[i].data());
      tau[i] = s;
      const double dp = law.plastic_strain(history[i].data()) - p;
      double across = dim == 2 ? history[i][Plastic::across] : 0.0, mean = across, q2 = 0;
      for (int a = 0; a < dim; ++a) mean += s[a];
      mean /= 3;
      if (dim == 2) q2 += (across - mean) * (across - mean);
      for (int k = 0; k < symmetric_size<dim>; ++k)
        q2 += k < dim ? (s[k] - mean) * (s[k] - mean) : 2 * s[k] * s[k];
      const double q = std::sqrt(1.5 * q2);
      if (dp > 0) kept[i] = q / (q + 3 * law.elastic().mu * dp);
    }
    std::fill(f.begin(), f.end(), 0.0);
    for (Bond& b : bonds) {
      const Vector r = apart_at(b.i, b.j, u.data(), nullptr, 0),
                   m = apart_at(b.i, b.j, u.data(), v.data(), dt / 2);
      double along = 0, bent = 0;
      for (int a = 0; a < dim; ++a) {
        along += (v[d.layout().at(b.j, a)] - v[d.layout().at(b.i, a)]) * m[std::size_t(a)];
        for (int c = 0; c < dim; ++c)
          bent += m[std::size_t(a)] * 0.5 * (L[b.i][a][c] + L[b.j][a][c]) * m[std::size_t(c)];
      }
      const double R = length(r), grown = (dt * along - bent) / length(m),
                   keep = 0.5 * (kept[b.i] + kept[b.j]), start = 2 * length(m) - R;
      b.eta = R + keep * (b.eta - start) - std::sqrt(keep) * (R - start);
      const double x = b.eta / kernel.h();
      b.q = x < 2 ? std::sqrt(keep) * (std::sqrt(keep) * b.q + grown) : 0.0;
      const double t = xi * law.elastic().mu * thickness * K[b.i] * K[b.j] * kernel.steepness(b.eta) *
                       std::pow(x, 4) * b.q;
      for (int a = 0; a < dim; ++a) {
        f[d.layout().at(b.i, a)] += t * r[std::size_t(a)] / R;
        for (int c = 0; c < dim; ++c) S[b.i][a][c] -= 0.5 * t / R * r[std::size_t(a)] * r[std::size_t(c)];
      }
    }
    const std::vector<Matrix> B = moments(u, nullptr, 0);
    std::vector<Matrix> Q(count, Matrix{});
    for (std::size_t i = 0; i < count; ++i)
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c)
          for (int k = 0; k < dim; ++k)
            Q[i][a][c] += (V[i] * thickness * tau[i](a, k) + S[i][a][k]) * B[i][k][c];
    for (const Bond& b : bonds) {
      const Vector r = apart_at(b.i, b.j, u.data(), nullptr, 0);
      const double w = weight(b.eta, length(r));
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c)
          f[d.layout().at(b.i, a)] += w * (K[b.j] * Q[b.i][a][c] + K[b.i] * Q[b.j][a][c]) * r[std::size_t(c)];
    }
  }
  static constexpr double xi = 4;
};

template <int dim>
void compare_bonds_with_plain(Plane plane, sph::KernelKind kind) {
  const Scene scene = bond_scene(plane, true);
  sph::Options options = updated(0.01);
  options.kernel = kind;
  const auto moving = sph::discretize(scene, 0, options);
  const double thickness = scene.bodies[0].thickness, cell = dim == 2 ? 1e-4 : 1e-6;
  PlainBonds<dim> plain{*moving, std::get<Plastic>(scene.materials.at("steel").law(plane)),
                        sph::Kernel(kind, dim, 1.3 * moving->spacing()), moving->spacing(), thickness};
  std::vector<double> volumes;
  for (double m : moving->mass()) volumes.push_back(m / 7850 / thickness);
  plain.begin(volumes, std::vector<double>(volumes.size(), cell));
  AlignedVector<double> f(moving->layout().size, 0.0), F = f, before = f;
  moving->internal_force(before.data(), before.data(), 0, f.data(), nullptr);
  const double dt = 1e-6;
  for (int k = 1; k <= 8; ++k) {  // by less than the half skin, so that the lists remain
    const AlignedVector<double> u = swirl(*moving, 0.004 * k);
    const AlignedVector<double> v = velocity_to(u, before, dt);
    moving->internal_force(u.data(), v.data(), dt, f.data(), nullptr);
    plain.step(u, v, dt, F);
    ASSERT_GT(largest(F), 0);
    ASSERT_LE(apart(f, F), 1e-10 * largest(F)) << "step " << k;
  }
  EXPECT_GT(moving->energies(nullptr).plastic, 0);
  EXPECT_GT(moving->energies(nullptr).hourglass, 0);
}

TEST(BondsSlow, AreThePlainSumOverAllPairsBeyondYield) {
  compare_bonds_with_plain<2>(Plane::strain, sph::KernelKind::cubic_spline);
  compare_bonds_with_plain<2>(Plane::strain, sph::KernelKind::wendland_c2);
  compare_bonds_with_plain<3>(Plane::none, sph::KernelKind::cubic_spline);
}

/// Forces along a motion of several spacings, with new searches.
template <class Check>
void along_a_swirl(Discretization& d, Check&& check) {
  AlignedVector<double> f(d.layout().size, 0.0), before = f;
  d.internal_force(before.data(), before.data(), 0, f.data(), nullptr);
  for (int k = 1; k <= 40; ++k) {
    const AlignedVector<double> u = swirl(d, 0.02 * k), v = velocity_to(u, before, 1e-6);
    d.internal_force(u.data(), v.data(), 1e-6, f.data(), nullptr);
    check(u, f);
  }
}

TEST(Bonds, ConserveLinearAndAngularMomentum) {
  for (const Plane plane : {Plane::strain, Plane::none})
    for (const bool plastic : {true, false}) {
      const auto d = sph::discretize(bond_scene(plane, plastic), 0, updated(0.01));
      along_a_swirl(*d, [&](const AlignedVector<double>& u, const AlignedVector<double>& f) {
        Point sum{}, torque{};
        double size = 0;
        for (std::size_t i = 0; i < d->layout().points; ++i) {
          Point x = d->position(i), g{};
          for (int c = 0; c < d->layout().dim; ++c) {
            x[std::size_t(c)] += u[d->layout().at(i, c)];
            g[std::size_t(c)] = f[d->layout().at(i, c)];
            size += std::abs(g[std::size_t(c)]);
          }
          for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += g[c];
            torque[c] += x[(c + 1) % 3] * g[(c + 2) % 3] - x[(c + 2) % 3] * g[(c + 1) % 3];
          }
        }
        ASSERT_GT(size, 0);
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_LT(std::abs(sum[c]), 1e-13 * size);
          EXPECT_LT(std::abs(torque[c]), 1e-13 * size * 0.2);
        }
      });
    }
}

TEST(Bonds, StiffnessIsSymmetricAndThatOfASmallStep) {
  for (const Plane plane : {Plane::stress, Plane::none}) {
    const Scene scene = bond_scene(plane, true);
    const auto d = sph::discretize(scene, 0, updated(0.01));
    const AlignedVector<double> x = random_vector(*d, 1, 1e-9), y = random_vector(*d, 2, 1e-9);
    AlignedVector<double> Kx = x, Ky = y, f = x, none(x.size(), 0.0), v = x;
    d->stiffness(x.data(), Kx.data());
    d->stiffness(y.data(), Ky.data());
    EXPECT_NEAR(dot(y, Kx), dot(x, Ky), 1e-12 * dot(x, Kx));
    EXPECT_GT(dot(x, Kx), 0);
    d->internal_force(none.data(), none.data(), 0, f.data(), nullptr);
    EXPECT_EQ(largest(f), 0);
    for (double& c : v) c /= 1e-6;
    d->internal_force(x.data(), v.data(), 1e-6, f.data(), nullptr);
    for (double& c : f) c = -c;
    EXPECT_LT(apart(f, Kx), 1e-5 * largest(Kx));
  }
}

TEST(Bonds, DoNotDependOnTheThreadsAndGoOnFromASavedState) {
  Scene scene = box_scene(Plane::strain, {1.3, 0.7, 0}, true);
  scene.materials.at("steel").parameters = Plasticity{300e6, 2.1e9};
  scene.symmetries.push_back({Place{0, {"x-"}, {}, {}, {}}});
  sph::Options options = updated(0.01);
  options.viscosity = {0.2, 0.4, 0.01};
  AlignedVector<double> force_of[2];
  for (int threads : {1, 2}) {
    set_threads(threads);
    const auto d = sph::discretize(scene, 0, options), later = sph::discretize(scene, 0, options);
    ASSERT_GT(d->layout().points, serial_below);  // else one thread does it all
    AlignedVector<double> f(d->layout().size, 0.0), g = f, F = f, G = f, before = f;
    d->internal_force(before.data(), before.data(), 0, f.data(), g.data());
    for (int k = 1; k <= 20; ++k) {
      AlignedVector<double> u = swirl(*d, 0.02 * k);
      for (std::size_t i = 0; i < d->layout().points; ++i)  // the plane holds its particles
        if (std::abs(d->position(i)[0] - 0.01) < 1e-9) u[d->layout().at(i, 0)] = 0;
      const AlignedVector<double> v = velocity_to(u, before, 1e-6);
      d->internal_force(u.data(), v.data(), 1e-6, f.data(), g.data());
      if (k > 13) later->internal_force(u.data(), v.data(), 1e-6, F.data(), G.data());
      if (k == 13) {
        MemoryArchive saved;
        saved.save(*d);
        saved.restore(*later);
      }
    }
    EXPECT_EQ(f, F);
    EXPECT_EQ(g, G);
    EXPECT_EQ(d->energies(nullptr).plastic, later->energies(nullptr).plastic);
    set_threads(1);
    force_of[threads - 1] = f;
  }
  EXPECT_GT(largest(force_of[0]), 0);
  EXPECT_EQ(force_of[0], force_of[1]);
}

// A half (with two planes a quarter) has the accelerations and the share of the energy of the whole, along a
// motion with new searches.
TEST(Bonds, OfAHalfAreThoseOfTheWhole) {
  for (const bool quarter : {false, true}) {
    Scene half = box_scene(Plane::strain, {}, true);
    half.materials.at("steel").parameters = Plasticity{300e6, 2.1e9};
    Scene whole = half;
    half.bodies[0].shape = std::make_shared<Box>(2, Point{0, 0, 0}, Point{0.1, 0.08, 0});
    whole.bodies[0].shape = std::make_shared<Box>(
        2, Point{-0.1, quarter ? -0.08 : 0, 0}, Point{0.2, quarter ? 0.16 : 0.08, 0});
    half.symmetries.push_back({Place{0, {"x-"}, {}, {}, {}}});
    if (quarter) half.symmetries.push_back({Place{0, {"y-"}, {}, {}, {}}});
    const auto a = sph::discretize(half, 0, updated(0.01)), b = sph::discretize(whole, 0, updated(0.01));
    const auto at_time = [](const Discretization& d, double t) {
      AlignedVector<double> u(d.layout().size, 0.0);
      for (std::size_t i = 0; i < d.layout().points; ++i) {
        const Point X = d.position(i);
        u[d.layout().at(i, 0)] = t * std::sin(25 * X[0]) * std::cos(20 * X[1]);
        u[d.layout().at(i, 1)] = t * std::cos(30 * X[0]) * std::sin(22 * X[1]);
      }
      return u;
    };
    AlignedVector<double> f(a->layout().size, 0.0), F(b->layout().size, 0.0), before = f, Before = F;
    a->internal_force(before.data(), before.data(), 0, f.data(), nullptr);
    b->internal_force(Before.data(), Before.data(), 0, F.data(), nullptr);
    for (int k = 1; k <= 20; ++k) {
      const AlignedVector<double> u = at_time(*a, 0.001 * k), v = velocity_to(u, before, 1e-6),
                                  U = at_time(*b, 0.001 * k), V = velocity_to(U, Before, 1e-6);
      a->internal_force(u.data(), v.data(), 1e-6, f.data(), nullptr);
      b->internal_force(U.data(), V.data(), 1e-6, F.data(), nullptr);
    }
    double most = 0;
    for (std::size_t j = 0; j < b->layout().points; ++j)
      most = std::max(most, std::abs(F[b->layout().at(j, 0)] / b->mass()[j]));
    int seen = 0;
    for (std::size_t i = 0; i < a->layout().points; ++i)
      for (std::size_t j = 0; j < b->layout().points; ++j) {
        const Point x = a->position(i), y = b->position(j);
        if (std::abs(x[0] - y[0]) + std::abs(x[1] - y[1]) > 1e-9) continue;
        ++seen;
        for (int c = 0; c < 2; ++c) {
          if (x[std::size_t(c)] < 1e-9 && (c == 0 || quarter)) continue;  // held
          EXPECT_NEAR(
              f[a->layout().at(i, c)] / a->mass()[i], F[b->layout().at(j, c)] / b->mass()[j], 1e-9 * most);
        }
      }
    EXPECT_EQ(std::size_t(seen), a->layout().points);
    const Energies one = a->energies(nullptr), all = b->energies(nullptr);
    const double parts = quarter ? 4 : 2;
    EXPECT_NEAR(parts * one.strain, all.strain, 1e-9 * all.strain);
    EXPECT_NEAR(parts * one.hourglass, all.hourglass, 1e-9 * all.hourglass);
    EXPECT_NEAR(parts * one.plastic, all.plastic, 1e-9 * all.plastic);
    EXPECT_GT(all.plastic, 0);
  }
}

// With positions of a march that diverges, a call still ends soon and takes no more memory.
TEST(Bonds, SurvivePositionsThatAreNoNumbers) {
  Scene scene = box_scene(Plane::strain, {0.4, 0.3, 0}, true);
  scene.materials.at("steel").parameters = Plasticity{300e6, 2.1e9};
  for (double wild : {nan, infinite, 1e300, 1e9, 40.0}) {
    const auto d = sph::discretize(scene, 0, updated(0.01));
    AlignedVector<double> u(d->layout().size, 0.0), f = u;
    d->internal_force(u.data(), u.data(), 0, f.data(), nullptr);
    const std::size_t bytes = d->bytes();
    for (int k = 1; k <= 20; ++k) {
      for (std::size_t i = 0; i < d->layout().points; ++i)
        if (i % std::size_t(k) == 0)
          u[d->layout().at(i, int(i % 2))] = wild * std::sin(double(i * std::size_t(k)));
      d->internal_force(u.data(), u.data(), 1e-6, f.data(), nullptr);
    }
    EXPECT_LT(d->bytes(), 5 * bytes) << wild;
  }
}

}  // namespace
}  // namespace femsph::test
