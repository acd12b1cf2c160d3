#pragma once
// Scenes of the paper, runs of them, and what is read of a run.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "compare/run/run.hpp"
#include "model/numerics/parallel.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph::test {

/// Cantilever 1000 x 100 (x 100) mm of steel, plane stress, clamped on x-, `load` N down at the corner x+ y+;
/// probe "tip" at (1000, 50) mm. `end`: the [time] table and what follows.
inline Scene cantilever(double load, const std::string& end, const std::string& poisson = "0.3") {
  using namespace scene_text;
  return parse_scene(clamped_beam("1000 100 mm", "100 mm", poisson) +
                         scene_text::load("x+ y+", fmt::format("0 {} N", -load)) +
                         probe("tip", "displacement", "1000 50 mm") + end,
                     "cantilever.toml");
}

/// Bar 300 x 100 (x 100) mm of steel, clamped on x-, 1.5 kN of compression on x+ from the first step; probes
/// "end" and "centre" (stress).
inline Scene bar(const std::string& end, const std::string& poisson = "0.3") {
  using namespace scene_text;
  return parse_scene(
      clamped_beam("300 100 mm", "100 mm", poisson) + load("x+", "-1.5 0 kN") +
          probe("end", "displacement", "300 50 mm") + probe("centre", "stress", "150 50 mm") + end,
      "bar.toml");
}

inline const std::string settle = scene_text::time("200 ms", "samples = 10\n") +
                                  scene_text::settling("damping");

/// `methods`: a method, or one for each body: "lower=fem-full,upper=sph-corrected".
inline compare::RunResult run(const Scene& scene, const std::string& methods, double spacing_mm,
                              std::array<int, 3> divisions = {}) {
  return compare::run_scene(
      scene, compare::read_body_methods(methods, &scene), {spacing_mm * 1e-3, divisions}, {});
}

inline double last(const compare::RunResult& r, const std::string& column) {
  return r.history[column].values.back();
}

/// Mean of a column between two times (s).
inline double mean(const compare::RunResult& r, const std::string& column, double from, double to) {
  const auto &t = r.history["time"].values, &x = r.history[column].values;
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (t[i] >= from && t[i] <= to) sum += x[i], ++count;
  return sum / count;
}

/// In percent.
inline double error(double value, double reference) { return 100 * (value / reference - 1); }

}  // namespace femsph::test
