#pragma once
// Loads. Total forces are distributed over the points of their places once, when the effect is made; so is a
// pressure, over the undeformed boundary.

#include <vector>

#include "model/motion/effects/effect.hpp"

namespace femsph {

class Loads : public Effect {
 public:
  explicit Loads(Motion& motion);
  struct NodalLoad {
    std::size_t slot;  ///< index of the component in the flat vectors
    double force;      ///< N, at a factor of 1 of the history
    std::size_t load;  ///< index into Scene::loads
  };
  /// The loads on one of the deformable bodies.
  const std::vector<NodalLoad>& on(const Motion& motion, const MovingBody& body) const {
    return nodal_[std::size_t(&body - motion.bodies.data())];
  }

  void push_body(const Motion& motion, MovingBody& body) override;
  void push_rigid(const Motion& motion, RigidBody& body) override;
  void work_on_body(const Motion& motion, const MovingBody& body, double& work) const override;
  void work_on_rigid(const Motion& motion, const RigidBody& body, double& work) const override;
  bool changes_after(double t) const override;
  void each_force(const Motion& motion, const MovingBody& body, const TakeForce& take) const override;
  Point excess_force(const Motion& motion, const MovingBody& body) const override;
  void each_force_on_rigid(const Motion& motion, const RigidBody& body,
                           const std::function<void(const Point&)>& take) const override;
  void size_on_body(const Motion& motion, const MovingBody& body, double& sum) const override;
  void size_on_rigid(const Motion& motion, const RigidBody& body, double& sum) const override;

 private:
  void share_out(const Motion& motion, const MovingBody& body, std::size_t load);
  void share_out_pressure(const Motion& motion, const MovingBody& body, std::size_t load);

  const Scene& scene_;
  std::vector<std::vector<NodalLoad>> nodal_;  ///< for each deformable body
};

}  // namespace femsph
