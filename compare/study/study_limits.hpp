#pragma once
// The values that the runs of a study should converge to: [limit] and [[limits]].

#include "compare/study/study_runner.hpp"

namespace femsph::compare {

/// The static limit of a scene; the same with a degree less, which shows how well it is known (only of
/// studies with prices); and two coarser ones, coarse first, which show whether refining converges.
struct KnownLimit {
  fem::StaticLimit limit, coarser;
  std::vector<fem::StaticLimit> ladder;
  double slowest = 0;  ///< largest ratio of a change to the change before it that counts as convergence
};
using StaticLimits = std::map<std::string, KnownLimit>;  ///< by scene

/// The static limits of the scenes that will be run. One that cannot be computed counts as a failure and is
/// left empty.
StaticLimits static_limits(const Study& study, const Engine& engine, const StudyOptions& options,
                           StudyOutcome& outcome);
/// The static limit of a scene; null if there is none.
const KnownLimit* limit_of(const StaticLimits& limits, const std::string& scene);

/// Why a quantity must not be compared with the limit: its exact value is infinite there, or the changes from
/// refinement to refinement do not fall geometrically (halving the cells leaves more than 0.7 of the change
/// before; for a logarithm, of order 0, the ratio is 1). Empty: there is no such reason. Changes below 0.01 %
/// are ignored.
std::string doubt_of(const QuantitySpec& quantity, const Scene& scene, const KnownLimit& known);

/// Fills the limits, and the errors against them, of the rows whose scene takes Richardson's limit of a
/// ladder. `limit_known_percent` is Roache's grid convergence index (1998, 5.9): 1.25 times the distance of
/// the finest rung from the limit.
void ladder_limits(const Study& study, const StudyOptions& options, StudyOutcome& outcome);

}  // namespace femsph::compare
