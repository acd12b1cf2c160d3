#pragma once
// Tied bodies as an effect (ties.hpp has the equations).

#include "model/motion/effects/effect.hpp"
#include "model/motion/effects/ties.hpp"

namespace femsph {

class TiedBodies : public Effect {
 public:
  explicit TiedBodies(Motion& motion) : scene_(motion.scene), ties_(motion.scene, motion.bodies) {}
  const Ties& ties() const { return ties_; }

  /// Bodies that start with different velocities lose energy when these are made equal at the bond.
  void constrain_start(Motion& motion) override { ties_.match_velocities(motion.bodies); }
  void constrain(Motion& motion) override;
  void add_energies(Ledger& l) const override { l.contact += ties_.taken(); }
  void state(Archive& archive) override;
  void contact_forces(std::vector<Point>& forces) const override;
  void describe(const Motion& motion, std::vector<std::pair<std::string, std::string>>& lines) const override;

 private:
  const Scene& scene_;
  Ties ties_;
};

}  // namespace femsph
