#include "compare/measure/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace femsph::compare {
namespace {

void coarse_first(Ladder& ladder) {
  std::sort(ladder.begin(), ladder.end(), [](const Rung& a, const Rung& b) { return a.spacing > b.spacing; });
}

double slope(const Rung& coarse, const Rung& fine) {
  return std::log(coarse.value / fine.value) / std::log(coarse.spacing / fine.spacing);
}

}  // namespace

std::vector<double> pairwise_orders(Ladder errors) {
  coarse_first(errors);
  for (Rung& rung : errors) rung.value = std::abs(rung.value);
  std::vector<double> orders;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const bool known = errors[i - 1].value > 0 && errors[i].value > 0;
    orders.push_back(known ? slope(errors[i - 1], errors[i]) : std::numeric_limits<double>::quiet_NaN());
  }
  return orders;
}

std::optional<double> fitted_order(const Ladder& errors) {
  const double n = double(errors.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Rung& rung : errors) {
    if (rung.value == 0) return {};
    const double lx = std::log(rung.spacing), ly = std::log(std::abs(rung.value));
    x += lx, y += ly, xx += lx * lx, xy += lx * ly;
  }
  const double denominator = n * xx - x * x;
  if (errors.size() < 2 || denominator <= 1e-12 * n * xx) return {};
  return (n * xy - x * y) / denominator;
}

std::optional<Extrapolation> richardson(Ladder values) {
  if (values.size() < 3) return {};
  coarse_first(values);
  const Rung &c = values[values.size() - 3], &m = values[values.size() - 2], &f = values[values.size() - 1];
  const double ratio = (c.value - m.value) / (m.value - f.value);
  // ratio = (d_c^p - d_m^p)/(d_m^p - d_f^p) grows with p, from log(d_c/d_m)/log(d_m/d_f) at p = 0.
  const auto at = [&](double p) {
    const double a = std::pow(c.spacing / f.spacing, p), b = std::pow(m.spacing / f.spacing, p);
    return (a - b) / (b - 1);
  };
  double low = 1e-6, high = 20;
  if (!std::isfinite(ratio) || ratio <= at(low) || ratio >= at(high)) return {};
  for (int turn = 0; turn < 60; ++turn) {
    const double middle = (low + high) / 2;
    (at(middle) < ratio ? low : high) = middle;
  }
  const double order = (low + high) / 2;
  return Extrapolation{f.value - (m.value - f.value) / (std::pow(m.spacing / f.spacing, order) - 1), order};
}

std::optional<SpacingAtError> spacing_at_error(Ladder errors, double target) {
  if (errors.size() < 2 || !(target > 0)) return {};
  coarse_first(errors);
  bool monotone = true;
  for (Rung& rung : errors) {
    rung.value = std::abs(rung.value);
    if (!(rung.value > 0)) return {};
  }
  for (std::size_t i = 1; i < errors.size(); ++i) monotone &= errors[i].value < errors[i - 1].value;

  // Interpolate on the finest segment on which the error passes the target, or extrapolate from the end.
  std::size_t fine = errors.size() - 1;
  const bool beyond_fine = errors[fine].value > target;
  if (!beyond_fine)
    while (fine > 0 && errors[fine - 1].value <= target) --fine;
  const bool beyond_coarse = !beyond_fine && fine == 0;
  if (beyond_coarse) fine = 1;
  const Rung& from = beyond_coarse ? errors[0] : errors[fine];
  const double order = slope(errors[fine - 1], errors[fine]);
  if (order <= 0)
    return beyond_coarse ? std::optional(SpacingAtError{from.spacing, true, monotone}) : std::nullopt;
  return SpacingAtError{
      from.spacing * std::pow(target / from.value, 1 / order), beyond_fine || beyond_coarse, monotone};
}

}  // namespace femsph::compare
