#include "compare/run/plan/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace femsph::compare {

const Words<sph::KernelKind> kernel_words = {
    {"cubic-spline", sph::KernelKind::cubic_spline}, {"wendland-c2", sph::KernelKind::wendland_c2}};
const Words<sph::MassRule> mass_words = {
    {"share", sph::MassRule::share}, {"full", sph::MassRule::full}, {"trapezoid", sph::MassRule::trapezoid}};
const Words<sph::KernelVolume> kernel_volume_words = {
    {"whole", sph::KernelVolume::whole}, {"own", sph::KernelVolume::own}};
const Words<sph::Dilatation> dilatation_words = {
    {"automatic", sph::Dilatation::automatic},
    {"local", sph::Dilatation::local},
    {"mean", sph::Dilatation::mean}};

namespace {

const Words<sph::Boundary> boundaries = {
    {"none", sph::Boundary::none},
    {"virtual-particles", sph::Boundary::virtual_particles},
    {"weight", sph::Boundary::weight}};

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

std::optional<double> read_number(Fields& options, const std::string& key) {
  const auto value = options.number(key.c_str(), Need::optional);
  const OptionRange& range = option_range(key);
  if (!value || range.holds(*value)) return value;
  options.fault(key.c_str(), fmt::format("\"{}\" is {:g}; expected {}", key, *value, range.describe()));
  return {};
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
  set(kernel_volume, sph.kernel_volume);
  set(dilatation, sph.dilatation);
  set(boundary, sph.boundary);
  set(projection, sph.projection);
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
  if (kernel) text += " kernel=" + word_of(kernel_words, *kernel);
  if (mass) text += " mass=" + word_of(mass_words, *mass);
  if (kernel_volume) text += " kernel_volume=" + word_of(kernel_volume_words, *kernel_volume);
  if (dilatation) text += " dilatation=" + word_of(dilatation_words, *dilatation);
  if (boundary) text += " boundary=" + word_of(boundaries, *boundary);
  if (projection) text += fmt::format(" projection={}", *projection);
  number("alpha", alpha);
  number("beta", beta);
  number("gamma", gamma);
  number("hourglass", hourglass);
  number("jitter", jitter);
  number("distortion", distortion);
  return text;
}

std::string OptionRange::describe() const {
  return open ? fmt::format("a number above {:g}, up to {:g}", least, most)
              : fmt::format("a number from {:g} to {:g}", least, most);
}

const OptionRange& option_range(const std::string& name) {
  static const std::vector<OptionRange> all = {
      {"smoothing", 0.6, 4, false}, {"alpha", 0, 100, false},    {"beta", 0, 100, false},
      {"gamma", 0, 100, true},      {"hourglass", 0, 10, false}, {"jitter", 0, 0.5, false},
      {"distortion", 0, 0.5, false}};
  return *std::find_if(all.begin(), all.end(), [&](const OptionRange& range) { return range.name == name; });
}

std::string why_idle(const Method& method, const std::string& option) {
  if (const auto* fem = std::get_if<fem::Options>(&method.options)) {
    if (option == "hourglass")
      return fem->element == fem::Element::one_point
                 ? ""
                 : "of the elements, only fem-one-point has an hourglass control";
    return option == "distortion" ? "" : "it is an option of SPH";
  }
  const bool classic = std::get<sph::Options>(method.options).formulation == sph::Formulation::classic;
  if (option == "distortion") return "it is an option of FEM";
  if (option == "hourglass" && classic) return "classic SPH has no hourglass control";
  if (option == "projection" && classic) return "it belongs to corrected SPH";
  const bool viscosity = option == "viscosity" || option == "alpha" || option == "beta" || option == "gamma";
  if ((option == "kernel_volume" || option == "dilatation") && classic) return "it belongs to corrected SPH";
  if ((viscosity || option == "boundary") && !classic) return "it belongs to classic SPH";
  return "";
}

Overrides read_overrides(Fields& options, const std::vector<Method>& methods) {
  bool any_fem = false, any_sph = false;
  for (const Method& method : methods) (method.is_fem() ? any_fem : any_sph) = true;
  Overrides read;
  read.hourglass = read_number(options, "hourglass");
  if (!any_sph) read.distortion = read_number(options, "distortion");
  if (!any_fem) {
    read.smoothing = read_number(options, "smoothing");
    read.kernel = options.choice("kernel", Need::optional, kernel_words);
    read.mass = options.choice("mass", Need::optional, mass_words);
    read.kernel_volume = options.choice("kernel_volume", Need::optional, kernel_volume_words);
    read.dilatation = options.choice("dilatation", Need::optional, dilatation_words);
    read.boundary = options.choice("boundary", Need::optional, boundaries);
    read.projection = options.flag("projection", Need::optional);
    read.alpha = read_number(options, "alpha");
    read.beta = read_number(options, "beta");
    read.gamma = read_number(options, "gamma");
    read.jitter = read_number(options, "jitter");
  }
  options.done();
  for (const std::string key :
       {"hourglass", "boundary", "kernel_volume", "dilatation", "projection", "alpha", "beta", "gamma"}) {
    if (!options.has(key.c_str()) || (any_fem && key != "hourglass")) continue;
    for (const Method& method : methods)
      if (const std::string why = why_idle(method, key); !why.empty()) {
        options.fault(key.c_str(), fmt::format("\"{}\" does nothing with {}: {}", key, method.name, why));
        break;
      }
  }
  return read;
}

}  // namespace femsph::compare
