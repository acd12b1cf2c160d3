#include "compare/measure/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "compare/measure/errors.hpp"
#include "compare/reference/theory.hpp"
#include "model/input/faults.hpp"
#include "model/results/recorder.hpp"
#include "model/scene/singular.hpp"

namespace femsph::compare {
namespace {

bool of_section(Reduce reduce) {
  return reduce == Reduce::fibre_upper || reduce == Reduce::fibre_lower || reduce == Reduce::l2 ||
         reduce == Reduce::moment;
}

/// What a probe or a section reads, and of which body: never taken to be the first.
struct ReadAt {
  std::size_t body;
  const Quantity* quantity;
};
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

/// Where a component is in the values of the static limit, which are those of space.
std::size_t component_index(const Observed& observed, const Scene& scene) {
  const auto names = component_names(*read_at(observed, scene).quantity, 3);
  const auto found = std::find(names.begin(), names.end(), observed.component);
  if (found == names.end())
    throw std::runtime_error(
        fmt::format("the component is {}; expected {}", in_quotes(observed.component), one_of(names)));
  return found - names.begin();
}

// The end of the section that is higher (lower) along y.
std::size_t fibre(const Section& section, std::size_t points, Reduce reduce) {
  if (section.to[1] == section.from[1])
    throw std::runtime_error(fmt::format(
        "the section {} runs at one height, so that it has no upper and no lower end",
        in_quotes(section.name)));
  const bool rises = section.to[1] >= section.from[1];
  return rises == (reduce == Reduce::fibre_upper) ? points - 1 : 0;
}

double integral_of(const Curve& curve) {
  if (curve.at.size() < 2)
    throw std::runtime_error(
        "one sample has no integral over time; expected a longer window or more samples");
  double integral = 0;
  for (std::size_t i = 1; i < curve.at.size(); ++i)
    integral += (curve.at[i] - curve.at[i - 1]) * (curve.value[i] + curve.value[i - 1]) / 2;
  return integral;
}

/// From the first to the last value that is not zero.
double duration_of(const Curve& curve) {
  std::optional<double> from;
  double to = 0;
  for (std::size_t i = 0; i < curve.at.size(); ++i)
    if (curve.value[i] != 0) from = from.value_or(curve.at[i]), to = curve.at[i];
  if (!from) throw std::runtime_error("the history is zero at all times, so it has no duration");
  if (curve.value.back() != 0)
    throw std::runtime_error("the history is not zero at its end, so that its duration is not known");
  if (to == *from)
    throw std::runtime_error(
        "the history is not zero in one sample only, which tells no duration; expected more samples");
  return to - *from;
}

double mean(const Curve& curve) {
  if (curve.at.size() == 1) return curve.value[0];
  const double integral = integral_of(curve);
  const double span = curve.at.back() - curve.at.front();
  return span > 0 ? integral / span : curve.value.back();
}

/// Integral of sigma_xx (y - y0) over the section's area, trapezoid along its line; across it the width of
/// the body that the section names.
double moment(const Curve& curve, const Section& section, const Scene& scene) {
  const Body& body = scene.bodies[section.body];
  if (section.quantity != quantity_named("stress") || section.from[0] != section.to[0] ||
      section.from[2] != section.to[2])
    throw std::runtime_error(
        fmt::format("a moment is of a section of stress along y, and {} is none", in_quotes(section.name)));
  if (scene.dim() == 3 && !body.shape->is_box())
    throw std::runtime_error(fmt::format(
        "a moment in space is of a box, whose width is known, and body {} is none", in_quotes(body.name)));
  const double middle = 0.5 * (curve.at.front() + curve.at.back());
  double sum = 0;
  for (std::size_t i = 1; i < curve.at.size(); ++i)
    sum += 0.5 * (curve.at[i] - curve.at[i - 1]) *
           (curve.value[i] * (curve.at[i] - middle) + curve.value[i - 1] * (curve.at[i - 1] - middle));
  if (section.to[1] < section.from[1]) sum = -sum;  // the same moment whichever end the section starts from
  return sum * (scene.dim() == 2 ? body.thickness : body.shape->upper()[2] - body.shape->lower()[2]);
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
        "the history ends at {:.6g} ms, within the window that goes on to {:.6g} ms", 1e3 * curve.at.back(),
        1e3 * (*window)[1]));
  return part;
}

