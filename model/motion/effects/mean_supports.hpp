#pragma once
// Supports that fix the weighted mean displacement of a place, sum_i w_i u_i = 0, so that the place can
// rotate. The reaction is a force R w_i on each point i of the place.
//
// A mean at rest stays at rest if sum_i w_i f_i / m_i = 0. This holds with f_i += R w_i and
//   R = -(sum w f/m) / (sum w^2/m).
// The reaction does no work, since sum_i w_i v_i = 0 at every half step.

#include <vector>

#include "model/motion/effects/effect.hpp"

namespace femsph {

class MeanSupports : public Effect {
 public:
  /// Call it after hold_components(): a component that another support fixes takes no part.
  explicit MeanSupports(Motion& motion);
  /// One component whose mean is fixed.
  struct MeanHold {
    std::size_t body;  ///< index among the deformable bodies
    std::vector<std::size_t> slots;
    std::vector<double> weights;
    double inverse_mass = 0;  ///< sum_i w_i^2 / m_i, 1/kg
    double reaction = 0;      ///< R at the present step, N
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
