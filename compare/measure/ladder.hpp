#pragma once
// What a ladder of spacings tells: the observed order, the value at spacing zero, the spacing that an error
// asks for.

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
/// Roache 1998, 5.10). Nothing with fewer than three rungs, or if the differences do not shrink in one
/// direction.
struct Extrapolation {
  double limit, order;
};
std::optional<Extrapolation> richardson(Ladder values);

/// Orders that are those of convergence. Below: with halved spacings the differences fall by less than 0.7,
/// as those of something that grows as a logarithm do (order 0). Above: no method here has it, so that the
/// ladder is not on its way yet.
inline constexpr double least_order = 0.5, greatest_order = 6;
inline bool is_convergence(double order) { return order >= least_order && order <= greatest_order; }

/// The coarsest spacing from which on every finer one has at most the error `target`, by interpolation in
/// log-log.
struct SpacingAtError {
  double spacing;
  bool extrapolated;  ///< beyond the ladder's ends
  bool monotone;      ///< the error falls from each rung to the next finer one
};
std::optional<SpacingAtError> spacing_at_error(Ladder errors, double target);

}  // namespace femsph::compare
