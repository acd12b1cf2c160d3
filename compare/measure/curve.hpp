#pragma once
// What a run has recorded of a quantity: a history or a profile.

#include "compare/measure/quantity_spec.hpp"
#include "compare/run/plan/run_result.hpp"

namespace femsph::compare {

/// A column of a result in the units of the table, over time (s) or over the distance along a section (m).
struct Curve {
  std::vector<double> at, value;
};
/// Throws std::runtime_error that names what the run does not have.
Curve curve_of(const Observed& observed, const RunResult& result);
/// The curve, if all its values are finite numbers: std::max_element and the like would pass over others.
/// `what` names it in the message. Throws std::runtime_error.
Curve finite(Curve curve, const std::string& what);
/// The samples in a window of time (s), or all without one. Throws std::runtime_error if there are none, or
/// if the history ends within the window.
Curve within(const Curve& curve, const std::optional<std::array<double, 2>>& window);

/// Throws std::runtime_error if the scene has none of this name.
const Section& section_named(const Scene& scene, const std::string& name);
/// The point at a distance (m) from the start of a section.
Point section_point(const Section& section, double distance);

/// What a probe or a section reads, and in which body.
struct ReadAt {
  std::size_t body;
  const Quantity* quantity;
};
/// Throws std::runtime_error if the scene has no such probe or section.
ReadAt read_at(const Observed& observed, const Scene& scene);

}  // namespace femsph::compare
