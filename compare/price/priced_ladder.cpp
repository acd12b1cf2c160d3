#include "compare/price/priced_ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/measure/ladder.hpp"

namespace femsph::compare {
namespace {

bool one_sign(double a, double b) { return a * b >= 0; }

double between(double x, double x0, double y0, double x1, double y1) {
  return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

}  // namespace

PricedLadder::PricedLadder(std::vector<PricedRung> rungs, int dim, double known_to)
    : rungs_(std::move(rungs)), dim_(dim), known_to_(known_to) {
  std::sort(rungs_.begin(), rungs_.end(),
            [](const PricedRung& a, const PricedRung& b) { return a.spacing > b.spacing; });
  const std::size_t n = rungs_.size();
  Ladder errors;
  for (const PricedRung& rung : rungs_) errors.push_back({rung.spacing, rung.error});
  if (const auto extrapolation = richardson(errors)) error_at_zero_ = extrapolation->limit;
  credited_.resize(n);
  for (std::size_t i = n; i-- > 0;) {
    credited_[i] = std::max(std::abs(rungs_[i].error), std::abs(error_at_zero_.value_or(0)));
    if (i + 1 < n)
      credited_[i] = std::max(credited_[i], credited_[i + 1]);
    else if (n > 1 && !one_sign(rungs_[i].error, rungs_[i - 1].error))
      credited_[i] = std::max(credited_[i], std::abs(rungs_[i - 1].error));
  }
  // Least squares of the relative error (weights 1/y^2) for seconds a step = a + b units; a, b not negative.
  double s = 0, x = 0, xx = 0, y = 0, xy = 0;
  for (std::size_t i = n > 3 ? n - 3 : 0; i < n; ++i) {
    if (!(rungs_[i].steps > 0 && rungs_[i].units > 0 && rungs_[i].cpu > 0)) continue;
    const double each = rungs_[i].cpu / rungs_[i].steps, w = 1 / (each * each), u = rungs_[i].units;
    s += w, x += w * u, xx += w * u * u, y += w * each, xy += w * u * each;
  }
  const double d = s * xx - x * x;
  if (xx > 0) {
    per_unit_ = d > 1e-9 * s * xx ? (s * xy - x * y) / d : xy / xx;
    per_step_ = d > 1e-9 * s * xx ? (xx * y - x * xy) / d : 0;
    if (per_step_ < 0 || per_unit_ <= 0) per_step_ = 0, per_unit_ = xy / xx;
  }
}

double PricedLadder::cpu_at(double spacing) const {
  const PricedRung& finest = rungs_.back();
  if (spacing >= rungs_.front().spacing) return rungs_.front().cpu;
  if (spacing < finest.spacing) {
    const double finer = finest.spacing / spacing;
    if (per_unit_ <= 0) return finest.cpu * std::pow(finer, dim_ + 1);
    return finest.steps * finer * (per_step_ + per_unit_ * finest.units * std::pow(finer, dim_));
  }
  std::size_t fine = 1;
  while (rungs_[fine].spacing > spacing) ++fine;
  const PricedRung &c = rungs_[fine - 1], &f = rungs_[fine];
  return between(spacing, c.spacing, c.cpu, f.spacing, f.cpu);
}

std::optional<double> PricedLadder::spacing_for(double cpu) const {
  if (cpu < rungs_.front().cpu) return {};
  double coarse = rungs_.front().spacing, fine = coarse;
  while (cpu_at(fine) <= cpu && fine > 1e-6 * coarse) fine /= 2;
  coarse = 2 * fine;
  for (int turn = 0; turn < 60; ++turn) {
    const double middle = std::sqrt(coarse * fine);
    (cpu_at(middle) <= cpu ? coarse : fine) = middle;
  }
  return std::min(coarse, rungs_.front().spacing);
}

std::size_t PricedLadder::first_of_tail() const {
  std::size_t first = rungs_.size() - 1;
  while (first > 0 && one_sign(rungs_[first - 1].error, rungs_.back().error) &&
         std::abs(rungs_[first - 1].error) > std::abs(rungs_[first].error))
    --first;
  return first;
}

std::optional<double> PricedLadder::order(std::string* why) const {
  const auto no = [&](const std::string& reason) -> std::optional<double> {
    if (why) *why = reason;
    return {};
  };
  const std::size_t n = rungs_.size();
  if (n < 3) return no("fewer than three spacings");
  const std::size_t first = first_of_tail();
  if (n - first < 3) {
    if (!one_sign(rungs_[n - 1].error, rungs_[n - 2].error) ||
        (first + 1 < n && first > 0 && !one_sign(rungs_[first - 1].error, rungs_[first].error)))
      return no("the error changes its sign among the finest three spacings");
    return no("the error does not fall over the finest three spacings");
  }
  if (rungs_.back().error == 0) return no("an error of zero");
  Ladder tail;
  for (std::size_t i = std::max(first, n > 4 ? n - 4 : 0); i < n; ++i)
    tail.push_back({rungs_[i].spacing, rungs_[i].error});
  const auto pairs = pairwise_orders({tail.end() - 3, tail.end()});
  const auto [low, high] = std::minmax(pairs[0], pairs[1]);
  if (low < 0.25 || high > 2.5 * low)
    return no(fmt::format("no one order: {:.2f}, then {:.2f}", pairs[0], pairs[1]));
  return fitted_order(tail);
}

std::optional<double> PricedLadder::sound_order(std::string* why) const {
  std::string reason;
  const auto p = order(&reason);
  if (!p && !(error_at_zero_ && reason.starts_with("no one order"))) {
    if (why) *why = reason;
    return {};
  }
  if (p && error_at_zero_ && std::abs(*error_at_zero_) <= 0.5 * std::abs(rungs_.back().error)) return p;
  const bool elsewhere = error_at_zero_ && std::abs(*error_at_zero_) > 0.5 * std::abs(rungs_.back().error);
  if (why)
    *why = !p && !elsewhere ? reason
           : error_at_zero_
               ? fmt::format("the finest three spacings extrapolate to an error of {:+.2g} %, not to zero",
                             *error_at_zero_)
               : "the finest three spacings do not approach a limit";
  return {};
}

PricedLadder::Cost PricedLadder::cost_of(double target) const {
  using Basis = Cost::Basis;
  const std::size_t n = rungs_.size();
  const auto no = [](const std::string& why) { return Cost{Basis::not_reached, 0, 0, why}; };
  if (n < 2) return no("fewer than two spacings");
  if (target < known_to_) return no(fmt::format("the reference is known to {:.2g} %", known_to_));
  if (credited_.back() <= target) {
    std::size_t fine = n - 1;
    while (fine > 0 && credited_[fine - 1] <= target) --fine;
    if (fine == 0) return {Basis::coarsest, rungs_[0].spacing, rungs_[0].cpu, ""};
    const PricedRung &c = rungs_[fine - 1], &f = rungs_[fine];
    double spacing = f.spacing;
    if (one_sign(c.error, f.error) && credited_[fine] > 0)
      spacing = between(target, credited_[fine - 1], c.spacing, credited_[fine], f.spacing);
    return {Basis::interpolated, spacing, cpu_at(spacing), ""};
  }
  std::string why;
  const auto p = sound_order(&why);
  if (!p) return no(why);
  const double spacing = rungs_.back().spacing * std::pow(target / credited_.back(), 1 / *p);
  if (spacing < rungs_.back().spacing / furthest)
    return no(
        fmt::format("more than {:g} times finer than the finest run, {:.2g} %", furthest, credited_.back()));
  return {Basis::extrapolated, spacing, cpu_at(spacing), ""};
}

std::optional<double> PricedLadder::error_at(double spacing, std::string* why) const {
  if (rungs_.empty()) return {};
  if (spacing >= rungs_.front().spacing) return credited_.front();
  for (std::size_t fine = 1; fine < rungs_.size(); ++fine) {
    const PricedRung &c = rungs_[fine - 1], &f = rungs_[fine];
    if (f.spacing > spacing) continue;
    if (spacing == f.spacing || credited_[fine] <= 0) return credited_[fine];
    if (!one_sign(c.error, f.error)) return credited_[fine - 1];
    return between(spacing, c.spacing, credited_[fine - 1], f.spacing, credited_[fine]);
  }
  const auto p = sound_order(why);
  if (!p) return {};
  if (spacing < rungs_.back().spacing / furthest) {
    if (why) *why = fmt::format("more than {:g} times finer than the finest run", furthest);
    return {};
  }
  return std::max(known_to_, credited_.back() * std::pow(spacing / rungs_.back().spacing, *p));
}

std::optional<double> PricedLadder::error_over_cpu() const {
  if (!order()) return {};
  Ladder tail;
  for (std::size_t i = std::max(first_of_tail(), rungs_.size() > 4 ? rungs_.size() - 4 : 0);
       i < rungs_.size(); ++i)
    tail.push_back({rungs_[i].cpu, rungs_[i].error});
  return fitted_order(tail);
}

std::optional<double> PricedLadder::cpu_over_dof() const {
  Ladder all;
  for (std::size_t i = rungs_.size() > 4 ? rungs_.size() - 4 : 0; i < rungs_.size(); ++i)
    all.push_back({rungs_[i].dof, rungs_[i].cpu});
  return fitted_order(all);
}

}  // namespace femsph::compare
