#include <fmt/format.h>

#include <stdexcept>

#include "compare/run.hpp"
#include "model/scene/faults.hpp"

namespace femsph::compare {

namespace {

Method fem_method(const char* name, fem::Element element) {
  fem::Options o;
  o.element = element;
  return {name, o};
}

Method classic(const char* name, sph::MassRule mass, sph::Boundary boundary = sph::Boundary::none) {
  sph::Options o;
  o.formulation = sph::Formulation::classic;
  o.mass = mass;
  o.boundary = boundary;
  return {name, o};
}

}  // namespace

const std::vector<Method>& methods() {
  using sph::Boundary, sph::MassRule;
  static const std::vector<Method> all{
      fem_method("fem-full", fem::Element::full),
      fem_method("fem-sri", fem::Element::sri),
      fem_method("fem-one-point", fem::Element::one_point),
      fem_method("fem-assumed-strain", fem::Element::assumed_strain),
      classic("sph-classic-share", MassRule::share),
      classic("sph-classic-full", MassRule::full),
      classic("sph-classic-trapezoid", MassRule::trapezoid),
      // Of the three mass rules these two come nearest to the paper's figs 5 to 10: studies/uniaxial and studies/boundary.
      classic("sph-virtual", MassRule::trapezoid, Boundary::virtual_particles),
      classic("sph-weight", MassRule::share, Boundary::weight),
      {"sph-corrected", sph::Options{}},
  };
  return all;
}

Method method_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Method& m : methods()) {
    if (m.name == name) return m;
    names.push_back(m.name);
  }
  throw std::runtime_error(fmt::format("no method {}; expected {}{}", in_quotes(name), one_of(names), did_you_mean(name, names)));
}

const std::vector<std::pair<std::string, std::string>>& run_scalars() {
  static const std::vector<std::pair<std::string, std::string>> list = {{"surface_weight_loss", "1"}, {"critical_step", "s"}, {"energy_drift", "1"},
                                                                        {"momentum_drift", "1"}, {"angular_momentum_drift", "1"}, {"hourglass_share", "1"},
                                                                        {"mass_error", "1"}, {"centroid_error", "1"}};
  return list;
}

}  // namespace femsph::compare
