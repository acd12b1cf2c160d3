#include "compare/reference/theory.hpp"

#include <stdexcept>

#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"

namespace femsph::compare {

const std::vector<Theory>& theories() {
  static const std::vector<Theory> list = [] {
    std::vector<Theory> all;
    for (const auto& values :
         {bar_values, return_path_values, impact_values, plastic_moment_values, cantilever_values}) {
      const std::vector<Theory> some = values();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return list;
}

const Theory& theory_named(const std::string& name) {
  return entry_named<std::runtime_error>(
      theories(), name, &Theory::name, "no theory is called " + in_quotes(name));
}

}  // namespace femsph::compare
