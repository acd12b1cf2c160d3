#include "compare/price/comparisons.hpp"

#include <algorithm>
#include <cmath>

namespace femsph::compare {

Offer offers(const PricedScene& scene, double error) {
  Offer offer;
  for (const auto& entry : scene.methods) {
    offer.costs.push_back(entry.ladder.cost_of(error));
    if (offer.costs.back().reached()) offer.least = std::min(offer.least, offer.costs.back().cpu);
  }
  return offer;
}

std::vector<AtSpacing> at_spacing(const PricedScene& scene) {
  std::vector<AtSpacing> all;
  if (!scene.spec->spacing) return all;
  const double spacing = 1e3 * *scene.spec->spacing;
  for (const auto& entry : scene.methods)
    for (const PricedRung& rung : entry.ladder.rungs())
      if (std::abs(rung.spacing / spacing - 1) < 1e-6) all.push_back({entry.method, rung.error, rung.cpu});
  double least = std::numeric_limits<double>::infinity();
  for (const AtSpacing& one : all) least = std::min(least, one.cpu);
  for (AtSpacing& one : all) one.ratio_to_cheapest = one.cpu / least;
  return all;
}

std::vector<Finer> finer(const PricedScene& scene) {
  std::vector<Finer> all;
  const auto base = std::find_if(scene.methods.begin(), scene.methods.end(), [&](const auto& e) {
    return e.method == scene.spec->base;
  });
  if (base == scene.methods.end()) return all;
  for (const double error : scene.spec->errors) {
    const PricedLadder::Cost ours = base->ladder.cost_of(error);
    if (!ours.reached()) continue;
    for (const auto& entry : scene.methods) {
      if (&entry == &*base) continue;
      const PricedLadder::Cost theirs = entry.ladder.cost_of(error);
      if (!theirs.reached()) continue;
      all.push_back({entry.method, error, ours.spacing, ours.spacing / theirs.spacing, theirs.cpu / ours.cpu,
                     ours.basis == PricedLadder::Cost::Basis::extrapolated ||
                         theirs.basis == PricedLadder::Cost::Basis::extrapolated,
                     entry.ladder.cpu_at(ours.spacing / 10) / ours.cpu});
    }
  }
  return all;
}

}  // namespace femsph::compare
