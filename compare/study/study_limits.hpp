#pragma once
// What the runs of a study converge to: [limit] and [[limits]].

#include "compare/study/study_runner.hpp"

namespace femsph::compare {

/// The static limit of a scene; the same by one degree less, which tells how well it is known (of studies
/// with prices); and two coarser ones, coarse first, which tell whether it is one.
struct KnownLimit {
  fem::StaticLimit limit, coarser;
  std::vector<fem::StaticLimit> ladder;
  double slowest =
      0;  ///< what is left of the change from one of the ladder to the next, at most, if it converges
};
using StaticLimits = std::map<std::string, KnownLimit>;  ///< by scene

/// The static limits of the scenes that will be run. One that cannot be had counts as a failure and is left
/// empty.
StaticLimits static_limits(const Study& study, const Engine& engine, const StudyOptions& options,
                           StudyOutcome& outcome);
/// The one of a scene; none if it has none.
const KnownLimit* limit_of(const StaticLimits& limits, const std::string& scene);

/// Why a limit is not to be compared with: the exact value is infinite there, or the changes from refinement
/// to refinement do not fall geometrically (each halving of the cells leaves more than 0.7 of the change
/// before: the order of a logarithm is 0, ratio 1). Empty: nothing speaks against it. A change below 0.01 %
/// is not looked at.
std::string doubt_of(const QuantitySpec& quantity, const Scene& scene, const KnownLimit& known);

/// Fills the limits, and the errors against them, of the rows whose scene takes Richardson's limit of a
/// ladder. `limit_known_percent` is Roache's grid convergence index (1998, 5.9): 1.25 times the distance of
/// the finest rung from the limit.
void ladder_limits(const Study& study, const StudyOptions& options, StudyOutcome& outcome);

}  // namespace femsph::compare
