#pragma once
// Contact as an effect: all contacts of a scene that are not tied (contact_pair.hpp has one of them).

#include <vector>

#include "model/motion/effects/contact_pair.hpp"
#include "model/motion/effects/effect.hpp"

namespace femsph {

class ContactOfBodies : public Effect {
 public:
  explicit ContactOfBodies(Motion& motion);
  const std::vector<ContactPair>& pairs() const { return pairs_; }

  void push_between(Motion& motion) override;
  double add_springs(const Motion& motion, std::size_t index, double frequency2,
                     AlignedVector<double>& springs) const override;
  void add_energies(Ledger& l) const override;
  void state(Archive& archive) override;
  std::size_t touching() const override;
  bool bodies_may_part() const override { return true; }
  void contact_forces(std::vector<Point>& forces) const override;
  void describe(const Motion& motion, std::vector<std::pair<std::string, std::string>>& lines) const override;

 private:
  const Scene& scene_;
  std::vector<ContactPair> pairs_;
};

}  // namespace femsph
