#include "compare/measure/curve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "model/input/faults.hpp"

namespace femsph::compare {

Curve curve_of(const Observed& observed, const RunResult& result) {
  Curve curve;
  if (!observed.scalar.empty()) {
    if (!result.scalars.contains(observed.scalar))
      throw std::runtime_error(fmt::format("this method has no {}", observed.scalar));
    return {{0.0}, {result.scalars.at(observed.scalar) / observed.unit.factor}};
  }
  const Column* column = nullptr;
  if (!observed.section.empty()) {
    const auto found = result.profiles.find(observed.section);
    if (found == result.profiles.end())
      throw std::runtime_error(
          fmt::format("the run gave no profile of the section \"{}\"", observed.section));
    curve.at = found->second.distance;
    for (const Column& c : found->second.columns)
      if (c.name == observed.component || c.name.ends_with("_" + observed.component)) column = &c;
  } else {
    const std::string name = observed.probe.empty() ? observed.column
                                                    : observed.probe + "_" + observed.component;
    if (result.history.has(name)) column = &result.history[name];
    if (result.history.has("time")) curve.at = result.history["time"].values;
  }
  const std::string& place = observed.section.empty()
                                 ? observed.probe.empty() ? observed.column : observed.probe
                                 : observed.section;
  if (column && !observed.column.empty() && !observed.si.empty() && column->unit != observed.si)
    throw std::runtime_error(fmt::format("the column {} is in {}, not in {}; expected a unit of its kind",
                                         observed.column, column->unit, observed.si));
  if (!column || column->values.empty() || column->values.size() != curve.at.size())
    throw std::runtime_error(fmt::format("the run gave no values of {} {}", place, observed.component));
  for (const double v : column->values) curve.value.push_back(v / observed.unit.factor);
  return curve;
}

Curve finite(Curve curve, const std::string& what) {
  for (std::size_t i = 0; i < curve.value.size(); ++i)
    if (!std::isfinite(curve.value[i]))
      throw std::runtime_error(
          fmt::format("{} is not a finite number in sample {} of {}", what, i + 1, curve.value.size()));
  return curve;
}

Curve within(const Curve& curve, const std::optional<std::array<double, 2>>& window) {
  if (!window) return curve;
  Curve part;
  for (std::size_t i = 0; i < curve.at.size(); ++i)
    if (curve.at[i] >= (*window)[0] && curve.at[i] <= (*window)[1])
      part.at.push_back(curve.at[i]), part.value.push_back(curve.value[i]);
  if (part.at.empty()) throw std::runtime_error("the history has no sample in the window");
  if (curve.at.size() > 1 &&
      curve.at.back() + 1.5 * (curve.at.back() - curve.at[curve.at.size() - 2]) < (*window)[1])
    throw std::runtime_error(fmt::format(
        "the history ends at {:.6g} ms, before the end of the window at {:.6g} ms", 1e3 * curve.at.back(),
        1e3 * (*window)[1]));
  return part;
}

const Section& section_named(const Scene& scene, const std::string& name) {
  for (const Section& section : scene.sections)
    if (section.name == name) return section;
  throw std::runtime_error(fmt::format("the scene has no section \"{}\"", name));
}

Point section_point(const Section& section, double distance) {
  const Point &a = section.from, &b = section.to;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  Point p;
  for (int c = 0; c < 3; ++c) p[c] = a[c] + (b[c] - a[c]) * distance / length;
  return p;
}

ReadAt read_at(const Observed& observed, const Scene& scene) {
  for (const Section& section : scene.sections)
    if (!observed.section.empty() && section.name == observed.section)
      return {section.body, section.quantity};
  for (const Probe& probe : scene.probes)
    if (!observed.probe.empty() && probe.name == observed.probe) return {probe.body, probe.quantity};
  throw std::runtime_error(fmt::format(
      "the scene has no probe or section {}",
      in_quotes(observed.section.empty() ? observed.probe : observed.section)));
}

}  // namespace femsph::compare
