#include <fmt/format.h>

#include <stdexcept>

#include "compare/run/plan/method.hpp"
#include "compare/run/plan/run_result.hpp"
#include "model/input/faults.hpp"

namespace femsph::compare {

namespace {

Method fem_method(const char* name, fem::Element element, const char* about) {
  fem::Options o;
  o.element = element;
  return {name, o, about};
}

Method classic(const char* name, const char* about, sph::MassRule mass,
               sph::Boundary boundary = sph::Boundary::none) {
  sph::Options o;
  o.formulation = sph::Formulation::classic;
  o.mass = mass;
  o.boundary = boundary;
  return {name, o, about};
}

}  // namespace

const std::vector<Method>& methods() {
  using sph::Boundary, sph::MassRule;
  sph::Options own_volume;
  own_volume.kernel_volume = sph::KernelVolume::own;
  own_volume.hourglass = 0.1;
  own_volume.projection = false;
  static const std::vector<Method> all{
      fem_method("fem-full", fem::Element::full,
                 "linear cells, full integration; too stiff in bending, and locks in volume (Poisson's ratio "
                 "near 1/2, plastic flow)"),
      fem_method("fem-sri", fem::Element::sri,
                 "selective reduced integration of the shear: bends; locks in volume as fem-full does"),
      fem_method("fem-one-point", fem::Element::one_point,
                 "one point a cell, bending and twist by a physical stabilization; does not lock, cheapest"),
      fem_method("fem-assumed-strain", fem::Element::assumed_strain,
                 "assumed strain at full integration: does not lock, and sees plastic bending inside a cell"),
      classic("sph-classic-share",
              "uncorrected gradient, as in the paper; each particle's mass is its share of the body",
              MassRule::share),
      classic(
          "sph-classic-full", "the same, with the mass of a full cell for every particle", MassRule::full),
      classic("sph-classic-trapezoid", "the same, with half cells on sides and quarters on edges",
              MassRule::trapezoid),
      // Of the three mass rules these two come nearest to the paper's figs 5 to 10: studies/uniaxial and
      // studies/boundary.
      classic("sph-virtual", "uncorrected gradient with virtual particles outside the surface",
              MassRule::trapezoid, Boundary::virtual_particles),
      classic("sph-weight", "uncorrected gradient with a weight for the missing neighbours", MassRule::share,
              Boundary::weight),
      {"sph-corrected", sph::Options{},
       "corrected gradient over whole cells, with hourglass control: exact for linear motion, second order "
       "to the surface"},
      {"sph-corrected-own-volume", own_volume,
       "the same with half cells on sides in the kernel sums: one-sided below the surface, and too soft; for "
       "comparison"},
  };
  return all;
}

Method method_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Method& m : methods()) {
    if (m.name == name) return m;
    names.push_back(m.name);
  }
  throw std::runtime_error(
      fmt::format("no method {}; expected {}{}", in_quotes(name), one_of(names), did_you_mean(name, names)));
}

const std::vector<std::pair<std::string, std::string>>& run_scalars() {
  static const std::vector<std::pair<std::string, std::string>> list = {
      {"surface_weight_loss", "1"}, {"critical_step", "s"},          {"energy_drift", "1"},
      {"momentum_drift", "1"},      {"angular_momentum_drift", "1"}, {"hourglass_share", "1"},
      {"mass_error", "1"},          {"centroid_error", "1"}};
  return list;
}

}  // namespace femsph::compare
