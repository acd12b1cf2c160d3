#include "tests/bench/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/motion/bodies/price.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"

namespace femsph::bench {

namespace {

std::unique_ptr<Discretization> discretize(const Case& c, const Scene& scene, double spacing, bool oracle) {
  if (!oracle) return compare::discretize(scene, 0, c.method, {spacing, {}});
  fem::Options o;
  for (int a = 0; a < c.dim; ++a) o.divisions[a] = int(std::lround((a == 0 ? 1 : 0.1) / spacing));
  return fem::discretize_oracle(scene, 0, o);
}

/// A discretization and the motion it is put through:
///   elastic, idle   noise of 1e-6 of the spacing, always the same
///   tenth, all      a stretch along x of 1 % + 2e-5 a step, with a tenth of that as noise; of the first
///   tenth
///                   of the body, or of all of it
///   moving          waves; the fastest particle moves 0.01 d a step (0.02 of the wave speed), up to five
///                   spacings
class Bench {
 public:
  Bench(const Case& c, bool oracle)
      : case_(c),
        scene_(scene_of(c, spacing_)),
        body_(discretize(c, scene_, spacing_, oracle)),
        at_(body_->layout()) {
    for (AlignedVector<double>* x : {&shape_, &u_, &v_, &f_, &drift_, &kick_, &weight_})
      x->assign(at_.size, 0.0);
    if (body_->has_viscosity()) viscous_.assign(at_.size, 0.0);
    for (std::size_t i = 0; i < at_.points; ++i) {
      const Point X = body_->position(i);
      for (int k = 0; k < c.dim; ++k) {
        const double noise = spacing_ * std::sin(0.7 * double(i) + k),
                     reach = c.yield == Yield::tenth ? 0.1 : 1;
        const bool pulled = X[0] <= reach;
        if (c.moving)
          shape_[at_.at(i, k)] = 5 * spacing_ * std::sin(60 * X[std::size_t(k + 1) % std::size_t(c.dim)]);
        else if (yields())
          shape_[at_.at(i, k)] = (k == 0 ? std::min(X[0], reach) : 0.0) + (pulled ? 0.1 * noise : 0.0);
        else
          shape_[at_.at(i, k)] = noise;
        weight_[at_.at(i, k)] = 1 / body_->mass()[i];
      }
    }
    move();
    force();
  }

  /// The next place; not part of the step.
  void move() {
    const double before = factor(), dt = step_length;
    ++n_;
    const double now = factor();
    for (std::size_t i = 0; i < at_.size; ++i)
      u_[i] = now * shape_[i], v_[i] = (now - before) / dt * shape_[i];
  }
  void force() {
    body_->internal_force(u_.data(), v_.data(), n_ > 1 ? step_length : 0, f_.data(),
                          viscous_.empty() ? nullptr : viscous_.data());
  }
  /// What the march does then, on arrays of its own, so that the motion stays as prescribed.
  void kick_and_drift() {
    double* __restrict u = drift_.data(), * __restrict v = kick_.data();
    const double* __restrict f = f_.data(), * __restrict w = weight_.data();
    parallel_for(at_.size, 512, [=](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        v[i] += step_length * w[i] * f[i];
        u[i] += step_length * v[i];
      }
    });
  }
  /// Share of the material points whose plastic strain grows in a step.
  double yielding() {
    const std::vector<double> before = plastic_strain();
    if (before.empty()) return 0;
    move();
    force();
    const std::vector<double> now = plastic_strain();
    std::size_t grown = 0;
    for (std::size_t i = 0; i < now.size(); ++i) grown += now[i] > before[i];
    return double(grown) / double(now.size());
  }
  const Discretization& body() const { return *body_; }

