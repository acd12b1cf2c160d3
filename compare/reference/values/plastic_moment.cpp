// The moment of a rectangle that yields all over.

#include "compare/reference/values/beam.hpp"
#include "compare/reference/values/theory_value.hpp"

namespace femsph::compare {

std::vector<Theory> plastic_moment_values() {
  using Depends = Theory::Depends;
  return {
      {"plastic_moment", "N m", "sigma_y b h^2/4", Depends::on_nothing,
       [](const Scene& scene, const Point&, double) { return plastic_moment(scene); }},
  };
}

}  // namespace femsph::compare
