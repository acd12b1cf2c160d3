#pragma once
// What accuracy costs: a method's ladder of spacings with the error and the CPU time of every rung, and what
// follows from it.

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

/// Coarse to fine, with the errors that the rungs are credited with.
class PricedLadder {
 public:
  /// `dim`: how units grow, as spacing^-dim. `known_to`: errors below this (percent) are those of the
  /// reference.
  PricedLadder(std::vector<PricedRung> rungs, int dim, double known_to = 0);

  const std::vector<PricedRung>& rungs() const { return rungs_; }
  /// An error that passes through zero is small by luck. A rung is credited with the largest error of all
  /// rungs as fine or finer; a finest rung whose sign is not that of the rung before it proves nothing, so
  /// that it counts with that one's error; and no rung is credited with less than the error that the finest
  /// three head for.
  const std::vector<double>& credited() const { return credited_; }

  /// Time of a run at a spacing. Between rungs: linear in log-log. Beyond the finest: steps as 1/spacing,
  /// units as spacing^-dim, and a + b units seconds a step from the finest three rungs. Beyond the coarsest:
  /// the coarsest's.
  double cpu_at(double spacing) const;

  struct Cost {
    enum class Basis { interpolated, coarsest, extrapolated, not_reached } basis;
    double spacing = 0, cpu = 0;
    std::string reason;  ///< why it is not reached
    bool reached() const { return basis != Basis::not_reached; }
  };
  /// The coarsest spacing from which on all finer ones have at most this error, and the time there:
  /// interpolated in log-log between two rungs whose errors have one sign (else the finer of them), or by the
  /// fitted order beyond the finest rung, if the ladder heads for zero.
  Cost cost_of(double error) const;
  /// The error at a spacing, percent: credited, or by the fitted order beyond the finest. Nothing where that
  /// is not sound; then `why`.
  std::optional<double> error_at(double spacing, std::string* why = nullptr) const;
  /// The largest spacing that costs at most `cpu`, nothing if the coarsest costs more.
  std::optional<double> spacing_for(double cpu) const;

  /// Order of the error in the spacing, by least squares in log-log over the finest three or four rungs of
  /// one sign and falling error; nothing with fewer than three. `why` says why not.
  std::optional<double> order(std::string* why = nullptr) const;
  /// The error at spacing zero by Richardson's extrapolation of the finest three rungs, percent.
  std::optional<double> heading() const { return heading_; }
  /// Slopes in log-log over the rungs that `order` takes: error over CPU time.
  std::optional<double> error_over_cpu() const;
  /// CPU time over the number of unknowns, of the finest four rungs.
  std::optional<double> cpu_over_dof() const;

 private:
  /// `order`, where the errors may be extrapolated with it: they head for less than half of the finest
  /// rung's.
  std::optional<double> sound_order(std::string* why) const;
  std::size_t first_of_tail() const;  ///< the rungs from here on have one sign and a falling error

  std::vector<PricedRung> rungs_;
  std::vector<double> credited_;
  std::optional<double> heading_;
  int dim_;
  double known_to_;
  double per_step_ = 0, per_unit_ = 0;  ///< s: a and b of the model
};

/// No extrapolation to a spacing more than this many times finer than the finest rung.
inline constexpr double furthest = 10;

}  // namespace femsph::compare
