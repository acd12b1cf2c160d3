// Classic SPH on updated neighbours: the packed passes against loops over all pairs, the lists against a
// search of all pairs, and what must hold however wildly particles move.

#include <gtest/gtest.h>

#include <limits>

#include "model/material/point.hpp"
#include "sph/formulations/stretch_point.hpp"
#include "sph/operators/moving_neighbours.hpp"
#include "sph/particles/cell_list.hpp"
#include "sph_support.hpp"

namespace femsph::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

/// The formulas of sph/formulations/updated_lagrangian.hpp, one pair after the other, with general matrices.
template <int dim, class LawType>
struct PlainUpdated {
  static constexpr int n = symmetric_size<dim>;
  using Matrix = Tensor<double, dim>;
  const Discretization& d;
  LawType law;
  sph::Kernel kernel;
  sph::Viscosity viscosity;
  double thickness, density;
  std::vector<double> volume;
  std::vector<Symmetric<double, dim>> stress = std::vector<Symmetric<double, dim>>(volume.size());
  std::vector<std::array<double, 8>> history = std::vector<std::array<double, 8>>(volume.size());
  double work = 0;

  Point at(const AlignedVector<double>& u, std::size_t i) const {
    Point x = d.position(i);
    for (int c = 0; c < dim; ++c) x[std::size_t(c)] += u[d.layout().at(i, c)];
    return x;
  }
  static double inner(const double* a, const double* b) {
    double s = 0;
    for (int c = 0; c < dim; ++c) s += a[c] * b[c];
    return s;
  }
  /// Q = (I - W/2)^-1 (I + W/2) by the series of W/2: (I - A)^-1 = I + A + A^2 + ..
  static Matrix turn(const Matrix& W) {
    Matrix sum{}, power{};
    for (int i = 0; i < dim; ++i) power[i][i] = 1;
    sum = power;
    for (int k = 0; k < 60; ++k) {
      Matrix next{};
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          for (int l = 0; l < dim; ++l) next[i][j] += 0.5 * power[i][l] * W[l][j];
      power = next;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          sum[i][j] += power[i][j] * 2;  // (I + A)(I - A)^-1 = I + 2 A + 2 A^2 + ..
    }
    return sum;
  }

  void step(const AlignedVector<double>& u, const AlignedVector<double>& v, double dt,
            AlignedVector<double>& f, AlignedVector<double>& g) {
    const std::size_t count = volume.size();
    if (dt > 0) {
      std::vector<double> grown = volume;
      for (std::size_t i = 0; i < count; ++i) {
        Matrix L{};
        for (std::size_t j = 0; j < count; ++j) {
          const Point a = at(u, i), b = at(u, j);
          double x[dim], dv[dim];
          for (int c = 0; c < dim; ++c) {
            dv[c] = v[d.layout().at(j, c)] - v[d.layout().at(i, c)];
            x[c] = b[std::size_t(c)] - a[std::size_t(c)] - 0.5 * dt * dv[c];
          }
          const double s = volume[j] * kernel.steepness(std::sqrt(inner(x, x))) * dt;
          for (int r = 0; r < dim; ++r)
            for (int c = 0; c < dim; ++c) L[r][c] += dv[r] * s * x[c];
        }
        Matrix W;
        Symmetric<double, dim> D, turned{};
        double growth = 0;
        for (int r = 0; r < dim; ++r) {
          growth += L[r][r];
          for (int c = 0; c < dim; ++c)
            W[r][c] = 0.5 * (L[r][c] - L[c][r]), D(r, c) = 0.5 * (L[r][c] + L[c][r]);
        }
        const Matrix Q = turn(W);
        for (int r = 0; r < dim; ++r)
          for (int c = r; c < dim; ++c)
            for (int k = 0; k < dim; ++k)
              for (int l = 0; l < dim; ++l) turned(r, c) += Q[r][k] * stress[i](k, l) * Q[c][l];
        Symmetric<double, dim> now = turned;
        double before = 0;
        if constexpr (!LawType::path_independent) before = law.plastic_work(history[i].data());
        law.update(D, now, history[i].data());
        if constexpr (LawType::path_independent) {
          for (int k = 0; k < n; ++k) turned[k] = 0.5 * (turned[k] + now[k]);
          work += contract(turned, D) * volume[i] * thickness;
        } else {
          work += (law.plastic_work(history[i].data()) - before) * volume[i] * thickness;
        }
        stress[i] = now;
        grown[i] = volume[i] * (1 + growth);
      }
      volume = grown;
    }
    for (std::size_t i = 0; i < count; ++i) {
      double force[dim] = {}, drag[dim] = {};
      for (std::size_t j = 0; j < count; ++j) {
        if (j == i) continue;
        const Point a = at(u, i), b = at(u, j);
        double x[dim], dv[dim];
        for (int c = 0; c < dim; ++c)
          x[c] = b[std::size_t(c)] - a[std::size_t(c)],
          dv[c] = v[d.layout().at(j, c)] - v[d.layout().at(i, c)];
        const double s = volume[i] * volume[j] * thickness * kernel.steepness(std::sqrt(inner(x, x)));
        const double phi = kernel.h() * std::min(inner(dv, x), 0.0) /
                           (inner(x, x) + viscosity.gamma * kernel.h() * kernel.h());
        for (int r = 0; r < dim; ++r) {
          for (int c = 0; c < dim; ++c) force[r] += (stress[i](r, c) + stress[j](r, c)) * s * x[c];
          drag[r] += density * (viscosity.alpha * law.wave_speed() - viscosity.beta * phi) * phi * s * x[r];
        }
      }
      for (int r = 0; r < dim; ++r) f[d.layout().at(i, r)] = force[r], g[d.layout().at(i, r)] = drag[r];
    }
  }
};

