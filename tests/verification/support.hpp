#pragma once
// Scenes of the paper, built in code so that a test shows what it runs.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "compare/run/run.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/reader/reader.hpp"

namespace femsph::test {

/// Cantilever 1000 x 100 (x 100) mm of steel, plane stress, clamped at x-, `load` N down on the corner x+ y+;
/// probe "tip" at (1000, 50) mm. `end`: the [time] table and what follows.
inline Scene cantilever(double load, const std::string& end, const char* support = "fix = [\"x\", \"y\"]",
                        const char* poisson = "0.3") {
  return parse_scene(fmt::format(R"(
title = "cantilever"
[model]
plane = "stress"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = {}
density = "7850 kg/m^3"
[bodies.beam]
shape = "box"
size = ["1000 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[[supports]]
at = "x-"
{}
[[loads]]
at = "x+ y+"
force = ["0 N", "{} N"]
[[probes]]
name = "tip"
quantity = "displacement"
point = ["1000 mm", "50 mm"]
{})",
                                 poisson, support, -load, end),
                     "cantilever.toml");
}

/// Bar 300 x 100 (x 100) mm of steel, clamped at x-, 1.5 kN step compression on x+; probes "end" and "centre"
/// (stress).
inline Scene bar(const std::string& end, const char* poisson = "0.3") {
  return parse_scene(fmt::format(R"(
title = "bar"
[model]
plane = "stress"
[materials.steel]
law = "elastic"
young = "210 GPa"
poisson = {}
density = "7850 kg/m^3"
[bodies.bar]
shape = "box"
size = ["300 mm", "100 mm"]
thickness = "100 mm"
material = "steel"
[[supports]]
at = "x-"
fix = ["x", "y"]
[[loads]]
at = "x+"
force = ["-1.5 kN", "0 N"]
[[probes]]
name = "end"
quantity = "displacement"
point = ["300 mm", "50 mm"]
[[probes]]
name = "centre"
quantity = "stress"
point = ["150 mm", "50 mm"]
{})",
                                 poisson, end),
                     "bar.toml");
}

inline const std::string settle =
    "[time]\nduration = \"200 ms\"\nsamples = 10\n[settling]\nmethod = \"damping\"\n";

inline compare::RunResult run(const Scene& scene, const std::string& method, double spacing_mm,
                              std::array<int, 3> divisions = {}) {
  return compare::run_scene(scene, compare::method_named(method), {spacing_mm * 1e-3, divisions}, {});
}

inline double last(const compare::RunResult& r, const std::string& column) {
  return r.history[column].values.back();
}

/// In percent.
inline double error(double value, double reference) { return 100 * (value / reference - 1); }

}  // namespace femsph::test
