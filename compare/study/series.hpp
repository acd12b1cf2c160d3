#pragma once
// The data files behind a study's figures.

#include "compare/study/study_runner.hpp"

namespace femsph::compare {

/// CSV of one series: the first column is what the figure has on its x axis (spacing_mm, case, time_UNIT,
/// distance_mm), then one column for each curve, named by its method, its case, or both when several methods
/// and several cases are shown; last "theory". Cells that a run does not reach (it settled earlier, say) are
/// empty.
std::string series_csv(const SeriesSpec& series, const Study& study, const StudyOutcome& outcome);

}  // namespace femsph::compare
