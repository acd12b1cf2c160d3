// Time of one force evaluation (gradient, law, divergence) and of one whole step, for every method, per particle or element.
// The triad a = b + s c of the same run tells what the machine's memory gives, so that every figure is also a ratio.
// `bench --markdown FILE` writes the table of tests/bench/README.md.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iostream>
#include <map>

#include "compare/run.hpp"
#include "model/numerics/array.hpp"
#include "model/numerics/parallel.hpp"
#include "model/results/record.hpp"

namespace {

using namespace femsph;

constexpr int threads_of_bench = 1;

/// A steel cantilever of about `cells` cells: 10 x 1 (x 1).
Scene beam(int dim, double& spacing, double cells, bool plastic = false) {
  Scene s;
  s.plane = dim == 2 ? Plane::stress : Plane::none;
  s.materials["steel"] = Material{"steel", 2.1e11, 0.3, 7850};
  if (plastic) s.materials.at("steel").plasticity = Plasticity{300e6, 2.1e9};
  s.bodies.push_back({"beam", std::make_shared<Box>(dim, Point{}, Point{1, 0.1, dim == 3 ? 0.1 : 0.0}), dim == 2 ? 0.1 : 1.0, "steel"});
  const double across = std::round(dim == 2 ? std::sqrt(cells / 10) : std::cbrt(cells / 10));
  spacing = 0.1 / across;
  Support root;
  root.place.sides = {"x-"};
  root.fixed = {true, true, true};
  s.supports.push_back(root);
  Load load;
  load.place.sides = {"x+"};
  load.force = {0, -1e4, 0};
  s.loads.push_back(load);
  return s;
}

void force(benchmark::State& state, int dim, compare::Method method, double cells, bool oracle, bool plastic = false) {
  set_threads(threads_of_bench);
  double spacing = 0;
  const Scene scene = beam(dim, spacing, cells, plastic);
  std::unique_ptr<Discretization> d;
  if (oracle) {
    fem::Options o;
    for (int a = 0; a < dim; ++a) o.divisions[a] = int(std::lround((a == 0 ? 1 : 0.1) / spacing));
    d = fem::discretize_oracle(scene, 0, o);
  } else {
    d = compare::discretize(scene, 0, method, {spacing, {}});
  }
  AlignedVector<double> u(d->layout().size, 0.0), v(u.size(), 0.0), f(u.size(), 0.0), g(d->has_viscosity() ? u.size() : 0, 0.0);
  for (std::size_t i = 0; i < d->layout().points; ++i)
    for (int c = 0; c < dim; ++c) {
      u[d->layout().at(i, c)] = 1e-6 * std::sin(0.7 * double(i) + c);
      v[d->layout().at(i, c)] = std::cos(0.3 * double(i) + c);
    }
  AlignedVector<double> other;  // a plastic body goes forth and back, a strain of about 1 % each time, so that it yields in every step
  if (plastic) {
    for (double& x : u) x *= 1e4 * spacing;
    other = u;
    for (double& x : other) x = -x;
  }
  for (auto _ : state) {
    if (plastic) std::swap(u, other);
    d->internal_force(u.data(), v.data(), 1e-9, f.data(), g.empty() ? nullptr : g.data());
    benchmark::DoNotOptimize(f.data());
    benchmark::ClobberMemory();
  }
  state.counters["units"] = double(d->units());
  state.counters["bytes"] = double(d->bytes()) / double(d->units());
}

/// Whole steps through the march, with loads, kick and drift, and no output.
void whole_step(benchmark::State& state, int dim, compare::Method method, double cells) {
  set_threads(threads_of_bench);
  double spacing = 0;
  Scene scene = beam(dim, spacing, cells);
  scene.samples = 1;
  scene.snapshots = 0;
  scene.duration = 1e-9;
  compare::RunOptions options;
  const double dt = compare::run_scene(scene, method, {spacing, {}}, options).price.dt;
  scene.duration = 40 * dt;
  compare::RunResult r;
  for (auto _ : state) {
    r = compare::run_scene(scene, method, {spacing, {}}, options);
    state.SetIterationTime(r.price.cpu / double(r.price.steps));
  }
  state.counters["units"] = double(r.price.units);
  state.counters["bytes"] = double(r.price.bytes) / double(r.price.units);
}

/// Classic SPH on updated neighbours, search included: a body of waves, its fastest particles 0.01 d a step (0.02 of the wave speed).
void moving(benchmark::State& state, int dim, double cells, bool plastic, sph::Viscosity viscosity) {
  set_threads(threads_of_bench);
  double spacing = 0;
  Scene scene = beam(dim, spacing, cells, plastic);
  scene.large_motion = true;
  compare::Method method = compare::method_named("sph-classic-share");
  std::get<sph::Options>(method.options).smoothing = 1.2;
  std::get<sph::Options>(method.options).viscosity = viscosity;
  const auto d = compare::discretize(scene, 0, method, {spacing, {}});
  const Layout& at = d->layout();
  AlignedVector<double> shape(at.size, 0.0), u(at.size, 0.0), v(at.size, 0.0), f(at.size, 0.0), g(d->has_viscosity() ? at.size : 0, 0.0);
  for (std::size_t i = 0; i < at.points; ++i)
    for (int c = 0; c < dim; ++c) shape[at.at(i, c)] = std::sin(60 * d->position(i)[std::size_t(c + 1) % std::size_t(dim)]);
  const double amplitude = 5 * spacing, turn = 0.01 / 5, dt = 1e-7;  // a(n) = 5 d sin(turn n)
  long n = 0;
  d->internal_force(u.data(), v.data(), 0, f.data(), g.empty() ? nullptr : g.data());
  for (auto _ : state) {
    ++n;
    const double now = amplitude * std::sin(turn * double(n)), then = amplitude * std::sin(turn * double(n - 1));
    for (std::size_t i = 0; i < at.size; ++i) u[i] = now * shape[i], v[i] = (now - then) / dt * shape[i];
    const double start = cpu_seconds();
    d->internal_force(u.data(), v.data(), dt, f.data(), g.empty() ? nullptr : g.data());
    state.SetIterationTime(cpu_seconds() - start);
  }
  state.counters["units"] = double(d->units());
  state.counters["bytes"] = double(d->bytes()) / double(d->units());
}

void triad(benchmark::State& state, std::size_t n) {
  AlignedVector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 0.5 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.counters["units"] = double(n);
}

/// Keeps every figure for the table, and prints as usual.
class Collector : public benchmark::ConsoleReporter {
 public:
  struct Line {
    std::string name;
    double nanoseconds, bytes, units;
  };
  std::vector<Line> lines;
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& r : runs) {
      if (r.error_occurred || r.run_type != Run::RT_Aggregate || r.aggregate_name != "median") continue;
      const double units = r.counters.at("units");
      const double time = r.run_name.function_name.find("/step") != std::string::npos ? r.real_accumulated_time : r.cpu_accumulated_time;
      lines.push_back({r.run_name.function_name, 1e9 * time / double(r.iterations) / units, r.counters.count("bytes") ? double(r.counters.at("bytes")) : 0.0, units});
    }
  }
};

