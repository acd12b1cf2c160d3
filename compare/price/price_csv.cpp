#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "compare/price/comparisons.hpp"
#include "compare/price/price_tables.hpp"

namespace femsph::compare {
namespace {

using Cost = PricedLadder::Cost;
using Basis = Cost::Basis;

std::string basis_of(const Cost& cost) {
  switch (cost.basis) {
    case Basis::interpolated:
      return "interpolated";
    case Basis::coarsest:
      return "coarsest run";
    case Basis::extrapolated:
      return "extrapolated";
    case Basis::not_reached:
      break;
  }
  return "not reached: " + cost.reason;
}

}  // namespace

std::string price_csv(const std::vector<PricedScene>& scenes) {
  std::string text = "scene,method,error_percent,cpu_s,spacing_mm,extrapolated,ratio_to_cheapest,basis\r\n";
  for (const PricedScene& scene : scenes)
    for (const double error : scene.spec->errors) {
      const Offer offer = offers(scene, error);
      for (std::size_t m = 0; m < scene.methods.size(); ++m) {
        const Cost& cost = offer.costs[m];
        const bool reached = cost.reached();
        const auto number = [&](double value) { return reached ? csv_number(value) : ""; };
        const char* extrapolated = cost.basis == Basis::extrapolated ? "yes" : reached ? "no" : "";
        text += csv_line(
            {scene.spec->name, scene.methods[m].method, fmt::format("{:g}", error), number(cost.cpu),
             number(cost.spacing), extrapolated, number(cost.cpu / offer.least), basis_of(cost)});
      }
    }
  return text;
}

std::string spacing_csv(const std::vector<PricedScene>& scenes) {
  std::string text = "scene,method,spacing_mm,error_percent,cpu_s,ratio_to_cheapest\r\n";
  for (const PricedScene& scene : scenes)
    for (const AtSpacing& one : at_spacing(scene))
      text += csv_line({scene.spec->name, one.method, csv_number(1e3 * *scene.spec->spacing),
                        csv_number(one.error), csv_number(one.cpu), csv_number(one.ratio_to_cheapest)});
  return text;
}

std::string finer_csv(const std::vector<PricedScene>& scenes) {
  std::string text =
      "scene,method,base,error_percent,base_spacing_mm,finer,dearer,extrapolated,dearer_if_ten_times_"
      "finer\r\n";
  for (const PricedScene& scene : scenes)
    for (const Finer& one : finer(scene))
      text += csv_line({scene.spec->name, one.method, scene.spec->base, fmt::format("{:g}", one.error),
                        csv_number(one.base_spacing), csv_number(one.finer), csv_number(one.dearer),
                        one.extrapolated ? "yes" : "no", csv_number(one.dearer_if_ten_times_finer)});
  return text;
}

std::string ladders_csv(const std::vector<PricedScene>& scenes) {
  std::string text =
      "scene,method,order,heads_for_percent,error_over_cpu,cpu_over_dof,ns_per_unit_step,spread_percent,"
      "rungs,no_order_because\r\n";
  for (const PricedScene& scene : scenes)
    for (const auto& entry : scene.methods) {
      std::string why;
      const auto order = entry.ladder.order(&why);
      text += csv_line(
          {scene.spec->name, entry.method, csv_number(order), csv_number(entry.ladder.error_at_zero()),
           csv_number(entry.ladder.error_over_cpu()), csv_number(entry.ladder.cpu_over_dof()),
           csv_number(entry.nanoseconds), csv_number(entry.spread_percent),
           fmt::format("{}", entry.ladder.rungs().size()), why});
    }
  return text;
}

std::string rungs_csv(const PricedScene& scene) {
  std::string text =
      "method,spacing_mm,dof,error_percent,credited_percent,cpu_s,cpu_min_s,cpu_max_s,memory_mb\r\n";
  for (const auto& entry : scene.methods)
    for (std::size_t i = 0; i < entry.ladder.rungs().size(); ++i) {
      const PricedRung& r = entry.ladder.rungs()[i];
      text += csv_line({entry.method, csv_number(r.spacing), csv_number(r.dof), csv_number(r.error),
                        csv_number(entry.ladder.credited()[i]), csv_number(r.cpu), csv_number(r.cpu_min),
                        csv_number(r.cpu_max), csv_number(r.memory)});
    }
  return text;
}

std::string front_csv(const PricedScene& scene) {
  struct Point {
    std::string method;
    double cpu, error;
  };
  std::vector<Point> points;
  for (const auto& entry : scene.methods)
    for (std::size_t i = 0; i < entry.ladder.rungs().size(); ++i)
      points.push_back({entry.method, entry.ladder.rungs()[i].cpu, entry.ladder.credited()[i]});
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.cpu < b.cpu || (a.cpu == b.cpu && a.error < b.error);
  });
  std::string text = "method,cpu_s,error_percent\r\n";
  double best = std::numeric_limits<double>::infinity();
  for (const Point& p : points)
    if (p.error < best) {
      best = p.error;
      text += csv_line({p.method, csv_number(p.cpu), csv_number(p.error)});
    }
  return text;
}

}  // namespace femsph::compare
