#pragma once
// Scenes whose reactions, momentum and energy are added up, and sums over their histories.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compare/run/run.hpp"
#include "model/scene/reader/reader.hpp"
#include "tests/scene_text.hpp"

namespace femsph::compare::test {

inline Scene balance_scene(const std::string& text) { return parse_scene(text, "balance.toml"); }

/// A block 2 m x 1 m x 1 m of 1 GPa and 1000 kg/m^3 in plane stress, and the tables after it.
inline std::string block(const std::string& rest) {
  using namespace scene_text;
  return model("stress") + material("m", "elastic", "1 GPa", "0.3", "1000 kg/m^3") +
         box("b", "2 1 m", thick("1 m"), "m") + rest;
}
inline std::string gravity(const std::string& acceleration) {
  return "[gravity]\nacceleration = " + scene_text::list(acceleration) + "\n";
}
/// A line of a support that moves.
inline std::string velocity(const std::string& components) {
  return "velocity = " + scene_text::list(components) + "\n";
}

inline const std::vector<double>& column(const RunResult& r, const std::string& name) {
  return r.history[name].values;
}

/// Of a column of force over time, by the trapezoidal rule.
inline double impulse(const RunResult& r, const std::string& force) {
  const auto &t = column(r, "time"), &f = column(r, force);
  double sum = 0;
  for (std::size_t k = 1; k < t.size(); ++k) sum += 0.5 * (t[k] - t[k - 1]) * (f[k] + f[k - 1]);
  return sum;
}

inline double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// From the first row to the last.
inline double change(const RunResult& r, const std::string& name) {
  return column(r, name).back() - column(r, name).front();
}

}  // namespace femsph::compare::test
