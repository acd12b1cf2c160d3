#pragma once
// From the histories and profiles of a run to the numbers of a table, in the units of the table.

#include "compare/measure/curve.hpp"
#include "fem/static_limit.hpp"

namespace femsph::compare {

/// What a run gives for a quantity, and what that is compared with; in the table's unit and sign. For l2,
/// value and error are the distance from theory (or, without one, from the limit) in percent.
struct Reduced {
  double value;
  std::optional<double> theory, error_percent, limit, error_vs_limit_percent;
};
/// Throws std::runtime_error with one sentence.
Reduced reduce(const QuantitySpec& quantity, const RunResult& result, const Scene& scene,
               const fem::StaticLimit* limit);

/// Why the exact value of a quantity that is read at a point is infinite there (model/scene/singular.hpp);
/// empty if no reason is known. Not `certain`: why it may be infinite, at supports that may or may not carry
/// a reaction.
std::string no_value_at(const QuantitySpec& quantity, const Scene& scene, bool certain = true);

}  // namespace femsph::compare
