#pragma once
// A ladder is a series of runs that differ in their spacing alone; each run is a rung. It gives the observed
// order of convergence, the value at spacing zero, and the spacing for a given error.

#include <optional>
#include <vector>

namespace femsph::compare {

/// One rung: a spacing (any unit) and an error or a value there.
struct Rung {
  double spacing, value;
};
using Ladder = std::vector<Rung>;

/// log(e_1/e_2)/log(d_1/d_2) of neighbouring rungs, coarse to fine; errors by magnitude. NaN where an error
/// is 0.
std::vector<double> pairwise_orders(Ladder errors);
/// Slope of the least-squares line of log|error| over log(spacing). Nothing with fewer than two rungs or with
/// an error of 0.
std::optional<double> fitted_order(const Ladder& errors);

/// value(d) = limit + C d^order through the three finest rungs (Richardson 1911; for any ratio of spacings,
/// Roache 1998, 5.10). Nothing with fewer than three rungs, or unless the differences have one
/// sign and shrink.
struct Extrapolation {
  double limit, order;
};
std::optional<Extrapolation> richardson(Ladder values);

/// Observed orders that count as convergence. Below 0.5, halving the spacing leaves more than 0.7 of the
/// difference before, as for a value that grows like a logarithm (order 0). No method here has an order above
/// 6: if one is observed, the spacings are too coarse to extrapolate from.
inline constexpr double least_order = 0.5, greatest_order = 6;
inline bool is_convergence(double order) { return order >= least_order && order <= greatest_order; }

/// The coarsest spacing such that it and all finer ones have at most the error `target`, by interpolation in
/// log-log.
struct SpacingAtError {
  double spacing;
  bool extrapolated;  ///< beyond the ladder's ends
  bool monotone;      ///< the error falls from each rung to the next finer one
};
std::optional<SpacingAtError> spacing_at_error(Ladder errors, double target);

}  // namespace femsph::compare
