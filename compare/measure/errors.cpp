#include "compare/measure/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace femsph::compare {
namespace {

/// Times at which `value` rises through `level`: each counts if it was below level - band before, and is
/// above level + band before it falls again.
std::vector<double> rising_crossings(std::span<const double> time, std::span<const double> value,
                                     double level, double band) {
  std::vector<double> crossings;
  bool armed = false;
  double last = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (i > 0 && value[i - 1] < level && value[i] >= level)
      last = time[i - 1] + (time[i] - time[i - 1]) * (level - value[i - 1]) / (value[i] - value[i - 1]);
    if (value[i] < level - band) armed = true;
    if (armed && value[i] > level + band) {
      crossings.push_back(last);
      armed = false;
    }
  }
  return crossings;
}

}  // namespace

std::optional<double> percent_error(double value, double reference) {
  if (reference == 0) return {};
  return 100 * (value / reference - 1);
}

std::optional<double> percent_l2(std::span<const double> x, std::span<const double> value,
                                 std::span<const double> reference) {
  if (x.size() < 2 || value.size() != x.size() || reference.size() != x.size())
    throw std::invalid_argument("profiles to compare need the same points, two or more");
  double error = 0, norm = 0;
  for (std::size_t i = 1; i < x.size(); ++i)
    for (const std::size_t k : {i - 1, i}) {
      const double weight = (x[i] - x[i - 1]) / 2, difference = value[k] - reference[k];
      error += weight * difference * difference;
      norm += weight * reference[k] * reference[k];
    }
  if (norm == 0) return {};
  return 100 * std::sqrt(error / norm);
}

std::vector<double> resample(std::span<const double> x, std::span<const double> value,
                             std::span<const double> at) {
  if (x.empty() || value.size() != x.size())
    throw std::invalid_argument("resampling needs as many values as abscissas, one or more");
  const double slack = 1e-9 * (x.back() - x.front());
  std::vector<double> out;
  out.reserve(at.size());
  for (const double p : at) {
    if (!(p >= x.front() - slack && p <= x.back() + slack)) {
      out.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const std::size_t next = std::upper_bound(x.begin(), x.end(), p) - x.begin();
    if (next == 0)
      out.push_back(value.front());
    else if (next == x.size())
      out.push_back(value.back());
    else
      out.push_back(
          value[next - 1] + (p - x[next - 1]) / (x[next] - x[next - 1]) * (value[next] - value[next - 1]));
  }
  return out;
}

std::optional<double> dominant_frequency(std::span<const double> time, std::span<const double> value) {
  if (value.size() < 3 || value.size() != time.size()) return {};
  if (std::any_of(value.begin(), value.end(), [](double v) { return !std::isfinite(v); })) return {};
  const auto [low, high] = std::minmax_element(value.begin(), value.end());
  const double level = (*low + *high) / 2, band = (*high - *low) / 10;
  if (10 * band <= 1e-9 * std::max(std::abs(*low), std::abs(*high)))
    return {};  // at rest: only round-off oscillates
  std::vector<double> mirrored(value.begin(), value.end());
  for (double& v : mirrored) v = 2 * level - v;
  double span = 0;
  std::size_t periods = 0;
  for (const auto& crossings :
       {rising_crossings(time, value, level, band), rising_crossings(time, mirrored, level, band)}) {
    if (crossings.size() < 2) continue;
    span += crossings.back() - crossings.front();
    periods += crossings.size() - 1;
  }
  if (periods == 0) return {};
  return double(periods) / span;
}

double percent_from(const ReferenceTable& table, const std::vector<double>& at,
                    const std::vector<double>& value) {
  std::vector<double> times, values;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i] >= table.at.front() && at[i] <= table.at.back())
      times.push_back(at[i]), values.push_back(value[i]);
  if (times.size() < 2) throw std::runtime_error("the history and the reference have no time in common");
  const auto percent = percent_l2(times, values, resample(table.at, table.value, times));
  if (!percent) throw std::runtime_error("the reference is zero");
  return *percent;
}

}  // namespace femsph::compare
