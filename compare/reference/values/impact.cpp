// Impact of a bar of bilinear hardening.

#include "compare/reference/values/beam.hpp"
#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {

std::vector<Theory> impact_values() {
  using Depends = Theory::Depends;
  return {
      {"impact_stress", "Pa", "yield + rho c_p (V - V_y), behind the plastic front (compression: below 0)",
       Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return -impact_of(scene).stress(); }},
      {"impact_strain", "1", "yield/E + (V - V_y)/c_p, behind the plastic front (compression: below 0)",
       Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return -impact_of(scene).strain(); }},
  };
}

}  // namespace femsph::compare
