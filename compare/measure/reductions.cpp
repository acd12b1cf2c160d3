#include "compare/measure/reductions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/measure/errors.hpp"
#include "model/input/faults.hpp"
#include "model/scene/quantities/quantity.hpp"

namespace femsph::compare {
namespace {

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
    throw std::runtime_error("the history is not zero at its end, so its duration is not known");
  if (to == *from)
    throw std::runtime_error(
        "only one sample of the history is not zero, which gives no duration; expected more samples");
  return to - *from;
}

double frequency_of(const Curve& curve) {
  const auto frequency = dominant_frequency(curve.at, curve.value);
  if (!frequency) throw std::runtime_error("the history does not oscillate, so it has no frequency");
  return *frequency;
}

double mean_of(const Curve& curve) {
  if (curve.at.size() == 1) return curve.value[0];
  const double integral = integral_of(curve);
  const double span = curve.at.back() - curve.at.front();
  return span > 0 ? integral / span : curve.value.back();
}

double peak_of(const Curve& curve) {
  return *std::max_element(
      curve.value.begin(), curve.value.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
}

}  // namespace

const std::vector<Reduction>& reductions() {
  static const std::vector<Reduction> all = {
      {Reduce::final, "final", "", false, "the last value (unless \"reduce\" is given)",
       [](const Curve& c) { return c.value.back(); }},
      {Reduce::max, "max", "", false, "the largest value",
       [](const Curve& c) { return *std::max_element(c.value.begin(), c.value.end()); }},
      {Reduce::min, "min", "", false, "the smallest value",
       [](const Curve& c) { return *std::min_element(c.value.begin(), c.value.end()); }},
      {Reduce::peak, "peak", "", false, "the value of the largest magnitude, with its sign", peak_of},
      {Reduce::mean, "mean", "", false, "the mean over time", mean_of},
      {Reduce::frequency, "frequency", "Hz", false, "the frequency of the slowest strong oscillation",
       frequency_of},
      {Reduce::period, "period", "s", false, "one over that frequency",
       [](const Curve& c) { return 1 / frequency_of(c); }},
      {Reduce::integral, "integral", "N s", false, "the integral over time, of a force", integral_of},
      {Reduce::duration, "duration", "s", false,
       "the time from the first to the last value that is not zero, such as that of a contact", duration_of},
      {Reduce::fibre_upper, "fibre_upper", "", true, "the value at the upper end of a section (along y)", {}},
      {Reduce::fibre_lower, "fibre_lower", "", true, "the value at the lower end of a section (along y)", {}},
      {Reduce::l2,
       "l2",
       "1",
       true,
       "the distance of a section's profile from theory or limit, or of a probe's history from theory or "
       "\"reference_file\", in the L2 norm, in percent of the norm of what it is compared with",
       {}},
      {Reduce::moment,
       "moment",
       "N m",
       true,
       "the bending moment of a section of stress along y about its middle, the integral of sigma_xx (y - "
       "y0) "
       "over its area",
       {}},
      {Reduce::excess,
       "excess",
       "",
       false,
       "the largest amount by which an equivalent stress lies above its yield curve, yield + H p, in percent "
       "of the yield stress",
       {}}};
  return all;
}

const Reduction& reduction_of(Reduce kind) {
  for (const Reduction& reduction : reductions())
    if (reduction.kind == kind) return reduction;
  throw std::logic_error("a reduction is missing in its catalogue");
}

std::vector<std::pair<std::string, Reduce>> reduction_words() {
  std::vector<std::pair<std::string, Reduce>> all;
  for (const Reduction& reduction : reductions()) all.emplace_back(reduction.word, reduction.kind);
  return all;
}

std::vector<Entry> reduction_entries() {
  std::vector<Entry> all;
  for (const Reduction& reduction : reductions()) all.push_back({reduction.word, reduction.about});
  return all;
}

std::size_t fibre(const Section& section, std::size_t points, Reduce reduce) {
  if (section.to[1] == section.from[1])
    throw std::runtime_error(fmt::format(
        "the section {} runs at one height, so that it has no upper and no lower end",
        in_quotes(section.name)));
  const bool rises = section.to[1] >= section.from[1];
  return rises == (reduce == Reduce::fibre_upper) ? points - 1 : 0;
}

double moment(const Curve& curve, const Section& section, const Scene& scene) {
  const Body& body = scene.bodies[section.body];
  if (section.quantity != quantity_named("stress") || section.from[0] != section.to[0] ||
      section.from[2] != section.to[2])
    throw std::runtime_error(fmt::format(
        "a moment needs a section of stress along y, and {} is not one", in_quotes(section.name)));
  if (scene.dim() == 3 && !body.shape->is_box())
    throw std::runtime_error(fmt::format(
        "a moment in three dimensions needs a box, and body {} is not one", in_quotes(body.name)));
  const double middle = 0.5 * (curve.at.front() + curve.at.back());
  double sum = 0;
  for (std::size_t i = 1; i < curve.at.size(); ++i)
    sum += 0.5 * (curve.at[i] - curve.at[i - 1]) *
           (curve.value[i] * (curve.at[i] - middle) + curve.value[i - 1] * (curve.at[i - 1] - middle));
  if (section.to[1] < section.from[1]) sum = -sum;  // the same moment whichever end the section starts from
  return sum * (scene.dim() == 2 ? body.thickness : body.shape->upper()[2] - body.shape->lower()[2]);
}

double excess(const QuantitySpec& quantity, const RunResult& result, const Scene& scene) {
  const ReadAt place = read_at(quantity.observed, scene), along = read_at(quantity.along, scene);
  if (place.body != along.body)
    throw std::runtime_error(fmt::format(
        "stress and plastic strain are read in two bodies, {} and {}; expected one",
        in_quotes(scene.bodies[place.body].name), in_quotes(scene.bodies[along.body].name)));
  if (place.quantity != quantity_named("equivalent_stress") ||
      along.quantity != quantity_named("plastic_strain"))
    throw std::runtime_error("excess needs an equivalent stress, along a plastic strain");
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

}  // namespace femsph::compare
