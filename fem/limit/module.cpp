#include "fem/limit/limit.hpp"
#include "fem/limit/triangulation.hpp"
#include "fem/mesh/deal_ii.hpp"
#include "femsph_provenance.hpp"

namespace femsph::fem {
namespace {

constexpr DealIi table{{FEMSPH_BUILD_ID}, make_oracle, solve_static, triangulated_grid};

}  // namespace
}  // namespace femsph::fem

extern "C" const femsph::ModuleHead* femsph_deal_ii_module() { return &femsph::fem::table; }
