#include "compare/measure/limit_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/measure/reductions.hpp"
#include "model/input/faults.hpp"
#include "model/scene/quantities/quantity.hpp"

namespace femsph::compare {
namespace {

/// Index of a component in the values of the static limit, which have all components of three dimensions.
std::size_t component_index(const Observed& observed, const Scene& scene) {
  const auto names = component_names(*read_at(observed, scene).quantity, 3);
  const auto found = std::find(names.begin(), names.end(), observed.component);
  if (found == names.end())
    throw std::runtime_error(
        fmt::format("the component is {}; expected {}", in_quotes(observed.component), one_of(names)));
  return found - names.begin();
}

}  // namespace

Curve limit_profile(const Observed& observed, const Scene& scene,
                    const std::vector<std::vector<double>>& points) {
  const Section& section = section_named(scene, observed.section);
  const Point &a = section.from, &b = section.to;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const std::size_t c = component_index(observed, scene);
  Curve curve;
  for (std::size_t i = 0; i < points.size(); ++i) {
    curve.at.push_back(length * double(i) / double(points.size() - 1));
    curve.value.push_back(points[i].at(c));
  }
  return curve;
}

std::optional<double> limit_value(const QuantitySpec& quantity, const Scene& scene,
                                  const fem::StaticLimit& limit) {
  if (!scene.settling) return {};
  const Observed& observed = quantity.observed;
  if (const auto section = limit.sections.find(observed.section); section != limit.sections.end()) {
    const Curve curve = limit_profile(observed, scene, section->second);
    const Section& line = section_named(scene, observed.section);
    if (quantity.reduce == Reduce::moment) return moment(curve, line, scene) / observed.unit.factor;
    return curve.value[fibre(line, curve.value.size(), quantity.reduce)] / observed.unit.factor;
  }
  const auto probe = limit.probes.find(observed.probe);
  if (probe == limit.probes.end() || quantity.reduce != Reduce::final) return {};
  return probe->second.at(component_index(observed, scene)) / observed.unit.factor;
}

std::optional<LimitChange> change_of(const QuantitySpec& quantity, const Scene& scene,
                                     const fem::StaticLimit& from, const fem::StaticLimit& to) {
  if (quantity.reduce != Reduce::l2) {
    const auto a = limit_value(quantity, scene, from), b = limit_value(quantity, scene, to);
    return a && b ? std::optional(LimitChange{std::abs(*b - *a), std::abs(*b)}) : std::nullopt;
  }
  const auto a = from.sections.find(quantity.observed.section),
             b = to.sections.find(quantity.observed.section);
  if (!scene.settling || a == from.sections.end() || b == to.sections.end()) return {};
  Observed si = quantity.observed;
  si.unit = {"", 1};
  const Curve before = limit_profile(si, scene, a->second), after = limit_profile(si, scene, b->second);
  double change = 0, size = 0;
  for (std::size_t i = 0; i < after.value.size(); ++i)
    change += std::pow(after.value[i] - before.value.at(i), 2), size += std::pow(after.value[i], 2);
  return LimitChange{std::sqrt(change), std::sqrt(size)};
}

}  // namespace femsph::compare
