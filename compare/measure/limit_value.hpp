#pragma once
// The value of a quantity in the converged static solution (fem/static_limit.hpp).

#include "compare/measure/curve.hpp"
#include "fem/static_limit.hpp"

namespace femsph::compare {

/// The observed component along a section, SI. `points`: the values of the limit along it, each with all
/// components of three dimensions.
Curve limit_profile(const Observed& observed, const Scene& scene,
                    const std::vector<std::vector<double>>& points);

/// In the unit of the table. Nothing unless the scene settles: only a static state, the last of the run, can
/// be compared with a static solution.
std::optional<double> limit_value(const QuantitySpec& quantity, const Scene& scene,
                                  const fem::StaticLimit& limit);

/// How far two static limits are apart in a quantity, and the magnitude of the second; of l2 the norms along
/// the section. Nothing where the limits do not hold the quantity.
struct LimitChange {
  double change, size;
};
std::optional<LimitChange> change_of(const QuantitySpec& quantity, const Scene& scene,
                                     const fem::StaticLimit& from, const fem::StaticLimit& to);

}  // namespace femsph::compare
