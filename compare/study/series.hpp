#pragma once
// The data files behind a study's figures.

#include "compare/study/study_runner.hpp"

namespace femsph::compare {

/// CSV of one series. The first column is the abscissa (spacing_mm, case, time_UNIT, distance_mm); then comes
/// one column for each curve, named by its method, its case, or both where several of each are shown;
/// "theory" is last. Cells beyond the end of a run (which settled earlier, say) are empty.
std::string series_csv(const SeriesSpec& series, const Study& study, const StudyOutcome& outcome);

}  // namespace femsph::compare
