#include "model/motion/effects/tied_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace femsph {

EffectEntry tied_bodies_effect() {
  EffectEntry e{{"tied bodies", "bodies that are bonded where they touch at the start"}};
  e.asked_by = "[[contacts]] kind = \"tied\"";
  e.on = [](const Scene& s) {
    return std::any_of(s.contacts.begin(), s.contacts.end(), [](const Contact& c) { return c.tied; });
  };
  e.listed_off = false;
  e.make = make_effect<TiedBodies>;
  return e;
}

void TiedBodies::constrain(Motion& motion) {
  PhaseTimer timer(motion.price, "contact");
  const auto [keep, push] = motion.leap(0.5 * (motion.dt + motion.next_dt));
  ties_.add_forces(motion.bodies, keep, push, motion.next_dt, motion.dt, motion.step == 0);
}

void TiedBodies::state(Archive& archive) {
  archive.below("ties", [&] { ties_.state(archive); });
}

void TiedBodies::contact_forces(std::vector<Point>& forces) const {
  for (const Ties::Bond& bond : ties_.bonds())
    forces[std::size_t(bond.contact - scene_.contacts.data())] = bond.force;
}

void TiedBodies::describe(const Motion& motion,
                          std::vector<std::pair<std::string, std::string>>& lines) const {
  for (const Ties::Bond& bond : ties_.bonds())
    lines.emplace_back("contact " + bond.contact->name,
                       fmt::format("{} points of {} tied to facets of {}", bond.end - bond.begin,
                                   motion.bodies[bond.from].name, motion.bodies[bond.onto].name));
}

}  // namespace femsph
