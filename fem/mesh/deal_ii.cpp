#include "fem/mesh/deal_ii.hpp"

#include "femsph_provenance.hpp"
#include "model/numerics/principal.hpp"

namespace femsph::fem {

/// The module calls this function of the program. In some programs nothing else does, and without this
/// pointer the linker would leave it out.
[[gnu::used]] const void* const asked_by_the_module = reinterpret_cast<const void*>(&principal_values);

const DealIi& deal_ii() {
  static const DealIi& table = *static_cast<const DealIi*>(open_module("femsph_deal_ii", FEMSPH_BUILD_ID));
  return table;
}

}  // namespace femsph::fem
