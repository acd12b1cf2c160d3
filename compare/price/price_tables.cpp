#include "compare/price/price_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace femsph::compare {
namespace {

using Cost = PricedLadder::Cost;
using Basis = Cost::Basis;

std::string cell(const std::optional<double>& value) { return value ? csv_number(*value) : ""; }

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

/// What every method pays for an error, and the least of it.
struct Offer {
  std::vector<Cost> costs;
  double least = std::numeric_limits<double>::infinity();
};

Offer offers(const PricedScene& scene, double error) {
  Offer offer;
  for (const auto& entry : scene.methods) {
    offer.costs.push_back(entry.ladder.cost_of(error));
    if (offer.costs.back().reached()) offer.least = std::min(offer.least, offer.costs.back().cpu);
  }
  return offer;
}

/// A method at the common spacing of a scene.
struct AtSpacing {
  std::string method;
  double error, cpu;
};

std::vector<AtSpacing> at_spacing(const PricedScene& scene) {
  std::vector<AtSpacing> all;
  if (!scene.spec->spacing) return all;
  const double spacing = 1e3 * *scene.spec->spacing;
  for (const auto& entry : scene.methods)
    for (const PricedRung& rung : entry.ladder.rungs())
      if (std::abs(rung.spacing / spacing - 1) < 1e-6) all.push_back({entry.method, rung.error, rung.cpu});
  return all;
}

double least_of(const std::vector<AtSpacing>& all) {
  double least = std::numeric_limits<double>::infinity();
  for (const AtSpacing& one : all) least = std::min(least, one.cpu);
  return least;
}

/// A method beside the base method where both have the same error.
struct Finer {
  std::string method;
  double error, base_spacing, finer, dearer;
  bool extrapolated;
  double dearer_if_ten_times_finer;
};

std::vector<Finer> finer(const PricedScene& scene) {
  std::vector<Finer> all;
  const auto base = std::find_if(scene.methods.begin(), scene.methods.end(), [&](const auto& e) {
    return e.method == scene.spec->base;
  });
  if (base == scene.methods.end()) return all;
  for (const double error : scene.spec->errors) {
    const Cost ours = base->ladder.cost_of(error);
    if (!ours.reached()) continue;
    for (const auto& entry : scene.methods) {
      if (&entry == &*base) continue;
      const Cost theirs = entry.ladder.cost_of(error);
      if (!theirs.reached()) continue;
      all.push_back({entry.method, error, ours.spacing, ours.spacing / theirs.spacing, theirs.cpu / ours.cpu,
                     ours.basis == Basis::extrapolated || theirs.basis == Basis::extrapolated,
                     entry.ladder.cpu_at(ours.spacing / 10) / ours.cpu});
    }
  }
  return all;
}

using Cells = std::vector<std::vector<std::string>>;

std::string times(double ratio) {
  return ratio < 9.95 ? fmt::format("{:.1f}x", ratio)
         : fmt::format("{:.2g}x", ratio) == "1e+01x"
             ? "10x"
             : rounded(ratio, 2) + "x";
}

std::string price_cell(const Cost& cost, double least) {
  if (!cost.reached()) return "-";
  const char* mark = cost.basis == Basis::extrapolated ? "~" : cost.basis == Basis::coarsest ? "<" : "";
  return fmt::format(
      "{}{} s, {}, {} mm", mark, rounded(cost.cpu, 2), times(cost.cpu / least), rounded(cost.spacing, 2));
}

std::string price_table(const PricedScene& scene) {
  Cells cells{{"method", "order", "error ~ CPU^", "CPU ~ dof^", "ns"}};
  for (const double error : scene.spec->errors) cells[0].push_back(fmt::format("{:g} %", error));
  std::vector<Offer> offer;
  for (const double error : scene.spec->errors) offer.push_back(offers(scene, error));
  std::vector<std::string> reasons;
  for (std::size_t m = 0; m < scene.methods.size(); ++m) {
    const auto& entry = scene.methods[m];
    const auto slope = [](const std::optional<double>& value) {
      return value ? fmt::format("{:.2f}", *value) : "-";
    };
    std::vector<std::string> line{
        entry.method, slope(entry.ladder.order()), slope(entry.ladder.error_over_cpu()),
        slope(entry.ladder.cpu_over_dof()), rounded(entry.nanoseconds, 2)};
    for (std::size_t e = 0; e < offer.size(); ++e) {
      line.push_back(price_cell(offer[e].costs[m], offer[e].least));
      if (!offer[e].costs[m].reached())
        reasons.push_back(
            fmt::format("- {}, {:g} %: {}\n", entry.method, scene.spec->errors[e], offer[e].costs[m].reason));
    }
    cells.push_back(line);
  }
  std::string text = markdown_table(cells);
  if (!reasons.empty()) text += "\nNot reached:\n\n";
  for (const std::string& reason : reasons) text += reason;
  return text;
}

std::string spacing_table(const PricedScene& scene) {
  const auto all = at_spacing(scene);
  if (all.empty()) return "";
  Cells cells{{"method", "error %", "CPU s", "times the cheapest"}};
  for (const AtSpacing& one : all)
    cells.push_back(
        {one.method, fmt::format("{:+.2f}", one.error), rounded(one.cpu, 2), times(one.cpu / least_of(all))});
  return fmt::format("\nAll at {:g} mm:\n\n", 1e3 * *scene.spec->spacing) + markdown_table(cells);
}

std::string finer_table(const PricedScene& scene) {
  const auto all = finer(scene);
  if (all.empty()) return "";
  Cells cells{{"method", "error", "times finer", "times dearer", "dearer if 10x finer"}};
  for (const Finer& one : all)
    if (one.method.starts_with("sph"))
      cells.push_back({one.method, fmt::format("{:g} %", one.error),
                       (one.extrapolated ? "~" : "") + rounded(one.finer, 2),
                       (one.extrapolated ? "~" : "") + rounded(one.dearer, 2),
                       rounded(one.dearer_if_ten_times_finer, 2)});
  if (cells.size() == 1) return "";
  return fmt::format("\nSPH for the same error as {}:\n\n", scene.spec->base) + markdown_table(cells);
}

}  // namespace