/// A body that shears, bends and turns: displacement at time t of the particle at X; up to several spacings.
AlignedVector<double> swirl(const Discretization& d, double t) {
  AlignedVector<double> u(d.layout().size, 0.0);
  for (std::size_t i = 0; i < d.layout().points; ++i) {
    const Point X = d.position(i);
    for (int c = 0; c < d.layout().dim; ++c)
      u[d.layout().at(i, c)] = 0.03 * t *
                                   std::sin(25 * X[std::size_t(c + 1) % std::size_t(d.layout().dim)] + c) +
                               0.2 * t * (c == 0);
  }
  return u;
}

double apart(const AlignedVector<double>& a, const AlignedVector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

template <int dim, class LawType>
void compare_with_plain(Plane plane, bool plastic, sph::KernelKind kind, double smoothing) {
  Scene scene = box_scene(plane, dim == 3 ? Point{0.08, 0.07, 0.06} : Point{0.2, 0.13, 0}, true);
  if (plastic) scene.materials.at("steel").plasticity = Plasticity{300e6, 2.1e9};
  sph::Options options = classic(0.01, sph::MassRule::trapezoid);
  options.kernel = kind;
  options.smoothing = smoothing;
  options.jitter = 0.2;
  options.viscosity = {1.5, 2, 0.01};
  const auto moving = sph::discretize(scene, 0, options);
  const double thickness = scene.bodies[0].thickness;
  PlainUpdated<dim, LawType> plain{
      *moving,
      std::get<LawType>(scene.materials.at("steel").law(plane)),
      sph::Kernel(kind, dim, smoothing * moving->spacing()),
      options.viscosity,
      thickness,
      7850,
      {}};
  for (double m : moving->mass()) plain.volume.push_back(m / 7850 / thickness);
  plain.stress.resize(plain.volume.size());
  plain.history.resize(plain.volume.size());
  AlignedVector<double> f(moving->layout().size, 0.0), g = f, F = f, G = f, before = swirl(*moving, 0);
  const int steps = 12;
  const double dt = 1e-6;
  for (int k = 0; k <= steps; ++k) {
    const AlignedVector<double> u = swirl(*moving, double(k) / steps);
    AlignedVector<double> v = u;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = (u[i] - before[i]) / dt;
    before = u;
    moving->internal_force(u.data(), v.data(), k == 0 ? 0 : dt, f.data(), g.data());
    plain.step(u, v, k == 0 ? 0 : dt, F, G);
    ASSERT_LE(apart(f, F), 1e-12 * largest(F)) << "step " << k;
    ASSERT_LE(apart(g, G), 1e-12 * largest(G)) << "step " << k;
  }
  EXPECT_GT(largest(F), 0);
  EXPECT_GT(largest(G), 0);
  EXPECT_NE(plain.work, 0);
  EXPECT_NEAR(plastic ? moving->energies(nullptr).plastic : moving->energies(nullptr).strain, plain.work,
              1e-12 * std::abs(plain.work));
  double sum = 0, size = 0;
  for (double x : f) sum += x, size += std::abs(x);
  EXPECT_LT(std::abs(sum), 1e-14 * size);  // pairs are equal and opposite
}

TEST(UpdatedLagrangianSlow, IsThePlainSumOverAllPairs) {
  compare_with_plain<2, LinearElastic>(Plane::stress, false, sph::KernelKind::cubic_spline, 1.2);
  compare_with_plain<2, LinearElastic>(Plane::strain, false, sph::KernelKind::wendland_c2, 1.6);
  compare_with_plain<3, LinearElastic>(Plane::none, false, sph::KernelKind::cubic_spline, 1.2);
}

TEST(UpdatedLagrangianSlow, IsThePlainSumOverAllPairsBeyondYield) {
  compare_with_plain<2, Plastic>(Plane::stress, true, sph::KernelKind::cubic_spline, 1.0);
  compare_with_plain<2, Plastic>(Plane::strain, true, sph::KernelKind::cubic_spline, 1.2);
  compare_with_plain<3, Plastic>(Plane::none, true, sph::KernelKind::wendland_c2, 1.3);
}

TEST(UpdatedLagrangian, DoesNotDependOnTheThreads) {
  const Scene scene = box_scene(Plane::stress, {2.0, 0.5, 0}, true);  // 201 x 51: enough for two threads
  sph::Options options = classic(0.01, sph::MassRule::share);
  options.viscosity = {1, 1, 1};
  AlignedVector<double> force_of[2];
  for (int threads : {1, 2}) {
    set_threads(threads);
    const auto d = sph::discretize(scene, 0, options);
    AlignedVector<double> f(d->layout().size, 0.0), g = f, before = swirl(*d, 0);
    for (int k = 0; k <= 5; ++k) {
      const AlignedVector<double> u = swirl(*d, 0.1 * k);
      AlignedVector<double> v = u;
      for (std::size_t i = 0; i < v.size(); ++i) v[i] = (u[i] - before[i]) / 1e-6;
      before = u;
      d->internal_force(u.data(), v.data(), k == 0 ? 0 : 1e-6, f.data(), g.data());
    }
    set_threads(1);
    force_of[threads - 1] = f;
  }
  EXPECT_GT(largest(force_of[0]), 0);
  EXPECT_EQ(force_of[0], force_of[1]);
}

/// M N^-1 of 2 x 2 or 3 x 3 matrices, by Cramer's rule.
template <int dim>
Tensor<double, dim> over(const Tensor<double, dim>& M, const Tensor<double, dim>& N,
                         double* determinant = nullptr) {
  double n[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, inverse[3][3];
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) n[i][j] = N[i][j];
  const auto minor = [&](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return n[a][c] * n[b][d] - n[a][d] * n[b][c];
  };
  const double det = n[0][0] * minor(0, 0) + n[0][1] * minor(0, 1) + n[0][2] * minor(0, 2);
  if (determinant) *determinant = det;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) inverse[j][i] = minor(i, j) / det;
  Tensor<double, dim> out{};
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      for (int k = 0; k < dim; ++k) out[i][j] += M[i][k] * inverse[k][j];
  return out;
}

