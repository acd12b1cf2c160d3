// Counts instructions, under valgrind --tool=callgrind, of the same steps done in different ways.
// tests/bench/instructions runs it and reads the counts. Built for x86-64-v3: valgrind does not know AVX-512.
//
//   bare    the internal force of the discretization and a leap-frog of ten lines here: nothing else
//   march   the march of the product, of a scene that names no effect
//   .. off  the same with an effect declared, and set to zero
//   .. on   the same with the effect: the count must grow
//
// The 15 steps that are counted contain neither a check of the state (every 25th step) nor a sample.

#include <valgrind/callgrind.h>

#include <cmath>
#include <functional>
#include <iostream>

#include "fem/fem.hpp"
#include "model/motion/march.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/reader/reader.hpp"
#include "sph/sph.hpp"

namespace {

using namespace femsph;

constexpr int first = 30, last = 45;
using Make = std::function<std::unique_ptr<Discretization>(const Scene&)>;

/// After each step: the steps from `first` to `last` are counted.
void note(long step, const std::string& label) {
  if (step == first) {
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
  } else if (step == last) {
    CALLGRIND_DUMP_STATS_AT(label.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
  }
}

/// A cantilever of steel; `more` are further lines, `material` and `model` those of their tables.
Scene scene_with(const std::string& more = "", const std::string& material = "",
                 const std::string& model = "") {
  Scene s = parse_scene(R"(title = "A cantilever"
[bodies.beam]
shape = "box"
size = ["400 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[[loads]]
at = "x+"
force = ["0 N", "-10 kN"]
[time]
duration = "1 s"
[model]
plane = "stress"
)" + model + R"(
[materials.steel]
young = "210 GPa"
poisson = 0.3
density = "7850 kg/m^3"
)" + (material.empty() ? "law = \"elastic\"" : material) +
                            R"(
[[supports]]
at = "x-"
fix = ["x", "y"]
)" + more,
                        "instructions.toml");
  s.samples = s.snapshots = 0;
  return s;
}

double march(const std::string& label, const Make& make, Scene scene) {
  std::vector<std::unique_ptr<Discretization>> bodies;
  bodies.push_back(make(scene));
  March m(scene, std::move(bodies), {});
  scene.duration = (last + 2.5) * m.dt();
  MarchEvents events;
  events.between = [&](const March& now) { note(now.step(), label); };
  m.run(events);
  return m.dt();
}

void bare(const std::string& label, const Make& make, const Scene& scene, double dt) {
  const auto body = make(scene);
  const Layout& at = body->layout();
  AlignedVector<double> u(at.size, 0.0), v(at.size, 0.0), f(at.size, 0.0), load(at.size, 0.0),
      inverse_mass(at.size, 0.0);
  for (std::size_t i = 0; i < at.points; ++i)
    for (int c = 0; c < at.dim; ++c) inverse_mass[at.at(i, c)] = 1 / body->mass()[i];
  for (const Weight& w : body->points_of(scene.supports[0].place))
    for (int c = 0; c < at.dim; ++c) inverse_mass[at.at(w.point, c)] = 0;
  const std::vector<Weight> loaded = body->points_of(scene.loads[0].place);
  const auto force = [&] {
    body->internal_force(u.data(), v.data(), dt, f.data(), nullptr);
    for (const Weight& w : loaded) f[at.at(w.point, 1)] += w.weight * scene.loads[0].force[1];
  };
  for (int n = 1; n <= last; ++n) {
    force();
    for (std::size_t i = 0; i < at.size; ++i) {
      v[i] += dt * inverse_mass[i] * f[i];
      u[i] += dt * v[i];
    }
    note(n, label);
  }
}

void all_of(const std::string& method, const Make& make) {
  const Scene plain = scene_with();
  bare(method + ": bare", make, plain, march(method + ": march", make, plain));
  const auto with = [&](const std::string& label, const Scene& scene) {
    march(method + ": " + label, make, scene);
  };
  with("gravity off", scene_with("[gravity]\nacceleration = [\"0 m/s^2\", \"0 m/s^2\"]"));
  with("gravity on", scene_with("[gravity]\nacceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]"));
  with("moved support off", scene_with("velocity = [\"0 m/s\", \"0 m/s\"]"));
  with("moved support on", scene_with("velocity = [\"0 m/s\", \"1 mm/s\"]"));
  with("mean support off", scene_with("mode = \"each\""));
  with("mean support on", scene_with("mode = \"mean\""));
  with("load of zero", scene_with("[[loads]]\nat = \"y+\"\nforce = [\"0 N\", \"0 N\"]"));
  with("damping on", scene_with("[damping]\nrate = \"100 1/s\""));
  with("large motion off", scene_with("", "", "motion = \"small\""));
  with("large motion on", scene_with("", "", "motion = \"large\""));
  const std::string plastic = "law = \"plastic\"\nyield = \"300 GPa\"\ntangent_ratio = 0.01\n";
  with("plasticity on, nothing yields", scene_with("", plastic));
  with("tension rule off (plasticity on)",
       scene_with("", plastic + "tension = \"none\"\nintegration = \"return\""));
  with("tension rule on (plasticity on)",
       scene_with("", plastic + "tension = \"principal\"\ntensile_strength = \"200 GPa\""));
}

}  // namespace

int main() {
  set_threads(1);
  const auto fem = [](const char* element) -> Make {
    return [=](const Scene& scene) {
      fem::Options o;
      o.element = element;
      o.divisions = {60, 15, 0};
      return fem::discretize(scene, 0, o);
    };
  };
  const auto sph = [](sph::Options o) -> Make {
    o.spacing = 0.1 / 15;
    return [=](const Scene& scene) { return sph::discretize(scene, 0, o); };
  };
  all_of("fem-full", fem("full"));
  all_of("fem-one-point", fem("one-point"));
  all_of("sph-corrected", sph({}));

  const Scene plain = scene_with();
  sph::Options classic;
  classic.formulation = "classic";
  march("sph-classic: march", sph(classic), plain);
  classic.viscosity = {0, 0, 1};
  march("sph-classic: viscosity off", sph(classic), plain);
  classic.viscosity = {5, 5, 1};
  march("sph-classic: viscosity on", sph(classic), plain);
  sph::Options corrected;
  corrected.hourglass = 0;
  march("sph-corrected: without hourglass control", sph(corrected), plain);
  return 0;
}
