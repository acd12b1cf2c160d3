#pragma once
// Distances between numbers, profiles and histories.

#include <optional>
#include <span>
#include <vector>

#include "compare/reference/reference_table.hpp"

namespace femsph::compare {

/// 100 (value/reference - 1): positive when the value is larger in magnitude. Nothing if the reference is 0.
std::optional<double> percent_error(double value, double reference);

/// 100 sqrt(integral (v - r)^2 / integral r^2) over x, both by the trapezoid rule. Nothing if r is 0
/// everywhere. Throws std::invalid_argument if the three differ in length or have fewer than two entries.
std::optional<double> percent_l2(std::span<const double> x, std::span<const double> value,
                                 std::span<const double> reference);

/// Values at other abscissas, linear in between; NaN beyond the ends (with a slack of 1e-9 of the range). x
/// increases.
std::vector<double> resample(std::span<const double> x, std::span<const double> value,
                             std::span<const double> at);

/// Frequency (Hz, if time is in s) of the slowest strong oscillation of a history: one over the mean time
/// between crossings of the middle level in the same direction. A crossing counts once the history has left a
/// band of a tenth of the range on either side, so that small ripples do not count. Nothing if the history
/// does not oscillate, or by less than 1e-9 of its magnitude.
std::optional<double> dominant_frequency(std::span<const double> time, std::span<const double> value);

/// percent_l2 of a history from the table, over the times that both have. Throws std::runtime_error if there
/// are none, or if the table is zero.
double percent_from(const ReferenceTable& table, const std::vector<double>& at,
                    const std::vector<double>& value);

}  // namespace femsph::compare
