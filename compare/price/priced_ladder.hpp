#pragma once
// What accuracy costs: the runs of one method at several spacings (a ladder), with the error and the CPU time
// of each run (a rung), and what follows from them.

#include <optional>
#include <string>
#include <vector>

namespace femsph::compare {

struct PricedRung {
  double spacing;  ///< any unit, the same for all
  double error;    ///< percent, with its sign
  double cpu;      ///< s, of the whole run
  double steps = 0, units = 0, dof = 0, memory = 0;
  double cpu_min = 0, cpu_max = 0;  ///< s, of repeated runs
};

/// Rungs from coarse to fine, with credited errors.
class PricedLadder {
 public:
  /// The number of units grows as spacing^-dim. `known_to`: how well the reference is known, percent: smaller
  /// errors mean nothing.
  PricedLadder(std::vector<PricedRung> rungs, int dim, double known_to = 0);

  const std::vector<PricedRung>& rungs() const { return rungs_; }
  /// The error that each rung counts with, percent, not negative. Where the error changes its sign with the
  /// spacing, it is small by chance. So a rung counts with the largest |error| of all rungs that are as fine
  /// or finer; the finest counts with the error of the rung before it if their signs differ; and none counts
  /// with less than the error at spacing zero that the finest three extrapolate to.
  const std::vector<double>& credited() const { return credited_; }

  /// CPU time of a run at a spacing, s. Between rungs: linear in log-log. Beyond the finest: steps grow as
  /// 1/spacing, units as spacing^-dim, and a step takes a + b units seconds, fitted to the finest three
  /// rungs. Beyond the coarsest: that of the coarsest.
  double cpu_at(double spacing) const;

  struct Cost {
    enum class Basis { interpolated, coarsest, extrapolated, not_reached } basis;
    double spacing = 0, cpu = 0;
    std::string reason;  ///< why it is not reached
    bool reached() const { return basis != Basis::not_reached; }
  };
  /// The coarsest spacing such that it and all finer ones have at most this error (percent), and the time
  /// there: interpolated in log-log between two rungs whose errors have one sign (else the finer of them);
  /// beyond the finest rung by the fitted order, if the errors extrapolate to nearly zero.
  Cost cost_of(double error) const;
  /// The error at a spacing, percent: the credited one, or by the fitted order beyond the finest rung.
  /// Nothing where extrapolation is not allowed; `why` says why.
  std::optional<double> error_at(double spacing, std::string* why = nullptr) const;
  /// The smallest spacing that takes at most `cpu` seconds; nothing if even the coarsest takes longer.
  std::optional<double> spacing_for(double cpu) const;

  /// Order of the error in the spacing, by least squares in log-log over the finest three or four rungs whose
  /// errors have one sign and fall; nothing with fewer than three such rungs, and `why` says why.
  std::optional<double> order(std::string* why = nullptr) const;
  /// The error at spacing zero by Richardson's extrapolation of the finest three rungs, percent.
  std::optional<double> error_at_zero() const { return error_at_zero_; }
  /// Slope in log-log of the error over the CPU time, over the rungs that `order` uses.
  std::optional<double> error_over_cpu() const;
  /// Slope in log-log of the CPU time over the number of unknowns, over the finest four rungs.
  std::optional<double> cpu_over_dof() const;

 private:
  /// `order`, where errors may be extrapolated with it: at spacing zero they extrapolate to less than half of
  /// the error of the finest rung.
  std::optional<double> sound_order(std::string* why) const;
  std::size_t first_of_tail() const;  ///< the rungs from here on have one sign and a falling error

  std::vector<PricedRung> rungs_;
  std::vector<double> credited_;
  std::optional<double> error_at_zero_;
  int dim_;
  double known_to_;
  double per_step_ = 0, per_unit_ = 0;  ///< s: a and b of the model
};

/// No extrapolation to a spacing more than this many times finer than the finest rung.
inline constexpr double furthest = 10;

}  // namespace femsph::compare
