#pragma once
// Makes the runs of a study and computes the rows of its table.

#include <functional>
#include <set>

#include "compare/run/run.hpp"
#include "compare/study/reader/study.hpp"

namespace femsph::compare {

/// The functions that compute runs and limits. Tests use others.
struct Engine {
  std::function<RunResult(const Scene&, const BodyMethods&, const Resolution&, const RunOptions&)> run;
  std::function<fem::StaticLimit(const Scene&, const std::array<int, 3>& divisions, int degree)> limit;
};

struct FinishedRun {
  const PlannedRun* plan;
  RunResult result;
  std::size_t first_row = 0, row_count = 0;  ///< its rows in StudyOutcome::rows
};

struct StudyOutcome {
  std::vector<Row> rows;
  std::vector<FinishedRun> runs;  ///< those that finished
  int failures = 0;
  std::set<std::string> warnings;  ///< of the runs, each once
};

struct StudyOptions {
  bool quick = false;
  std::string command;                                 ///< for the records
  std::function<void(const std::string& line)> log;    ///< one line for each run
  std::function<void(const StudyOutcome&)> after_run;  ///< to save the rows so far
};

/// One run after the other. A run that fails gives rows with a reason, and the study continues.
StudyOutcome run_study(const Study& study, const Engine& engine, const StudyOptions& options);

}  // namespace femsph::compare