/// A large stretch and shear that grows while the whole makes two and a half turns.
template <int dim>
Tensor<double, dim> deformation(double t) {
  const double angle = 5 * std::acos(-1.0) * t, c = std::cos(angle), s = std::sin(angle);
  const double R[3][3] = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}},
               U[3][3] = {{1 + 0.8 * t, 0.5 * t, 0.2 * t}, {0, 1 - 0.4 * t, 0.3 * t}, {0, 0, 1 + 0.5 * t}};
  Tensor<double, dim> F{};
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      for (int k = 0; k < dim; ++k) F[i][j] += R[i][k] * U[k][j];
  return F;
}

// The gradient at the middle of a step, L = 2 (F1 - F0)(F1 + F0)^-1, carries F0 to F1 exactly, so after forty
// steps the stress is that of F alone: sigma = (mu (b - 1) + lambda ln J) / J with b = F F^T (Bonet & Wood,
// eq. 6.29); what was put in is held as volume and energy.
template <int dim>
void carry_stretch() {
  const NeoHookean law = NeoHookean::make(5e6, 0.3, 1000, dim == 3 ? Plane::none : Plane::strain);
  using State = sph::StretchPoint<dim, NeoHookean>;
  alignas(64) Pack own[State::size] = {}, volume = broadcast<Pack>(0.25);
  Tensor<double, dim> F{};
  double J = 1;
  for (int k = 0; k <= 40; ++k) {
    const Tensor<double, dim> before = F, next = deformation<dim>(k / 40.0);
    F = next;
    if (k == 0) continue;
    Tensor<double, dim> difference, sum;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        difference[i][j] = 2 * (next[i][j] - before[i][j]), sum[i][j] = next[i][j] + before[i][j];
    const Tensor<double, dim> L = over<dim>(difference, sum);
    Tensor<Pack, dim> packed;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) packed[i][j] = broadcast<Pack>(L[i][j]);
    State::advance(law, packed, volume, own);
  }
  over<dim>(F, F, &J);
  double b_trace = dim == 2 ? 1 : 0;
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      double b = 0;
      for (int k = 0; k < dim; ++k) b += F[i][k] * F[j][k];
      b_trace += i == j ? b : 0;
      const double cauchy = (law.base.mu * (b - (i == j)) + (i == j ? law.lambda * std::log(J) : 0)) / J;
      for (int l = 0; l < lanes; ++l) ASSERT_NEAR((State::pull(own)(i, j)[l]), cauchy, 1e-12 * law.base.mu);
    }
  EXPECT_NEAR(volume[3], 0.25 * J, 1e-13);
  const double energy = 0.25 * (0.5 * law.base.mu * (b_trace - 3 - 2 * std::log(J)) +
                                0.5 * law.lambda * std::log(J) * std::log(J));
  EXPECT_NEAR(State::stored(law, volume, own)[5], energy, 1e-12 * energy);
}

