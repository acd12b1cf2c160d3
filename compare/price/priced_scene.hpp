#pragma once
// The ladders of all methods for one [[price]] of a study.

#include "compare/price/priced_ladder.hpp"
#include "compare/study/reader/study.hpp"

namespace femsph::compare {

/// Methods are in the order of the rows.
struct PricedScene {
  const PriceSpec* spec;
  struct Entry {
    std::string method;
    PricedLadder ladder;
    /// Of repeated runs: (most - least)/median, percent; the largest of the rungs that take over 0.05 s.
    double spread_percent;
    double nanoseconds;  ///< of a unit and step, at the finest rung
  };
  std::vector<Entry> methods;
  std::optional<double> reference, known_percent;  ///< in `unit`; known_percent: of an extrapolated limit
  std::string unit;
  std::string nothing;  ///< why no row has an error
};

/// Left out: rows without a value, rows of runs that should have settled and did not, and the ladder that
/// gave the limit.
std::vector<PricedScene> priced_scenes(const Study& study, const std::vector<Row>& rows);

}  // namespace femsph::compare
