#include "compare/measure/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/measure/errors.hpp"
#include "compare/measure/limit_value.hpp"
#include "compare/measure/reductions.hpp"
#include "compare/reference/theory.hpp"
#include "model/scene/singular.hpp"

namespace femsph::compare {
namespace {

double signed_as(double value, SignRule rule) {
  return rule == SignRule::as_is ? value : rule == SignRule::reversed ? -value : std::abs(value);
}

/// The point at which the theory value is evaluated, m.
Point place_of(const QuantitySpec& quantity, const Scene& scene) {
  const Observed& observed = quantity.observed;
  if (!observed.section.empty() && quantity.reduce == Reduce::moment)
    return section_named(scene, observed.section).from;
  if (!observed.section.empty()) {
    const Section& section = section_named(scene, observed.section);
    return fibre(section, 2, quantity.reduce) == 0 ? section.from : section.to;
  }
  for (const Probe& probe : scene.probes)
    if (probe.name == observed.probe) return probe.point;
  return {};
}

/// The distance of a whole history from a table or from theory.
Reduced history_l2(const QuantitySpec& quantity, const Curve& curve, const Scene& scene) {
  if (quantity.table) {
    const double percent = percent_from(*quantity.table, curve.at, curve.value);
    return {percent, {}, percent, {}, {}};
  }
  const Theory& theory = theory_named(*quantity.theory);
  const Point at = place_of(quantity, scene);
  std::vector<double> exact;
  for (const double time : curve.at) exact.push_back(theory.value(scene, at, time));
  Reduced reduced{};
  reduced.error_percent = percent_l2(curve.at, curve.value, exact);
  if (!reduced.error_percent) throw std::runtime_error("the history to compare with is zero");
  reduced.value = *reduced.error_percent;
  return reduced;
}

Reduced reduce_l2(const QuantitySpec& quantity, const RunResult& result, const Scene& scene,
                  const fem::StaticLimit* limit) {
  Observed si = quantity.observed;
  si.unit = {"", 1};
  if (!si.probe.empty())
    return history_l2(quantity, finite(within(curve_of(si, result), quantity.window), "the history"), scene);
  const Curve curve = finite(curve_of(si, result), "the profile");
  const Section& section = section_named(scene, si.section);
  Reduced reduced{};
  if (quantity.theory) {
    std::vector<double> exact;
    for (const double distance : curve.at)
      exact.push_back(theory_named(*quantity.theory).value(scene, section_point(section, distance), 0));
    reduced.error_percent = percent_l2(curve.at, curve.value, exact);
    if (!reduced.error_percent)
      throw std::runtime_error(
          "the profile of theory is zero all along, so that there is no distance from it in percent");
  }
  if (limit && scene.settling && limit->sections.contains(si.section)) {
    const Curve exact = limit_profile(si, scene, limit->sections.at(si.section));
    reduced.error_vs_limit_percent = percent_l2(
        curve.at, curve.value, resample(exact.at, exact.value, curve.at));
  }
  const auto shown = reduced.error_percent ? reduced.error_percent : reduced.error_vs_limit_percent;
  if (!shown) throw std::runtime_error("the profile to compare with is zero, or missing");
  reduced.value = *shown;
  return reduced;
}

}  // namespace

Reduced reduce(const QuantitySpec& quantity, const RunResult& result, const Scene& scene,
               const fem::StaticLimit* limit) {
  if (quantity.reduce == Reduce::excess)
    return {excess(quantity, result, scene) / quantity.observed.unit.factor, {}, {}, {}, {}};
  if (quantity.reduce == Reduce::l2) {
    const Reduced reduced = reduce_l2(quantity, result, scene, limit);
    if (!std::isfinite(reduced.value))
      throw std::runtime_error(fmt::format("{} is not a finite number", quantity.name));
    return reduced;
  }
  Observed observed = quantity.observed;
  const Reduction& reduction = reduction_of(quantity.reduce);
  const bool unit_is_of_result = *reduction.unit != '\0';
  if (unit_is_of_result) observed.unit.factor = 1;
  const Curve curve = finite(within(curve_of(observed, result), quantity.window), quantity.name);
  double value;
  if (quantity.reduce == Reduce::moment)
    value = moment(curve, section_named(scene, observed.section), scene);
  else if (reduction.of_section)
    value = curve.value[fibre(section_named(scene, observed.section), curve.value.size(), quantity.reduce)];
  else
    value = reduction.of_history(curve);
  if (unit_is_of_result) value /= quantity.observed.unit.factor;
  if (!std::isfinite(value))
    throw std::runtime_error(fmt::format("{} is not a finite number", quantity.name));

  Reduced reduced{signed_as(value, quantity.sign) + quantity.offset, {}, {}, {}, {}};
  if (quantity.theory) {
    const double exact = theory_named(*quantity.theory).value(scene, place_of(quantity, scene), 0) /
                         quantity.observed.unit.factor;
    reduced.theory = signed_as(exact, quantity.sign);
  }
  if (quantity.reference) reduced.theory = quantity.reference;
  if (reduced.theory) reduced.error_percent = percent_error(reduced.value, *reduced.theory);
  if (limit) reduced.limit = limit_value(quantity, scene, *limit);
  if (reduced.limit) {
    reduced.limit = signed_as(*reduced.limit, quantity.sign);
    reduced.error_vs_limit_percent = percent_error(reduced.value, *reduced.limit);
  }
  return reduced;
}

std::string no_value_at(const QuantitySpec& quantity, const Scene& scene, bool certain) {
  const Observed& observed = quantity.observed;
  if ((observed.probe.empty() && observed.section.empty()) || quantity.reduce == Reduce::l2 ||
      quantity.reduce == Reduce::moment)
    return "";
  if (std::none_of(scene.probes.begin(), scene.probes.end(),
                   [&](const Probe& p) { return p.name == observed.probe; }) &&
      std::none_of(scene.sections.begin(), scene.sections.end(),
                   [&](const Section& s) { return s.name == observed.section; }))
    return "";  // reported where it is read
  const ReadAt read = read_at(observed, scene);
  Scene there = scene;  // with this probe alone
  there.sections.clear();
  there.probes = {{observed.probe + observed.section, read.body, read.quantity, place_of(quantity, scene)}};
  for (const SingularPlace& place : singular_places(there))
    if (place.certain() == certain) return place.text;
  return "";
}

}  // namespace femsph::compare
