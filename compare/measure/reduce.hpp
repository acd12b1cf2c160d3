#pragma once
// From the histories and profiles of a run to the numbers of a table, in the units of the table.

#include "compare/measure/quantity_spec.hpp"
#include "compare/run/plan/run_result.hpp"
#include "fem/static_limit.hpp"

namespace femsph::compare {

/// A column of a result in the units of the table, over time (s) or over the distance along a section (m).
struct Curve {
  std::vector<double> at, value;
};
/// Throws std::runtime_error naming what the run has not.
Curve curve_of(const Observed& observed, const RunResult& result);

/// Where on the scene's section a distance from its start is.
const Section& section_named(const Scene& scene, const std::string& name);
Point section_point(const Section& section, double distance);

/// What a run gives for a quantity, and what it is to be compared with; in the table's unit and sign.
/// For l2 the value and the error are the distance to theory (or, without one, to the limit) in percent.
struct Reduced {
  double value;
  std::optional<double> theory, error_percent, limit, error_vs_limit_percent;
};
/// Throws std::runtime_error with one sentence.
Reduced reduce(const QuantitySpec& quantity, const RunResult& result, const Scene& scene,
               const fem::StaticLimit* limit);

/// How far two static limits are apart in a quantity, and how large the second is; of l2 the norms along the
/// section. Nothing where the limits do not speak of it.
struct LimitChange {
  double change, size;
};
std::optional<LimitChange> change_of(const QuantitySpec& quantity, const Scene& scene,
                                     const fem::StaticLimit& from, const fem::StaticLimit& to);

/// Why the exact value of what a quantity takes at a point is infinite there (model/scene/singular.hpp);
/// empty if nothing says so. Not `certain`: why it may be, on supports of which a scene does not tell whether
/// they bear a reaction.
std::string no_value_at(const QuantitySpec& quantity, const Scene& scene, bool certain = true);

}  // namespace femsph::compare
