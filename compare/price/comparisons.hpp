#pragma once
// Comparisons of the methods on one scene, which price.csv and the tables of the README both show.

#include <limits>

#include "compare/price/priced_scene.hpp"

namespace femsph::compare {

/// What every method of the scene costs for an error, and the least of it.
struct Offer {
  std::vector<PricedLadder::Cost> costs;
  double least = std::numeric_limits<double>::infinity();  ///< CPU, s
};
Offer offers(const PricedScene& scene, double error);

/// A method at the common spacing of the scene: error in percent, CPU in s.
struct AtSpacing {
  std::string method;
  double error, cpu;
  double ratio_to_cheapest = 1;  ///< CPU over that of the cheapest method
};
std::vector<AtSpacing> at_spacing(const PricedScene& scene);

/// A method beside the base method where both have the same error.
struct Finer {
  std::string method;
  double error;          ///< percent
  double base_spacing;   ///< mm
  double finer, dearer;  ///< spacing of the base over that of the method; CPU over that of the base
  bool extrapolated;     ///< either of the two
  double dearer_if_ten_times_finer;  ///< CPU at a tenth of the base's spacing over that of the base
};
std::vector<Finer> finer(const PricedScene& scene);

}  // namespace femsph::compare
