#include "compare/program/manual.hpp"
#include "compare/run/plan/method.hpp"
#include "compare/run/plan/overrides.hpp"
#include "model/scene/scene.hpp"

namespace femsph::compare {
namespace {

template <class T>
std::vector<std::string> names_of(const Words<T>& words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.push_back(word.first);
  return names;
}

}  // namespace

OptionWords option_words() {
  std::vector<std::string> every;
  for (const Method& method : methods()) every.push_back(method.name);
  std::vector<std::string> solvers = {"sph", "fem"};
  solvers.insert(solvers.end(), every.begin(), every.end());
  return {{"--solver", solvers},
          {"--methods", every},
          {"--kernel", names_of(kernel_words)},
          {"--mass", names_of(mass_words)},
          {"--kernel-volume", names_of(kernel_volume_words)},
          {"--dilatation", names_of(dilatation_words)},
          {"--integration", names_of(integrations())},
          {"--plane", {"stress", "strain", "none"}},
          {"--reduce", {"final", "peak", "mean"}},
          {"--completion", {"bash"}}};
}

}  // namespace femsph::compare
