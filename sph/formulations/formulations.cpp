// The list of SPH formulations. A new one is one source file in this folder that returns a Formulation
// (sph/options.hpp); here its function is declared and called.

#include "model/input/faults.hpp"
#include "sph/formulations/discretize.hpp"

namespace femsph::sph {

Formulation classic_formulation();
Formulation corrected_formulation();

const std::vector<Formulation>& formulations() {
  static const std::vector<Formulation> all = [] {
    std::vector<Formulation> list = {classic_formulation(), corrected_formulation()};
    for (Formulation& formulation : list)
      for (Variant& variant : formulation.variants) variant.options.formulation = formulation.word;
    return list;
  }();
  return all;
}

const Formulation& formulation_named(const std::string& word) {
  std::vector<std::string> words;
  for (const Formulation& formulation : formulations()) {
    if (formulation.word == word) return formulation;
    words.emplace_back(formulation.word);
  }
  throw Refusal(
      "no SPH formulation " + in_quotes(word) + "; expected " + one_of(words) + did_you_mean(word, words));
}

}  // namespace femsph::sph
