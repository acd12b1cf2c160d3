// The methods: every element and every variant of an SPH formulation.

#include <fmt/format.h>

#include <stdexcept>

#include "compare/run/plan/method.hpp"
#include "compare/run/plan/run_result.hpp"
#include "model/input/faults.hpp"

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
