#pragma once
// Forces on places, shared out to points once; a pressure as the forces that it exerts on the area that the
// boundary has at the start.

#include <vector>

#include "model/motion/effects/effect.hpp"

namespace femsph {

class Loads : public Effect {
 public:
  explicit Loads(Motion& motion);
  struct NodalLoad {
    std::size_t slot;  ///< of the flat arrays
    double force;      ///< N at factor 1
    std::size_t load;  ///< index into Scene::loads
  };
  /// Of one of the march's deformable bodies.
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
  std::vector<std::vector<NodalLoad>> nodal_;  ///< of each deformable body
};

}  // namespace femsph