std::vector<PricedScene> priced_scenes(const Study& study, const std::vector<Row>& rows) {
  std::vector<PricedScene> scenes;
  for (const PriceSpec& spec : study.prices) {
    const auto quantity = std::find_if(study.quantities.begin(), study.quantities.end(),
                                       [&](const QuantitySpec& q) { return q.name == spec.quantity; });
    const std::string file = quantity->scene.value_or(study.scenes.begin()->first);
    const auto own = study.limits.find(file);
    const std::string reference = own != study.limits.end() ? own->second.ladder : "";
    PricedScene scene{&spec, {}, {}, {}, quantity->observed.unit.name, "no run gave a value"};
    for (const Row& row : rows)
      if (row.scene == file && row.study == study.name && row.quantity == spec.quantity && row.value)
        scene.nothing = row.limit_doubt.empty() ? "there is nothing to err from" : row.limit_doubt;
    std::vector<std::string> methods;
    for (const Row& row : rows)
      if (row.scene == file && row.study == study.name && row.quantity == spec.quantity &&
          row.method != reference && std::find(methods.begin(), methods.end(), row.method) == methods.end())
        methods.push_back(row.method);
    for (const std::string& method : methods) {
      std::vector<PricedRung> rungs;
      double spread = 0, nanoseconds = 0, finest = std::numeric_limits<double>::infinity();
      for (const Row& row : rows) {
        if (row.scene != file || row.study != study.name || row.quantity != spec.quantity ||
            row.method != method)
          continue;
        const auto error = error_of(row, spec.reference);
        if (!error || !row.spacing_mm || !row.total_cpu_s || row.settled == false) continue;
        if (spec.reference == Reference::theory)
          scene.reference = row.theory;
        else
          scene.reference = row.limit, scene.known_percent = row.limit_known_percent;
        rungs.push_back({*row.spacing_mm, *error, *row.total_cpu_s, row.steps.value_or(0),
                         row.units.value_or(0), row.dof.value_or(0), row.memory_mb.value_or(0),
                         row.total_cpu_min_s.value_or(0), row.total_cpu_max_s.value_or(0)});
        if (*row.total_cpu_s > 0.05)
          spread = std::max(spread, 100 * (rungs.back().cpu_max - rungs.back().cpu_min) / *row.total_cpu_s);
        if (*row.spacing_mm < finest)
          finest = *row.spacing_mm, nanoseconds = row.ns_per_unit_step.value_or(0);
      }
      if (rungs.empty()) continue;
      const double known = spec.reference == Reference::limit ? scene.known_percent.value_or(0) : 0;
      scene.methods.push_back(
          {method, PricedLadder(std::move(rungs), study.scenes.at(file).dim(), known), spread, nanoseconds});
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::string price_csv(const std::vector<PricedScene>& scenes) {
  std::string text = "scene,method,error_percent,cpu_s,spacing_mm,extrapolated,ratio_to_cheapest,basis\r\n";
  for (const PricedScene& scene : scenes)
    for (const double error : scene.spec->errors) {
      const Offer offer = offers(scene, error);
      for (std::size_t m = 0; m < scene.methods.size(); ++m) {
        const Cost& cost = offer.costs[m];
        const std::string name = fmt::format(
            "{},{},{:g},", csv_cell(scene.spec->name), csv_cell(scene.methods[m].method), error);
        if (cost.reached())
          text += name + fmt::format("{},{},{},{},{}\r\n", csv_number(cost.cpu), csv_number(cost.spacing),
                                     cost.basis == Basis::extrapolated ? "yes" : "no",
                                     csv_number(cost.cpu / offer.least), csv_cell(basis_of(cost)));
        else
          text += name + fmt::format(",,,,{}\r\n", csv_cell(basis_of(cost)));
      }
    }
  return text;
}

std::string spacing_csv(const std::vector<PricedScene>& scenes) {
  std::string text = "scene,method,spacing_mm,error_percent,cpu_s,ratio_to_cheapest\r\n";
  for (const PricedScene& scene : scenes) {
    const auto all = at_spacing(scene);
    for (const AtSpacing& one : all)
      text += fmt::format("{},{},{},{},{},{}\r\n", csv_cell(scene.spec->name), csv_cell(one.method),
                          csv_number(1e3 * *scene.spec->spacing), csv_number(one.error), csv_number(one.cpu),
                          csv_number(one.cpu / least_of(all)));
  }
  return text;
}

std::string finer_csv(const std::vector<PricedScene>& scenes) {
  std::string text =
      "scene,method,base,error_percent,base_spacing_mm,finer,dearer,extrapolated,dearer_if_ten_times_"
      "finer\r\n";
  for (const PricedScene& scene : scenes)
    for (const Finer& one : finer(scene))
      text += fmt::format(
          "{},{},{},{:g},{},{},{},{},{}\r\n", csv_cell(scene.spec->name), csv_cell(one.method),
          csv_cell(scene.spec->base), one.error, csv_number(one.base_spacing), csv_number(one.finer),
          csv_number(one.dearer), one.extrapolated ? "yes" : "no", csv_number(one.dearer_if_ten_times_finer));
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
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{}\r\n", csv_cell(scene.spec->name), csv_cell(entry.method),
          cell(order), cell(entry.ladder.heading()), cell(entry.ladder.error_over_cpu()),
          cell(entry.ladder.cpu_over_dof()), csv_number(entry.nanoseconds), csv_number(entry.spread_percent),
          entry.ladder.rungs().size(), csv_cell(why));
    }
  return text;
}

std::string rungs_csv(const PricedScene& scene) {
  std::string text =
      "method,spacing_mm,dof,error_percent,credited_percent,cpu_s,cpu_min_s,cpu_max_s,memory_mb\r\n";
  for (const auto& entry : scene.methods)
    for (std::size_t i = 0; i < entry.ladder.rungs().size(); ++i) {
      const PricedRung& r = entry.ladder.rungs()[i];
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{}\r\n", csv_cell(entry.method), csv_number(r.spacing), csv_number(r.dof),
          csv_number(r.error), csv_number(entry.ladder.credited()[i]), csv_number(r.cpu),
          csv_number(r.cpu_min), csv_number(r.cpu_max), csv_number(r.memory));
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
      text += fmt::format("{},{},{}\r\n", csv_cell(p.method), csv_number(p.cpu), csv_number(p.error));
    }
  return text;
}

std::string price_markdown(const std::vector<PricedScene>& scenes) {
  std::string text;
  for (const PricedScene& scene : scenes) {
    text += fmt::format("### {}\n\n`{}`", scene.spec->title, scene.spec->quantity);
    if (scene.reference && scene.unit != "%")
      text += fmt::format(
          ", {} {} {}", scene.spec->reference == Reference::theory ? "theory" : "converged limit",
          rounded(*scene.reference, 5), scene.unit);
    if (scene.known_percent) text += fmt::format(" (known to {:.2g} %)", *scene.known_percent);
    double spread = 0;
    for (const auto& entry : scene.methods) spread = std::max(spread, entry.spread_percent);
    if (spread > 0) text += fmt::format("; repeated runs differ by {:.0f} % of the median at most", spread);
    if (scene.methods.empty()) {
      text += fmt::format(".\n\nNo price: {}.\n\n", scene.nothing);
      continue;
    }
    text += ".\n\n" + price_table(scene) + spacing_table(scene) + finer_table(scene) + "\n";
  }
  return text;
}

}  // namespace femsph::compare
