#include "fem/fem.hpp"

#include "fem/mesh/deal_ii.hpp"
#include "femsph_provenance.hpp"

namespace femsph::fem {

namespace {
/// The module's FEValues reference derives from ExplicitFem. A program that only computes the static limit
/// must contain ExplicitFem too, and this pointer keeps the linker from leaving it out.
[[gnu::used]] const auto needed_by_the_module = &discretize;
}  // namespace

std::unique_ptr<Discretization> discretize_oracle(const Scene& scene, std::size_t body,
                                                  const Options& options) {
  return deal_ii().oracle(scene, body, options);
}

StaticLimit static_limit(const Scene& scene, const std::array<int, 3>& divisions, int degree) {
  return deal_ii().static_limit(scene, divisions, degree);
}

std::string deal_ii_version() { return FEMSPH_DEAL_II; }

}  // namespace femsph::fem