TEST(UpdatedNeoHookean, KnowsTheStressOfTheWholeStretchThroughAnyTurn) {
  carry_stretch<2>();
  carry_stretch<3>();
}

// What the forces do on a small step is what the law stores: E1 - E0 = -(f0 + f1)/2 . (u1 - u0) up to the
// square of the step.
TEST(UpdatedNeoHookean, ForcesAreTheSlopeOfTheEnergy) {
  for (Plane plane : {Plane::stress, Plane::strain, Plane::none}) {
    Scene scene = box_scene(
        plane, plane == Plane::none ? Point{0.08, 0.07, 0.06} : Point{0.2, 0.13, 0}, true);
    scene.materials.at("steel").neo_hookean = true;
    const auto d = sph::discretize(scene, 0, classic(0.01, sph::MassRule::share));
    AlignedVector<double> f(d->layout().size, 0.0), f0, u0, v = f;
    double e0 = 0, e1 = 0, work = 0;
    for (int k = 0; k <= 20; ++k) {
      const AlignedVector<double> u = swirl(*d, k < 20 ? 0.02 * k : 0.38 + 1e-7);
      for (std::size_t i = 0; i < u.size() && k > 0; ++i) v[i] = u[i] - u0[i];
      d->internal_force(u.data(), v.data(), k == 0 ? 0 : 1, f.data(), nullptr);
      if (k == 20)
        for (std::size_t i = 0; i < f.size(); ++i) work -= 0.5 * (f[i] + f0[i]) * v[i];
      e0 = e1, e1 = d->energies(u.data()).strain, f0 = f, u0 = u;
    }
    EXPECT_GT(e1, e0);
    EXPECT_NEAR(e1 - e0, work, 1e-5 * (e1 - e0));
  }
}

// A run taken up again goes on to the last bit, wherever its lists were searched.
TEST(UpdatedLagrangian, GoesOnFromASavedState) {
  Scene scene = box_scene(Plane::strain, {0.3, 0.2, 0}, true);
  scene.materials.at("steel").plasticity = Plasticity{300e6, 2.1e9};
  sph::Options options = classic(0.01, sph::MassRule::share);
  options.viscosity = {1, 1, 1};
  const auto whole = sph::discretize(scene, 0, options), later = sph::discretize(scene, 0, options);
  AlignedVector<double> f(whole->layout().size, 0.0), g = f, F = f, G = f, before = swirl(*whole, 0);
  for (int k = 0; k <= 60; ++k) {
    const AlignedVector<double> u = swirl(*whole, 0.02 * k);
    AlignedVector<double> v = u;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = (u[i] - before[i]) / 1e-6;
    before = u;
    whole->internal_force(u.data(), v.data(), k == 0 ? 0 : 1e-6, f.data(), g.data());
    if (k > 23) later->internal_force(u.data(), v.data(), 1e-6, F.data(), G.data());
    if (k == 23) {
      MemoryArchive saved;
      saved.save(*whole);
      saved.restore(*later);
    }
  }
  EXPECT_GT(whole->energies(nullptr).plastic, 0);
  EXPECT_EQ(whole->energies(nullptr).plastic, later->energies(nullptr).plastic);
  EXPECT_EQ(f, F);
  EXPECT_EQ(g, G);
}

