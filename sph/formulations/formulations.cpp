// The list of SPH formulations. A new one is one source file in this folder that returns a Formulation
// (sph/options.hpp); here its function is declared and called.

#include "model/input/faults.hpp"
#include "model/input/lookup.hpp"
#include "sph/formulations/discretize.hpp"

namespace femsph::sph {

Formulation classic_formulation();
Formulation corrected_formulation();
Formulation updated_formulation();

const std::vector<Formulation>& formulations() {
  static const std::vector<Formulation> all = [] {
    std::vector<Formulation> list = {classic_formulation(), corrected_formulation(), updated_formulation()};
    for (Formulation& formulation : list)
      for (Variant& variant : formulation.variants) variant.options.formulation = formulation.word;
    return list;
  }();
  return all;
}

const Formulation& formulation_named(const std::string& word) {
  return entry_named<Refusal>(
      formulations(), word, &Formulation::word, "no SPH formulation " + in_quotes(word));
}

}  // namespace femsph::sph
