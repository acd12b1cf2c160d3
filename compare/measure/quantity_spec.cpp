#include "compare/measure/quantity_spec.hpp"

#include <algorithm>

namespace femsph::compare {

bool QuantitySpec::is_of(const PlannedRun& run) const {
  return (!scene || *scene == run.scene) &&
         (methods.empty() || std::find(methods.begin(), methods.end(), run.label) != methods.end());
}

}  // namespace femsph::compare
