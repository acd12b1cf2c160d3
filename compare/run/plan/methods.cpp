// The methods: every element and every variant of an SPH formulation.

#include <stdexcept>

#include "compare/run/plan/method.hpp"
#include "compare/run/plan/run_result.hpp"
#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"

namespace femsph::compare {

namespace {

std::vector<Method> all_methods() {
  std::vector<Method> all;
  for (const fem::ElementEntry& element : fem::elements()) {
    fem::Options options;
    options.element = element.word;
    all.push_back({std::string("fem-") + element.word, options, element.about});
  }
  for (const sph::Formulation& formulation : sph::formulations())
    for (const sph::Variant& variant : formulation.variants)
      all.push_back({std::string("sph-") + variant.word, variant.options, variant.about});
  return all;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all = all_methods();
  return all;
}

Method method_named(const std::string& name) {
  return entry_named<std::runtime_error>(methods(), name, &Method::name, "no method " + in_quotes(name));
}

const std::vector<std::pair<std::string, std::string>>& run_scalars() {
  static const std::vector<std::pair<std::string, std::string>> list = {
      {"surface_weight_loss", "1"}, {"critical_step", "s"},          {"energy_drift", "1"},
      {"momentum_drift", "1"},      {"angular_momentum_drift", "1"}, {"hourglass_share", "1"},
      {"mass_error", "1"},          {"centroid_error", "1"}};
  return list;
}

}  // namespace femsph::compare