std::string markdown(const std::vector<Collector::Line>& lines) {
  double memory = 0, oracle[4] = {};
  for (const auto& l : lines) {
    if (l.name == "triad/large") memory = l.nanoseconds;
    if (l.name.find("oracle") != std::string::npos) oracle[l.name[0] - '0'] = l.nanoseconds;
  }
  std::string text = fmt::format("{}, {}\n\n| case | units | ns a unit | times the triad | oracle / this | bytes a unit |\n|---|---:|---:|---:|---:|---:|\n", version_line(),
                                 [] {
                                   for (const auto& [key, value] : provenance())
                                     if (key == "processor") return value;
                                   return std::string("unknown machine");
                                 }());
  for (const auto& l : lines) {
    const bool element = l.name.find("fem") != std::string::npos;
    text += fmt::format("| {} | {:.0f} | {:.3g} | {:.1f} | {} | {} |\n", l.name, l.units, l.nanoseconds, l.nanoseconds / memory,
                        element ? fmt::format("{:.1f}", oracle[l.name[0] - '0'] / l.nanoseconds) : "", l.bytes > 0 ? fmt::format("{:.0f}", l.bytes) : "");
  }
  return text;
}

template <class F>
void add(const std::string& name, F&& f, bool manual = false) {
  auto* b = benchmark::RegisterBenchmark(name.c_str(), std::forward<F>(f));
  b->Repetitions(3)->ReportAggregatesOnly(true)->Unit(benchmark::kMicrosecond);
  if (manual) b->UseManualTime()->Iterations(3);
  else b->MinTime(0.1);
}

