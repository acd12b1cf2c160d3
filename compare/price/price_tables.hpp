#pragma once
// The price of accuracy as tables: from the rows of a study to price.csv, and to the data of its figures.

#include "compare/price/priced_ladder.hpp"
#include "compare/study/reader/study.hpp"

namespace femsph::compare {

/// One [[price]] of a study: every method's ladder, in the order of the rows.
struct PricedScene {
  const PriceSpec* spec;
  struct Entry {
    std::string method;
    PricedLadder ladder;
    double
        spread_percent;  ///< of repeated runs: (most - least) / median, the largest of the rungs over 0.05 s
    double nanoseconds;  ///< a unit and step, of the finest rung
  };
  std::vector<Entry> methods;
  std::optional<double> reference, known_percent;  ///< in `unit`; known_percent: of an extrapolated limit
  std::string unit;
  std::string nothing;  ///< why no row has an error
};

/// Rows without a value, and of runs that should have settled and did not, are left out; so is the ladder
/// that gave the limit.
std::vector<PricedScene> priced_scenes(const Study& study, const std::vector<Row>& rows);

/// scene,method,error_percent,cpu_s,spacing_mm,extrapolated,ratio_to_cheapest,basis: one row for each method
/// and error.
std::string price_csv(const std::vector<PricedScene>& scenes);
/// The same at one spacing: scene,method,spacing_mm,error_percent,cpu_s,extrapolated,ratio_to_cheapest.
std::string spacing_csv(const std::vector<PricedScene>& scenes);
/// How many times finer, and dearer, than the base method:
/// scene,method,base,error_percent,base_spacing_mm,finer,dearer,extrapolated, dearer_if_ten_times_finer.
std::string finer_csv(const std::vector<PricedScene>& scenes);
/// One row a ladder:
/// scene,method,order,heads_for_percent,error_over_cpu,cpu_over_dof,ns_per_unit_step,spread_percent,rungs,no_order_because.
std::string ladders_csv(const std::vector<PricedScene>& scenes);
/// One row a rung, for figures:
/// method,spacing_mm,dof,error_percent,credited_percent,cpu_s,cpu_min_s,cpu_max_s,memory_mb.
std::string rungs_csv(const PricedScene& scene);
/// The Pareto front of the rungs by credited error and CPU time: method,cpu_s,error_percent, dearest last.
std::string front_csv(const PricedScene& scene);
/// All of it for people.
std::string price_markdown(const std::vector<PricedScene>& scenes);

}  // namespace femsph::compare