/// Scattered points: most in a box, some far, some very far, some nowhere.
std::vector<Point> scattered(std::size_t count, int dim, double far) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = i % 10 == 0 ? far : 1;
    Point p{};
    for (int a = 0; a < dim; ++a) p[std::size_t(a)] = size * unit(random);
    points.push_back(p);
    if (i % 10 == 0) {  // and one near it
      for (int a = 0; a < dim; ++a) p[std::size_t(a)] += 0.03 * unit(random);
      points.push_back(p);
    }
  }
  return points;
}

TEST(CellList, FindsEveryPairOnceHoweverFarTheyAreScattered) {
  for (int dim : {2, 3})
    for (double far : {1.0, 30.0, 1e6, 1e12}) {
      std::vector<Point> points = scattered(800, dim, far);
      points.push_back({nan, 0.5, 0});
      points.push_back({0.5, infinite, 0});
      points.push_back({-infinite, nan, 0});
      points.push_back({1e300, -1e300, 0});
      const double radius = 0.1;
      const sph::CellList cells(points, dim, radius);
      EXPECT_LT(cells.bytes(), 40000u + 60 * points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<int> found(points.size(), 0);
        cells.around(points[i], [&](int j) { ++found[std::size_t(j)]; });
        for (std::size_t j = 0; j < points.size(); ++j) {
          double r2 = 0;
          for (std::size_t a = 0; a < 3; ++a)
            r2 += (points[j][a] - points[i][a]) * (points[j][a] - points[i][a]);
          ASSERT_LE(found[j], 1);
          if (r2 < radius * radius) {
            ASSERT_EQ(found[j], 1) << dim << " " << far << " " << i << " " << j;
          }
        }
      }
    }
}

struct Crowd {
  std::vector<Point> start;
  Layout layout;
  AlignedVector<double> u;
  explicit Crowd(int n) {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) start.push_back({double(i), double(j), 0});
    layout = {start.size(), 2, 1, round_up(start.size(), lanes), 0, 2 * round_up(start.size(), lanes)};
    u.assign(layout.size, 0.0);
  }
};

TEST(MovingNeighboursSlow, ListsHoldEveryPairWithinReachUntilTheySearchAgain) {
  Crowd c(15);
  const double radius = 2.4;
  sph::MovingNeighbours lists(c.start, c.layout, radius, 0.3);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-0.01, 0.012);
  const int steps = 300;
  for (int step = 0; step < steps; ++step) {
    lists.update(c.u.data());
    std::vector<std::vector<std::int32_t>> listed(c.start.size());
    lists.each_block([&](std::size_t block, const std::int32_t* index, const std::int32_t* end) {
      for (; index != end; index += lanes)
        for (std::size_t l = 0; l < lanes; ++l)
          if (block * lanes + l < c.start.size() && index[l] != std::int32_t(block * lanes + l))
            listed[block * lanes + l].push_back(index[l]);
    });
    for (std::size_t i = 0; i < c.start.size(); ++i)
      for (std::size_t j = 0; j < c.start.size(); ++j) {
        const double x = c.start[j][0] + c.u[c.layout.at(j, 0)] - c.start[i][0] - c.u[c.layout.at(i, 0)];
        const double y = c.start[j][1] + c.u[c.layout.at(j, 1)] - c.start[i][1] - c.u[c.layout.at(i, 1)];
        const auto times = std::count(listed[i].begin(), listed[i].end(), std::int32_t(j));
        ASSERT_LE(times, 1);
        if (i != j && x * x + y * y < radius * radius) {
          ASSERT_EQ(times, 1) << step;
        }
      }
    for (std::size_t i = 0; i < c.start.size(); ++i)
      for (int a = 0; a < 2; ++a) c.u[c.layout.at(i, a)] += move(random) * (i % 7 == 0 ? 5 : 1);
  }
  EXPECT_GT(lists.searches(), 3);
  EXPECT_LT(lists.searches(), steps / 2);
}

