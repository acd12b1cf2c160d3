// The list of what can be read at a point.

#include <stdexcept>

#include "model/scene/quantities/displacement.hpp"
#include "model/scene/quantities/equivalent_stress.hpp"
#include "model/scene/quantities/plastic_strain.hpp"
#include "model/scene/quantities/pressure.hpp"
#include "model/scene/quantities/principal_stress.hpp"
#include "model/scene/quantities/strain.hpp"
#include "model/scene/quantities/stress.hpp"
#include "model/scene/quantities/velocity.hpp"

namespace femsph {

const std::vector<const Quantity*>& quantities() {
  static const std::vector<const Quantity*> all = {
      &quantity::displacement,     &quantity::velocity,       &quantity::stress,
      &quantity::strain,           &quantity::plastic_strain, &quantity::equivalent_stress,
      &quantity::principal_stress, &quantity::pressure,
  };
  return all;
}

const std::vector<std::pair<std::string, const Quantity*>>& quantity_words() {
  static const auto words = [] {
    std::vector<std::pair<std::string, const Quantity*>> all;
    for (const Quantity* q : quantities()) all.emplace_back(q->word, q);
    return all;
  }();
  return words;
}

std::vector<Entry> quantity_entries() {
  std::vector<Entry> all;
  for (const Quantity* q : quantities()) {
    std::string components;
    for (const std::string& name : component_names(*q, 3))
      components += (components.empty() ? "" : " ") + name;
    all.push_back({q->word, std::string(q->about) + " (" + q->unit + "; components " + components + ")"});
  }
  return all;
}

const Quantity* quantity_named(const std::string& word) {
  for (const Quantity* q : quantities())
    if (q->word == word) return q;
  throw std::logic_error("no quantity is called " + word);
}

std::vector<std::string> component_names(const Quantity& quantity, int dim) {
  using Components = Quantity::Components;
  if (quantity.is_scalar()) return {quantity.scalar_name};
  static const std::vector<std::string> names[] = {
      {"x", "y", "z"}, {"xx", "yy", "zz", "xy", "yz", "zx"}, {"1", "2", "3"}};
  std::vector<std::string> all = names[std::size_t(quantity.components)];
  if (dim == 2 && quantity.components == Components::vector) all.resize(2);
  if (dim == 2 && quantity.components == Components::tensor) all.resize(4);
  return all;
}

std::vector<double> values_at(const Quantity& quantity, const StateAtPoint& state, int dim) {
  const Quantity::Values values = quantity.read(state);
  const std::size_t count = component_names(quantity, dim).size();
  return {values.begin(), values.begin() + std::ptrdiff_t(count)};
}

}  // namespace femsph
