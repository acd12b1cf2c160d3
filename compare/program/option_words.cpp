#include <algorithm>

#include "compare/program/manual.hpp"
#include "compare/run/plan/method_option.hpp"
#include "model/scene/scene.hpp"

namespace femsph::compare {

OptionWords option_words() {
  std::vector<std::string> every, integration;
  for (const Method& method : methods()) every.push_back(method.name);
  for (const auto& [word, value] : integrations()) integration.push_back(word);
  std::vector<std::string> solvers = {"sph", "fem"};
  solvers.insert(solvers.end(), every.begin(), every.end());
  OptionWords all = {
      {"--solver", solvers},
      {"--methods", every},
      {"--integration", integration},
      {"--plane", {"stress", "strain", "none"}},
      {"--reduce", {"final", "peak", "mean"}},
      {"--completion", {"bash"}}};
  for (const MethodOption& option : method_options()) {
    if (!option.on_command_line || option.words.empty()) continue;
    std::string word = "--" + option.word;
    std::replace(word.begin(), word.end(), '_', '-');
    all[word] = option.words;
  }
  return all;
}

}  // namespace femsph::compare