void register_all() {
  add("triad/cache", [](benchmark::State& s) { triad(s, 1000); });
  add("triad/large", [](benchmark::State& s) { triad(s, 4000000); });
  for (int dim : {2, 3}) {
    const std::string d = fmt::format("{}d ", dim);
    add(d + "fem oracle (FEValues)/force", [=](benchmark::State& s) { force(s, dim, {}, dim == 2 ? 1e4 : 4e3, true); });
    for (const compare::Method& m : compare::methods()) {
      const double cells = 1e5;
      add(d + m.name + "/force", [=](benchmark::State& s) { force(s, dim, m, cells, false); });
      if (m.name == "fem-full" || m.name == "sph-corrected") add(d + m.name + " plastic/force", [=](benchmark::State& s) { force(s, dim, m, cells, false, true); });
      add(d + m.name + "/step", [=](benchmark::State& s) { whole_step(s, dim, m, cells); }, true);
    }
    const auto sph = [&](const std::string& label, auto&& change, const char* base = "sph-corrected", bool plastic = false) {
      compare::Method m = compare::method_named(base);
      change(std::get<sph::Options>(m.options));
      add(d + base + " " + label + "/force", [=](benchmark::State& s) { force(s, dim, m, 1e5, false, plastic); });
    };
    sph("h = 1.2 d", [](sph::Options& o) { o.smoothing = 1.2; });
    sph("h = 1.2 d, plastic", [](sph::Options& o) { o.smoothing = 1.2; }, "sph-corrected", true);
    if (dim == 3) {
      sph("h = 1.4 d", [](sph::Options& o) { o.smoothing = 1.4; });
      sph("h = 1.4 d, plastic", [](sph::Options& o) { o.smoothing = 1.4; }, "sph-corrected", true);
    }
    sph("h = 1.2 d, irregular", [](sph::Options& o) { o.smoothing = 1.2, o.jitter = 0.2; });
    sph("without hourglass control", [](sph::Options& o) { o.hourglass = 0; });
    const auto updated = [&](const std::string& label, bool plastic, sph::Viscosity viscosity) {
      benchmark::RegisterBenchmark((d + "sph-classic updated neighbours, h = 1.2 d" + label + "/step").c_str(),
                                   [=](benchmark::State& s) { moving(s, dim, 1e5, plastic, viscosity); })
          ->Repetitions(3)->ReportAggregatesOnly(true)->Unit(benchmark::kMicrosecond)->UseManualTime()->Iterations(60);
    };
    updated("", false, {});
    updated(", with viscosity", false, {5, 5, 1});
    updated(", with viscosity, plastic", true, {5, 5, 1});
    sph("with viscosity", [](sph::Options& o) { o.viscosity = {5, 5, 1}; }, "sph-classic-share");
    sph("h = 1.2 d, with viscosity", [](sph::Options& o) { o.smoothing = 1.2, o.viscosity = {5, 5, 1}; }, "sph-classic-share");
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string file;
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], "--markdown") == 0) {
      file = argv[i + 1];
      for (int k = i; k + 2 <= argc; ++k) argv[k] = k + 2 < argc ? argv[k + 2] : nullptr;
      argc -= 2;
      break;
    }
  benchmark::Initialize(&argc, argv);
  register_all();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  if (!file.empty()) write_text(markdown(collector.lines), file);
  return 0;
}
