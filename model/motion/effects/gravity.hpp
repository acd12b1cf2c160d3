#pragma once
// Gravity: the weight of the bodies and its work.

#include <span>

#include "model/motion/effects/effect.hpp"

namespace femsph {

/// f += m g, for every point. `f` is a flat vector (N) of layout `at`.
void add_weight(const Layout& at, std::span<const double> mass, const Point& g, double* f);

/// The power sum_i m_i v_i . g (W) of the weight at the velocities `v` (m/s, flat). The same to the last bit
/// for any number of threads.
double power_of_weight(const Layout& at, std::span<const double> mass, const Point& g, const double* v);

class Gravity : public Effect {
 public:
  explicit Gravity(Motion& motion);
  void push_body(const Motion& motion, MovingBody& body) override;
  void work_on_body(const Motion& motion, const MovingBody& body, double& work) const override;
  void work_on_rigid(const Motion& motion, const RigidBody& body, double& work) const override;
  void each_force(const Motion& motion, const MovingBody& body, const TakeForce& take) const override;
  void size_on_body(const Motion& motion, const MovingBody& body, double& sum) const override;

 private:
  Point g_;  ///< m/s^2
};

}  // namespace femsph
