// The list of the options of methods.

#include <stdexcept>

#include "compare/run/plan/method_option.hpp"

namespace femsph::compare {
namespace {

template <class T>
using Words = std::vector<std::pair<std::string, T>>;

const Words<sph::KernelKind> kernels = {
    {"cubic-spline", sph::KernelKind::cubic_spline}, {"wendland-c2", sph::KernelKind::wendland_c2}};
const Words<sph::MassRule> masses = {
    {"share", sph::MassRule::share}, {"full", sph::MassRule::full}, {"trapezoid", sph::MassRule::trapezoid}};
const Words<sph::KernelVolume> kernel_volumes = {
    {"whole", sph::KernelVolume::whole}, {"own", sph::KernelVolume::own}};
const Words<sph::Dilatation> dilatations = {
    {"automatic", sph::Dilatation::automatic},
    {"local", sph::Dilatation::local},
    {"mean", sph::Dilatation::mean}};
const Words<sph::Boundary> boundaries = {
    {"none", sph::Boundary::none},
    {"virtual-particles", sph::Boundary::virtual_particles},
    {"weight", sph::Boundary::weight}};

template <class T>
std::vector<std::string> words_of(const Words<T>& words) {
  std::vector<std::string> all;
  for (const auto& [word, value] : words) all.push_back(word);
  return all;
}

template <class T>
T meaning(const Words<T>& words, const OptionValue& value) {
  for (const auto& [word, meant] : words)
    if (word == std::get<std::string>(value)) return meant;
  throw std::logic_error("no such word: " + std::get<std::string>(value));
}

sph::Options& sph_of(Method& m) { return std::get<sph::Options>(m.options); }
fem::Options& fem_of(Method& m) { return std::get<fem::Options>(m.options); }
double number(const OptionValue& value) { return std::get<double>(value); }

const sph::Formulation& formulation_of(const Method& m) {
  return sph::formulation_named(std::get<sph::Options>(m.options).formulation);
}
std::string never(const Method&) { return ""; }
std::string unless_corrected(const Method& m) {
  return formulation_of(m).corrected ? "" : "it belongs to corrected SPH";
}
std::string unless_initial(const Method& m) {
  if (!formulation_of(m).corrected) return unless_corrected(m);
  return formulation_of(m).initial_neighbours ? "" : "it belongs to sph-corrected, on initial neighbours";
}
std::string unless_classic(const Method& m) {
  return formulation_of(m).corrected ? "it belongs to classic SPH" : "";
}
std::string without_viscosity(const Method& m) {
  return formulation_of(m).viscosity ? "" : "it belongs to classic and to updated SPH";
}
std::string without_hourglass(const Method& m) {
  if (!m.is_fem()) return formulation_of(m).hourglass ? "" : "classic SPH has no hourglass control";
  return fem::element_named(std::get<fem::Options>(m.options).element).hourglass_control
             ? ""
             : "of the elements, only fem-one-point has an hourglass control";
}

/// An option of SPH alone.
MethodOption of_sph(const char* word, const char* about, std::optional<OptionRange> range,
                    std::vector<std::string> words, bool on_command_line, std::string (*idle)(const Method&),
                    void (*set)(Method&, const OptionValue&)) {
  return {word, about, range, std::move(words), false, true, on_command_line, idle, set};
}

std::vector<MethodOption> all_options() {
  const OptionRange viscosity{0, 100}, gamma{0, 100, true}, share{0, 0.5};
  return {
      of_sph("smoothing", "the smoothing length h over the spacing d (default 1)", OptionRange{0.6, 4}, {},
             true, never, [](Method& m, const OptionValue& v) { sph_of(m).smoothing = number(v); }),
      of_sph("kernel", "the kernel (default cubic-spline)", {}, words_of(kernels), true, never,
             [](Method& m, const OptionValue& v) { sph_of(m).kernel = meaning(kernels, v); }),
      of_sph("mass",
             "the mass of a particle: its share of the body, that of a full cell, or of its cell's part in "
             "the body (default: the method's)",
             {}, words_of(masses), true, never,
             [](Method& m, const OptionValue& v) { sph_of(m).mass = meaning(masses, v); }),
      of_sph("kernel_volume",
             "corrected SPH: a neighbour's volume in kernel sums: its whole cell (default), or its own, half "
             "a cell on a side",
             {}, words_of(kernel_volumes), true, unless_corrected,
             [](Method& m, const OptionValue& v) { sph_of(m).kernel_volume = meaning(kernel_volumes, v); }),
      of_sph("dilatation",
             "sph-corrected: the change of volume that the law is given: local (the particle's own), mean "
             "(over its neighbours), or automatic (default: mean where Poisson's ratio is above 0.4 or the "
             "material flows plastically, except in plane stress)",
             {}, words_of(dilatations), true, unless_initial,
             [](Method& m, const OptionValue& v) { sph_of(m).dilatation = meaning(dilatations, v); }),
      of_sph("boundary", "classic SPH: the correction for the missing neighbours beyond a surface", {},
             words_of(boundaries), false, unless_classic,
             [](Method& m, const OptionValue& v) { sph_of(m).boundary = meaning(boundaries, v); }),
      of_sph("projection",
             "sph-corrected: weights of scattered particles are projected, so that a uniform stress is exact "
             "(default "
             "true)",
             {}, {}, false, unless_initial,
             [](Method& m, const OptionValue& v) { sph_of(m).projection = std::get<bool>(v); }),
      of_sph("alpha", "classic and updated SPH: linear coefficient of the artificial viscosity (default 0)",
             viscosity, {}, false, without_viscosity,
             [](Method& m, const OptionValue& v) { sph_of(m).viscosity.alpha = number(v); }),
      of_sph("beta", "classic and updated SPH: quadratic coefficient of the artificial viscosity (default 0)",
             viscosity, {}, false, without_viscosity,
             [](Method& m, const OptionValue& v) { sph_of(m).viscosity.beta = number(v); }),
      of_sph("gamma",
             "classic and updated SPH: gamma of the artificial viscosity, which keeps it finite at small "
             "distances "
             "(default 1)",
             gamma, {}, false, without_viscosity,
             [](Method& m, const OptionValue& v) { sph_of(m).viscosity.gamma = number(v); }),
      {"hourglass",
       "coefficient of the hourglass control of sph-corrected (default 0.03), or stiffness of the bonds of "
       "sph-updated in shear moduli (default 4); fem-one-point takes Flanagan and Belytschko's "
       "control by it, instead of its physical stabilization",
       OptionRange{0, 10},
       {},
       true,
       true,
       true,
       without_hourglass,
       [](Method& m, const OptionValue& v) {
         if (m.is_fem())
           fem_of(m).hourglass = number(v);
         else
           sph_of(m).hourglass = number(v);
       }},
      of_sph("jitter", "particles moved at random by up to this share of the spacing (default 0)", share, {},
             false, never, [](Method& m, const OptionValue& v) { sph_of(m).jitter = number(v); }),
      {"distortion",
       "FEM: inner vertices moved at random by up to this share of a cell (default 0)",
       share,
       {},
       true,
       false,
       false,
       never,
       [](Method& m, const OptionValue& v) { fem_of(m).distortion = number(v); }},
  };
}

}  // namespace

const std::vector<MethodOption>& method_options() {
  static const std::vector<MethodOption> all = all_options();
  return all;
}

}  // namespace femsph::compare