/// A value that is no number would fall out of a largest or a mean without a word.
Curve finite(Curve curve, const std::string& what) {
  for (std::size_t i = 0; i < curve.value.size(); ++i)
    if (!std::isfinite(curve.value[i]))
      throw std::runtime_error(
          fmt::format("{} is not a finite number in sample {} of {}", what, i + 1, curve.value.size()));
  return curve;
}

/// How far the equivalent stress rises above yield + H p, as a share of the yield stress: of the material of
/// the body that is read.
double excess(const QuantitySpec& quantity, const RunResult& result, const Scene& scene) {
  const ReadAt place = read_at(quantity.observed, scene), along = read_at(quantity.along, scene);
  if (place.body != along.body)
    throw std::runtime_error(fmt::format(
        "stress and plastic strain are read in two bodies, {} and {}; expected one",
        in_quotes(scene.bodies[place.body].name), in_quotes(scene.bodies[along.body].name)));
  if (place.quantity != quantity_named("equivalent_stress") ||
      along.quantity != quantity_named("plastic_strain"))
    throw std::runtime_error("excess is of an equivalent stress, along a plastic strain");
  const Material& m = scene.material_of(scene.bodies[place.body]);
  if (!m.plasticity()) throw std::runtime_error("an elastic material has no yield curve");
  if (m.plasticity()->johnson_cook)
    throw std::runtime_error("the yield curve of Johnson-Cook depends on rate and heat");
  Observed stress = quantity.observed;
  stress.unit.factor = 1;
  const Curve q = finite(within(curve_of(stress, result), quantity.window), "stress"),
              p = finite(within(curve_of(quantity.along, result), quantity.window), "plastic strain");
  double most = -m.plasticity()->yield;
  for (std::size_t i = 0; i < q.value.size(); ++i)
    most = std::max(most, q.value[i] - (m.plasticity()->yield + m.plasticity()->hardening * p.value.at(i) *
                                                                    quantity.along.unit.factor));
  return most / m.plasticity()->yield;
}

double reduce_history(const Curve& curve, Reduce reduce) {
  const auto& v = curve.value;
  switch (reduce) {
    case Reduce::max:
      return *std::max_element(v.begin(), v.end());
    case Reduce::min:
      return *std::min_element(v.begin(), v.end());
    case Reduce::peak:
      return *std::max_element(
          v.begin(), v.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
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

/// The profile of the static limit along a section, SI.
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

// Only a static state can be compared with the static limit: of a scene that settles, at its end.
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
  const bool of_time = quantity.reduce == Reduce::frequency || quantity.reduce == Reduce::period ||
                       quantity.reduce == Reduce::duration;
  if (of_time || quantity.reduce == Reduce::moment || quantity.reduce == Reduce::integral)
    observed.unit.factor = 1;  // the unit is that of the result
  const Curve curve = finite(within(curve_of(observed, result), quantity.window), quantity.name);
  double value;
  if (quantity.reduce == Reduce::moment)
    value = moment(curve, section_named(scene, observed.section), scene) / quantity.observed.unit.factor;
  else if (of_section(quantity.reduce))
    value = curve.value[fibre(section_named(scene, observed.section), curve.value.size(), quantity.reduce)];
  else
    value = reduce_history(curve, quantity.reduce);
  if (of_time || quantity.reduce == Reduce::integral) value /= quantity.observed.unit.factor;
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

std::string no_value_at(const QuantitySpec& quantity, const Scene& scene, bool certain) {
  const Observed& observed = quantity.observed;
  if ((observed.probe.empty() && observed.section.empty()) || quantity.reduce == Reduce::l2 ||
      quantity.reduce == Reduce::moment)
    return "";
  if (std::none_of(scene.probes.begin(), scene.probes.end(),
                   [&](const Probe& p) { return p.name == observed.probe; }) &&
      std::none_of(scene.sections.begin(), scene.sections.end(),
                   [&](const Section& s) { return s.name == observed.section; }))
    return "";  // said where it is read
  const ReadAt read = read_at(observed, scene);
  Scene there = scene;  // with this reading alone
  there.sections.clear();
  there.probes = {{observed.probe + observed.section, read.body, read.quantity, place_of(quantity, scene)}};
  for (const SingularPlace& place : singular_places(there))
    if (place.certain() == certain) return place.text;
  return "";
}

}  // namespace femsph::compare
