#pragma once
// The price of accuracy as tables: price.csv, the data of its figures, and Markdown.

#include "compare/price/priced_scene.hpp"

namespace femsph::compare {

/// One row for each method and error:
/// scene,method,error_percent,cpu_s,spacing_mm,extrapolated,ratio_to_cheapest,basis.
std::string price_csv(const std::vector<PricedScene>& scenes);
/// All methods at one spacing: scene,method,spacing_mm,error_percent,cpu_s,ratio_to_cheapest.
std::string spacing_csv(const std::vector<PricedScene>& scenes);
/// Against the base method at the same error: the ratio of the spacings (finer) and of the CPU times
/// (dearer):
/// scene,method,base,error_percent,base_spacing_mm,finer,dearer,extrapolated,dearer_if_ten_times_finer.
std::string finer_csv(const std::vector<PricedScene>& scenes);
/// One row for each ladder: scene,method,order,heads_for_percent,error_over_cpu,cpu_over_dof,
/// ns_per_unit_step,spread_percent,rungs,no_order_because.
std::string ladders_csv(const std::vector<PricedScene>& scenes);
/// One row for each rung, for figures:
/// method,spacing_mm,dof,error_percent,credited_percent,cpu_s,cpu_min_s,cpu_max_s,memory_mb.
std::string rungs_csv(const PricedScene& scene);
/// The Pareto front of the rungs by credited error and CPU time: method,cpu_s,error_percent, dearest last.
std::string front_csv(const PricedScene& scene);
/// All tables in Markdown.
std::string price_markdown(const std::vector<PricedScene>& scenes);

}  // namespace femsph::compare
