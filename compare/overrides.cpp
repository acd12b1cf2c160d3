#include "compare/overrides.hpp"

#include <fmt/format.h>

namespace femsph::compare {
namespace {

template <class T>
using Words = std::vector<std::pair<std::string, T>>;

const Words<sph::KernelKind> kernels = {{"cubic-spline", sph::KernelKind::cubic_spline}, {"wendland-c2", sph::KernelKind::wendland_c2}};
const Words<sph::MassRule> masses = {
    {"share", sph::MassRule::share}, {"full", sph::MassRule::full}, {"trapezoid", sph::MassRule::trapezoid}};
const Words<sph::Boundary> boundaries = {
    {"none", sph::Boundary::none}, {"virtual-particles", sph::Boundary::virtual_particles}, {"weight", sph::Boundary::weight}};

template <class T>
std::string word_of(const Words<T>& words, T value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  return "";
}

template <class T>
void set(const std::optional<T>& from, T& to) {
  if (from) to = *from;
}

std::optional<double> at_least(Fields& options, const char* key, double least, bool including) {
  const auto value = options.number(key, Need::optional);
  if (!value || *value > least || (including && *value == least)) return value;
  options.fault(key, fmt::format("\"{}\" is {}; expected a number {} {}", key, *value, including ? "not below" : "above", least));
  return {};
}

bool takes_hourglass(const Method& method) {
  if (const auto* fem = std::get_if<fem::Options>(&method.options)) return fem->element == fem::Element::one_point;
  return std::get<sph::Options>(method.options).formulation == sph::Formulation::corrected;
}

}  // namespace

void Overrides::apply(Method& method) const {
  if (auto* fem = std::get_if<fem::Options>(&method.options)) {
    if (hourglass) fem->hourglass = hourglass;
    set(distortion, fem->distortion);
    return;
  }
  auto& sph = std::get<sph::Options>(method.options);
  set(smoothing, sph.smoothing);
  set(kernel, sph.kernel);
  set(mass, sph.mass);
  set(boundary, sph.boundary);
  set(alpha, sph.viscosity.alpha);
  set(beta, sph.viscosity.beta);
  set(gamma, sph.viscosity.gamma);
  set(hourglass, sph.hourglass);
  set(jitter, sph.jitter);
}

std::string Overrides::describe() const {
  std::string text;
  const auto number = [&](const char* name, const std::optional<double>& value) {
    if (value) text += fmt::format(" {}={:g}", name, *value);
  };
  number("smoothing", smoothing);
  if (kernel) text += " kernel=" + word_of(kernels, *kernel);
  if (mass) text += " mass=" + word_of(masses, *mass);
  if (boundary) text += " boundary=" + word_of(boundaries, *boundary);
  number("alpha", alpha);
  number("beta", beta);
  number("gamma", gamma);
  number("hourglass", hourglass);
  number("jitter", jitter);
  number("distortion", distortion);
  return text;
}

Overrides read_overrides(Fields& options, const std::vector<Method>& methods) {
  bool any_fem = false, any_sph = false, all_hourglass = true;
  for (const Method& method : methods) {
    (method.is_fem() ? any_fem : any_sph) = true;
    all_hourglass &= takes_hourglass(method);
  }
  Overrides read;
  if (all_hourglass) read.hourglass = at_least(options, "hourglass", 0, true);
  if (!any_sph) read.distortion = at_least(options, "distortion", 0, true);
  if (!any_fem) {
    read.smoothing = at_least(options, "smoothing", 0, false);
    read.kernel = options.choice("kernel", Need::optional, kernels);
    read.mass = options.choice("mass", Need::optional, masses);
    read.boundary = options.choice("boundary", Need::optional, boundaries);
    read.alpha = at_least(options, "alpha", 0, true);
    read.beta = at_least(options, "beta", 0, true);
    read.gamma = at_least(options, "gamma", 0, false);
    read.jitter = at_least(options, "jitter", 0, true);
  }
  options.done();
  return read;
}

}  // namespace femsph::compare