 private:
  static constexpr double step_length = 1e-7;
  bool yields() const { return case_.yield == Yield::tenth || case_.yield == Yield::all; }
  double factor() const {
    if (case_.moving) return std::sin(0.002 * double(n_));
    return yields() ? 0.01 + 2e-5 * double(n_) : 1e-6;
  }
  std::vector<double> plastic_strain() const {
    std::vector<std::size_t> all(body_->material_points());
    std::iota(all.begin(), all.end(), std::size_t{0});
    MaterialState state;
    body_->material_state(u_.data(), all, state);
    return state.plastic;
  }

  const Case& case_;
  double spacing_ = 0;
  Scene scene_;
  std::unique_ptr<Discretization> body_;
  const Layout at_;
  AlignedVector<double> shape_, u_, v_, f_, viscous_, drift_, kick_, weight_;
  long n_ = 0;
};

void describe(benchmark::State& state, const Discretization& d) {
  state.counters["units"] = double(d.units());
  state.counters["bytes"] = double(d.bytes()) / double(d.units());
}

}  // namespace

void step(benchmark::State& state, const Case& c, bool oracle) {
  set_threads(1);
  Bench bench(c, oracle);
  double in_force = 0;
  for (auto _ : state) {
    bench.move();
    const double start = cpu_seconds();
    bench.force();
    const double middle = cpu_seconds();
    bench.kick_and_drift();
    const double end = cpu_seconds();
    in_force += middle - start;
    state.SetIterationTime(end - start);
  }
  describe(state, bench.body());
  state.counters["force"] = in_force / double(state.iterations());
  if (c.yield != Yield::elastic) state.counters["yielding"] = bench.yielding();
}

void two_threads(benchmark::State& state, const Case& c) {
  Bench bench(c, false);
  double best[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  for (auto _ : state) {
    for (const int n : {1, 2}) {
      set_threads(n);
      for (int turn = 0; turn < 4; ++turn) {
        bench.move();
        const double start = wall_seconds();
        bench.force();
        bench.kick_and_drift();
        best[n - 1] = std::min(best[n - 1], wall_seconds() - start);
      }
    }
    state.SetIterationTime(best[1]);
  }
  set_threads(1);
  describe(state, bench.body());
  state.counters["speedup"] = best[0] / best[1];
}

void march_step(benchmark::State& state, const Case& c) {
  set_threads(1);
  double spacing = 0;
  Scene scene = scene_of(c, spacing);
  if (c.yield == Yield::all) {
    const double wave_speed = std::visit(
        [](const auto& law) { return law.wave_speed(); }, scene.materials.at("steel").law(scene.plane));
    scene = scene_of(c, spacing,
                     1e-4 * wave_speed / spacing);  // a strain of about 1e-4 a step: all yields after 20
  }
  for (auto _ : state) {
    constexpr long first = 30, last = 80;  // two of these steps are watched for trouble
    scene.duration = 1;
    std::vector<std::unique_ptr<Discretization>> bodies;
    bodies.push_back(compare::discretize(scene, 0, c.method, {spacing, {}}));
    March march(scene, std::move(bodies), {});
    scene.duration = (double(last) + 0.5) * march.dt();
    double start = 0, time = 0;
    MarchEvents events;
    events.between = [&](const March& now) {
      if (now.step() == first) start = cpu_seconds();
      if (now.step() == last) time = (cpu_seconds() - start) / double(last - first);
    };
    march.run(events);
    state.SetIterationTime(time);
    describe(state, *march.bodies()[0].discretization);
    state.counters["bytes"] = double(march.price().bytes) / double(march.price().units);
  }
}

void triad(benchmark::State& state, std::size_t n) {
  set_threads(1);
  AlignedVector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  for (auto _ : state) {
    const double start = cpu_seconds();
    for (int turn = 0; turn < int(4000000 / n); ++turn) {
      for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 0.5 * c[i];
      benchmark::DoNotOptimize(a.data());
      benchmark::ClobberMemory();
    }
    state.SetIterationTime((cpu_seconds() - start) / double(4000000 / n));
  }
  state.counters["units"] = double(n);
}

}  // namespace femsph::bench
