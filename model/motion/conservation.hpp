#pragma once
// How well a run conserves energy and momentum, over its samples, and how much energy is in hourglass
// control.

#include <array>
#include <vector>

#include "model/motion/march.hpp"

namespace femsph {

/// All numbers are relative to a scale of the same run; 0: conserved.
struct Drift {
  double energy = 0;            ///< largest |Ledger::imbalance()| over the largest energy of the run
  double momentum = 0;          ///< see Conservation
  double angular_momentum = 0;  ///< see Conservation
  double hourglass =
      0;  ///< largest hourglass energy over the largest internal energy (strain, hourglass, plastic work)
};

/// Collects these numbers at the samples of a run. In a scene without external forces (EffectEntry::outside),
/// the drift of momentum is its largest change since the start, of all bodies together, over the largest sum
/// of magnitudes: sum m |v|, and sum m |x - x0||v| for angular momentum, x0 being the initial centre of mass.
/// In other scenes it is the largest March::force_imbalance and moment_imbalance, whether the internal forces
/// of each body sum to zero, of the samples that have at least 1e-6 of the largest energy.
class Conservation {
 public:
  explicit Conservation(const March& march);
  void sample(const March& march);
  Drift drift() const;

 private:
  struct Sample {
    double energy, force, moment;
  };
  void sample_free(const March& march);
  bool free_;
  Point centre_{};
  bool started_ = false;
  std::array<Point, 2> start_{};  ///< linear and angular momentum
  std::array<double, 2> change_{}, scale_{};
  std::vector<Sample> samples_;
  double imbalance_ = 0, energy_ = 0, hourglass_ = 0, internal_ = 0;
};

}  // namespace femsph
