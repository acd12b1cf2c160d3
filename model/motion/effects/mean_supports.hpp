#pragma once
// Supports that hold the weighted mean over a place, so that the place may turn: sum_i w_i u_i = 0, by the
// forces R w_i.
//
// A mean that stands still stays still if sum_i w_i f_i / m_i = 0: f_i += R w_i with
//   R = -(sum w f/m) / (sum w^2/m).
// These forces do no work, since sum_i w_i v_i = 0 at every half step.

#include <vector>

#include "model/motion/effects/effect.hpp"

namespace femsph {

class MeanSupports : public Effect {
 public:
  /// After hold_components(): a held component takes no part.
  explicit MeanSupports(Motion& motion);
  /// A component whose mean is held.
  struct MeanHold {
    std::size_t body;  ///< of the march's deformable bodies
    std::vector<std::size_t> slots;
    std::vector<double> weights;
    double inverse_mass = 0;  ///< sum_i w_i^2 / m_i, 1/kg
    double reaction = 0;      ///< R, N, now
  };
  const std::vector<MeanHold>& holds() const { return holds_; }

  void constrain_start(Motion& motion) override;
  void constrain(Motion& motion) override;
  void each_reaction(const Motion& motion, const MovingBody& body,
                     const std::function<void(std::size_t slot, double)>& take) const override;

 private:
  void place(const Motion& motion, MovingBody& body, const Support& support);

  std::vector<MeanHold> holds_;
};

}  // namespace femsph
