#include <fmt/format.h>

#include <algorithm>

#include "compare/price/comparisons.hpp"
#include "compare/price/price_tables.hpp"

namespace femsph::compare {
namespace {

using PriceCells = std::vector<std::vector<std::string>>;

std::string times(double ratio) {
  return ratio < 9.95 ? fmt::format("{:.1f}x", ratio)
         : fmt::format("{:.2g}x", ratio) == "1e+01x"
             ? "10x"
             : rounded(ratio, 2) + "x";
}

std::string price_cell(const PricedLadder::Cost& cost, double least) {
  if (!cost.reached()) return "-";
  const char* mark = cost.basis == PricedLadder::Cost::Basis::extrapolated ? "~"
                     : cost.basis == PricedLadder::Cost::Basis::coarsest
                         ? "<"
                         : "";
  return fmt::format(
      "{}{} s, {}, {} mm", mark, rounded(cost.cpu, 2), times(cost.cpu / least), rounded(cost.spacing, 2));
}

std::string price_table(const PricedScene& scene) {
  PriceCells cells{{"method", "order", "error ~ CPU^", "CPU ~ dof^", "ns"}};
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
  PriceCells cells{{"method", "error %", "CPU s", "times the cheapest"}};
  for (const AtSpacing& one : all)
    cells.push_back(
        {one.method, fmt::format("{:+.2f}", one.error), rounded(one.cpu, 2), times(one.ratio_to_cheapest)});
  return fmt::format("\nAll at {:g} mm:\n\n", 1e3 * *scene.spec->spacing) + markdown_table(cells);
}

std::string finer_table(const PricedScene& scene) {
  const auto all = finer(scene);
  if (all.empty()) return "";
  PriceCells cells{{"method", "error", "times finer", "price ratio", "price ratio if 10x finer"}};
  for (const Finer& one : all)
    if (one.method.starts_with("sph") || one.method.find("=sph") != std::string::npos)
      cells.push_back({one.method, fmt::format("{:g} %", one.error),
                       (one.extrapolated ? "~" : "") + rounded(one.finer, 2),
                       (one.extrapolated ? "~" : "") + rounded(one.dearer, 2),
                       rounded(one.dearer_if_ten_times_finer, 2)});
  if (cells.size() == 1) return "";
  return fmt::format("\nSPH for the same error as {}:\n\n", scene.spec->base) + markdown_table(cells);
}

}  // namespace

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