TEST(MovingNeighbours, ABodyThatMovesAsAWholeKeepsItsLists) {
  Crowd c(10);
  sph::MovingNeighbours lists(c.start, c.layout, 2.4, 0.3);
  for (int step = 0; step < 50; ++step) {
    for (std::size_t i = 0; i < c.start.size(); ++i)
      c.u[c.layout.at(i, 0)] = 3.0 * step, c.u[c.layout.at(i, 1)] = 0.05 * std::sin(step + double(i));
    lists.update(c.u.data());
  }
  EXPECT_EQ(lists.searches(), 1);
}

TEST(MovingNeighbours, NoticesAParticleThatTheOthersHaveLeftAndAHeap) {
  Crowd c(10);
  sph::MovingNeighbours lists(c.start, c.layout, 2.4, 0.3);
  lists.update(c.u.data());
  EXPECT_FALSE(lists.loss());
  c.u[c.layout.at(99, 0)] =
      1;  // the corner moves out to (10, 10): of its seven within 2.4 it keeps (8, 9) and (9, 8), at 2.24
  c.u[c.layout.at(99, 1)] = 1;
  lists.update(c.u.data());
  ASSERT_TRUE(lists.loss());
  EXPECT_EQ(lists.loss()->particle, 99u);
  EXPECT_EQ(lists.loss()->neighbours, 2);
  EXPECT_EQ(lists.loss()->at_start, 7);
  EXPECT_EQ(lists.loss()->alone, 1u);
  for (std::size_t i = 0; i < c.start.size(); ++i)
    for (int a = 0; a < 2; ++a) c.u[c.layout.at(i, a)] = -c.start[i][std::size_t(a)];
  lists.update(c.u.data());
  EXPECT_TRUE(lists.crowded());
}

// Whatever a march that has gone wrong hands over, a call ends soon and asks for no memory.
TEST(UpdatedLagrangian, SurvivesPositionsThatAreNoNumbers) {
  const Scene scene = box_scene(Plane::stress, {0.4, 0.3, 0}, true);
  for (double wild : {nan, infinite, 1e300, 1e9, 40.0}) {
    const auto d = sph::discretize(scene, 0, classic(0.01, sph::MassRule::share));
    AlignedVector<double> u(d->layout().size, 0.0), f = u;
    d->internal_force(u.data(), u.data(), 0, f.data(), nullptr);
    const std::size_t bytes = d->bytes();
    for (int k = 1; k <= 20; ++k) {
      for (std::size_t i = 0; i < d->layout().points; ++i)
        if (i % std::size_t(k) == 0) u[d->layout().at(i, int(i % 2))] = wild * std::sin(double(i * k));
      d->internal_force(u.data(), u.data(), 1e-6, f.data(), nullptr);
    }
    EXPECT_LT(d->bytes(), 3 * bytes) << wild;
  }
}

TEST(UpdatedLagrangian, TellsOfParticlesItCannotFollow) {
  const Scene scene = box_scene(Plane::stress, {0.4, 0.3, 0}, true);
  const auto d = sph::discretize(scene, 0, classic(0.01, sph::MassRule::share));
  AlignedVector<double> u(d->layout().size, 0.0), f = u;
  const auto go = [&] {
    d->internal_force(u.data(), f.data(), 0, f.data(), nullptr);
    return d->trouble(u.data());
  };
  EXPECT_FALSE(go());
  u[d->layout().at(40, 0)] = 0.5;  // the corner flies off
  const auto loss = go();
  ASSERT_TRUE(loss);
  EXPECT_NE(loss->what.find("particle 40 has lost its neighbours: 0 of 3 are left"), std::string::npos)
      << loss->what;
  EXPECT_NEAR(loss->position[0], 0.91, 1e-12);
  for (std::size_t i = 0; i < d->layout().points; ++i)
    for (int c = 0; c < 2; ++c) u[d->layout().at(i, c)] = -d->position(i)[std::size_t(c)];
  const auto heap = go();
  ASSERT_TRUE(heap);
  EXPECT_NE(heap->what.find("one heap"), std::string::npos);
}

}  // namespace
}  // namespace femsph::test
