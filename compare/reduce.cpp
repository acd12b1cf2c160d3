#include "compare/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "compare/errors.hpp"
#include "compare/theory.hpp"

namespace femsph::compare {
namespace {

bool of_section(Reduce reduce) {
  return reduce == Reduce::fibre_upper || reduce == Reduce::fibre_lower || reduce == Reduce::l2 || reduce == Reduce::moment;
}

std::size_t component_index(const std::string& component) {
  static const std::vector<std::string> vector = {"x", "y", "z"}, tensor = {"xx", "yy", "zz", "xy", "yz", "zx"};
  if (component == "equivalent") return 0;  // a scalar
  const auto& names = component.size() == 1 ? vector : tensor;
  return std::find(names.begin(), names.end(), component) - names.begin();
}

// The end of the section that is higher (lower) along y.
std::size_t fibre(const Section& section, std::size_t points, Reduce reduce) {
  const bool rises = section.to[1] >= section.from[1];
  return rises == (reduce == Reduce::fibre_upper) ? points - 1 : 0;
}

double integral_of(const Curve& curve) {
  double integral = 0;
  for (std::size_t i = 1; i < curve.at.size(); ++i) integral += (curve.at[i] - curve.at[i - 1]) * (curve.value[i] + curve.value[i - 1]) / 2;
  return integral;
}

/// From the first to the last value that is not zero.
double duration_of(const Curve& curve) {
  std::optional<double> from;
  double to = 0;
  for (std::size_t i = 0; i < curve.at.size(); ++i)
    if (curve.value[i] != 0) from = from.value_or(curve.at[i]), to = curve.at[i];
  if (!from) throw std::runtime_error("the history is zero at all times, so it has no duration");
  return to - *from;
}

double mean(const Curve& curve) {
  const double integral = integral_of(curve);
  const double span = curve.at.back() - curve.at.front();
  return span > 0 ? integral / span : curve.value.back();
}

/// Integral of sigma_xx (y - y0) over the section's area, trapezoid along its line; the body's thickness across it.
double moment(const Curve& curve, const Scene& scene) {
  const double middle = 0.5 * (curve.at.front() + curve.at.back());
  double sum = 0;
  for (std::size_t i = 1; i < curve.at.size(); ++i)
    sum += 0.5 * (curve.at[i] - curve.at[i - 1]) * (curve.value[i] * (curve.at[i] - middle) + curve.value[i - 1] * (curve.at[i - 1] - middle));
  return sum * (scene.dim() == 2 ? scene.bodies[0].thickness : scene.bodies[0].shape->upper()[2] - scene.bodies[0].shape->lower()[2]);
}

Curve within(const Curve& curve, const std::optional<std::array<double, 2>>& window) {
  if (!window) return curve;
  Curve part;
  for (std::size_t i = 0; i < curve.at.size(); ++i)
    if (curve.at[i] >= (*window)[0] && curve.at[i] <= (*window)[1]) part.at.push_back(curve.at[i]), part.value.push_back(curve.value[i]);
  if (part.at.empty()) throw std::runtime_error("the history has no sample in the window");
  return part;
}

/// How far the equivalent stress rises above yield + H p, as a share of the yield stress.
double excess(const QuantitySpec& quantity, const RunResult& result, const Scene& scene) {
  const Material& m = scene.material_of(scene.bodies[0]);
  if (!m.plasticity) throw std::runtime_error("an elastic material has no yield curve");
  if (m.plasticity->johnson_cook) throw std::runtime_error("the yield curve of Johnson-Cook depends on rate and heat");
  Observed stress = quantity.observed;
  stress.unit.factor = 1;
  const Curve q = curve_of(stress, result), p = curve_of(quantity.along, result);
  double most = -m.plasticity->yield;
  for (std::size_t i = 0; i < q.value.size(); ++i)
    most = std::max(most, q.value[i] - (m.plasticity->yield + m.plasticity->hardening * p.value[i] * quantity.along.unit.factor));
  return most / m.plasticity->yield;
}

double reduce_history(const Curve& curve, Reduce reduce) {
  const auto& v = curve.value;
  switch (reduce) {
    case Reduce::max:
      return *std::max_element(v.begin(), v.end());
    case Reduce::min:
      return *std::min_element(v.begin(), v.end());
    case Reduce::peak:
      return *std::max_element(v.begin(), v.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    case Reduce::mean:
      return mean(curve);
    case Reduce::integral:
      return integral_of(curve);
    case Reduce::duration:
      return duration_of(curve);
    case Reduce::frequency:
    case Reduce::period:
      break;
    default:
      return v.back();
  }
  const auto frequency = dominant_frequency(curve.at, v);
  if (!frequency) throw std::runtime_error("the history does not swing back, so it has no frequency");
  return reduce == Reduce::period ? 1 / *frequency : *frequency;
}

double signed_as(double value, SignRule rule) {
  return rule == SignRule::as_is ? value : rule == SignRule::reversed ? -value : std::abs(value);
}

// Only a static state can be compared with the static limit.
std::optional<double> limit_value(const QuantitySpec& quantity, const Scene& scene, const fem::StaticLimit& limit) {
  const Observed& observed = quantity.observed;
  const std::size_t c = component_index(observed.component);
  if (const auto section = limit.sections.find(observed.section); section != limit.sections.end()) {
    const auto& points = section->second;
    return points.at(fibre(section_named(scene, observed.section), points.size(), quantity.reduce)).at(c) / observed.unit.factor;
  }
  const auto probe = limit.probes.find(observed.probe);
  if (probe == limit.probes.end() || quantity.reduce != Reduce::final) return {};
  return probe->second.at(c) / observed.unit.factor;
}

Point place_of(const QuantitySpec& quantity, const Scene& scene) {
  const Observed& observed = quantity.observed;
  if (!observed.section.empty()) {
    const Section& section = section_named(scene, observed.section);
    return fibre(section, 2, quantity.reduce) == 0 ? section.from : section.to;
  }
  for (const Probe& probe : scene.probes)
    if (probe.name == observed.probe) return probe.point;
  return {};
}

// The distance of a whole history from theory.
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

Reduced reduce_l2(const QuantitySpec& quantity, const RunResult& result, const Scene& scene, const fem::StaticLimit* limit) {
  Observed si = quantity.observed;
  si.unit = {"", 1};
  if (!si.probe.empty()) return history_l2(quantity, within(curve_of(si, result), quantity.window), scene);
  const Curve curve = curve_of(si, result);
  const Section& section = section_named(scene, si.section);
  Reduced reduced{};
  if (quantity.theory) {
    std::vector<double> exact;
    for (const double distance : curve.at)
      exact.push_back(theory_named(*quantity.theory).value(scene, section_point(section, distance), 0));
    reduced.error_percent = percent_l2(curve.at, curve.value, exact);
  }
  if (limit && limit->sections.contains(si.section)) {
    std::vector<double> distance, value;
    const auto& points = limit->sections.at(si.section);
    const Point &a = section.from, &b = section.to;
    const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      distance.push_back(length * double(i) / double(points.size() - 1));
      value.push_back(points[i].at(component_index(si.component)));
    }
    reduced.error_vs_limit_percent = percent_l2(curve.at, curve.value, resample(distance, value, curve.at));
  }
  const auto shown = reduced.error_percent ? reduced.error_percent : reduced.error_vs_limit_percent;
  if (!shown) throw std::runtime_error("the profile to compare with is zero, or missing");
  reduced.value = *shown;
  return reduced;
}

}  // namespace

Curve curve_of(const Observed& observed, const RunResult& result) {
  Curve curve;
  if (!observed.scalar.empty()) {
    if (!result.scalars.contains(observed.scalar)) throw std::runtime_error(fmt::format("this method has no {}", observed.scalar));
    return {{0.0}, {result.scalars.at(observed.scalar) / observed.unit.factor}};
  }
  const Column* column = nullptr;
  if (!observed.section.empty()) {
    const auto found = result.profiles.find(observed.section);
    if (found == result.profiles.end())
      throw std::runtime_error(fmt::format("the run gave no profile of the section \"{}\"", observed.section));
    curve.at = found->second.distance;
    for (const Column& c : found->second.columns)
      if (c.name == observed.component || c.name.ends_with("_" + observed.component)) column = &c;
  } else {
    const std::string name = observed.probe.empty() ? observed.column : observed.probe + "_" + observed.component;
    if (result.history.has(name)) column = &result.history[name];
    if (result.history.has("time")) curve.at = result.history["time"].values;
  }
  const std::string& place = observed.section.empty() ? observed.probe.empty() ? observed.column : observed.probe : observed.section;
  if (!column || column->values.empty() || column->values.size() != curve.at.size())
    throw std::runtime_error(fmt::format("the run gave no values of {} {}", place, observed.component));
  for (const double v : column->values) curve.value.push_back(v / observed.unit.factor);
  return curve;
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

Reduced reduce(const QuantitySpec& quantity, const RunResult& result, const Scene& scene, const fem::StaticLimit* limit) {
  if (quantity.reduce == Reduce::excess) return {excess(quantity, result, scene) / quantity.observed.unit.factor, {}, {}, {}, {}};
  if (quantity.reduce == Reduce::l2) return reduce_l2(quantity, result, scene, limit);
  Observed observed = quantity.observed;
  const bool of_time = quantity.reduce == Reduce::frequency || quantity.reduce == Reduce::period || quantity.reduce == Reduce::duration;
  if (of_time || quantity.reduce == Reduce::moment || quantity.reduce == Reduce::integral) observed.unit.factor = 1;  // the unit is that of the result
  const Curve curve = within(curve_of(observed, result), quantity.window);
  double value;
  if (quantity.reduce == Reduce::moment)
    value = moment(curve, scene) / quantity.observed.unit.factor;
  else if (of_section(quantity.reduce))
    value = curve.value[fibre(section_named(scene, observed.section), curve.value.size(), quantity.reduce)];
  else
    value = reduce_history(curve, quantity.reduce);
  if (of_time || quantity.reduce == Reduce::integral) value /= quantity.observed.unit.factor;
  if (!std::isfinite(value)) throw std::runtime_error(fmt::format("{} is not a finite number", quantity.name));

  Reduced reduced{signed_as(value, quantity.sign) + quantity.offset, {}, {}, {}, {}};
  if (quantity.theory) {
    const double exact = theory_named(*quantity.theory).value(scene, place_of(quantity, scene), 0) / quantity.observed.unit.factor;
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

}  // namespace femsph::compare
