#include "compare/reference/theory.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "model/input/faults.hpp"

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

std::vector<std::string> theory_names() {
  std::vector<std::string> names;
  for (const Theory& theory : theories()) names.push_back(theory.name);
  return names;
}

const Theory& theory_named(const std::string& name) {
  for (const Theory& theory : theories())
    if (theory.name == name) return theory;
  throw std::runtime_error(fmt::format("no theory is called {}; expected {}{}", in_quotes(name),
                                       one_of(theory_names()), did_you_mean(name, theory_names())));
}

}  // namespace femsph::compare
