#pragma once
// What a run keeps and what it loses, over its samples: energy, momentum, the energy in hourglass control.

#include <array>
#include <vector>

#include "model/motion/march.hpp"

namespace femsph {

/// All numbers are shares of a scale of the same run; 0: kept.
struct Drift {
  double energy = 0;            ///< largest size of Ledger::imbalance() over the largest energy of the run
  double momentum = 0;          ///< see Conservation
  double angular_momentum = 0;  ///< see Conservation
  double hourglass =
      0;  ///< largest hourglass energy over the largest internal energy (strain, hourglass, plastic work)
};

/// Looks at a march at its samples. In a scene that nothing outside pushes on
/// (EffectEntry::outside) the momenta are those of
/// all bodies at a whole step and their drift is the largest change since the start over the largest sum of
/// magnitudes, sum m |v| and sum m |x - x0||v| (x0: the centre of mass at the start). Else the outside pushes
/// too, and what tells is whether the internal forces of each body add up to zero: the largest
/// March::force_imbalance and moment_imbalance of the samples that hold at least 1e-6 of the largest energy.
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
