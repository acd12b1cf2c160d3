#pragma once
// What the runs of a study converge to: [limit] and [[limits]].

#include "compare/study_runner.hpp"

namespace femsph::compare {

/// The static limit of a scene, and the same by one degree less, which tells how well it is known.
struct KnownLimit {
  fem::StaticLimit limit, coarser;
};
using StaticLimits = std::map<std::string, KnownLimit>;  ///< by scene

/// The static limits of the scenes that will be run. One that cannot be had counts as a failure and is left empty.
StaticLimits static_limits(const Study& study, const Engine& engine, const StudyOptions& options, StudyOutcome& outcome);
/// The one of a scene; none if it has none.
const KnownLimit* limit_of(const StaticLimits& limits, const std::string& scene);

/// Fills the limits, and the errors against them, of the rows whose scene takes Richardson's limit of a ladder.
/// `limit_known_percent` is Roache's grid convergence index (1998, 5.9): 1.25 times the distance of the finest rung from the limit.
void ladder_limits(const Study& study, const StudyOptions& options, StudyOutcome& outcome);

}  // namespace femsph::compare
