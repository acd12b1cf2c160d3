#include "model/motion/effects/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace femsph {

EffectEntry contact_effect() {
  EffectEntry e{{"contact", "bodies that press on each other where they touch (a penalty)"}};
  e.asked_by = "[[contacts]]";
  e.on = [](const Scene& s) {
    return std::any_of(s.contacts.begin(), s.contacts.end(), [](const Contact& c) { return !c.tied; });
  };
  e.rank_off = 7;
  e.named_off = [](const Scene& s) { return s.contacts.empty(); };
  e.make = make_effect<ContactOfBodies>;
  return e;
}

ContactOfBodies::ContactOfBodies(Motion& motion) : scene_(motion.scene) {
  std::vector<ContactPair::Party> party;
  std::size_t rigid = 0, deformable = 0;
  for (const Body& body : scene_.bodies) party.push_back({body.rigid, body.rigid ? rigid++ : deformable++});
  for (const Contact& contact : scene_.contacts)
    if (!contact.tied)
      pairs_.emplace_back(
          scene_, contact, std::array{party[contact.between[0]], party[contact.between[1]]}, motion.bodies);
}

void ContactOfBodies::push_between(Motion& motion) {
  for (ContactPair& pair : pairs_) {
    PhaseTimer timer(motion.price, "contact");
    try {
      pair.add_forces(motion.bodies, motion.rigid, motion.step, motion.dt);
    } catch (const MotionError& error) {
      if (motion.step == 0) throw;
      throw Stopped(Stopped::Watch::contact, error.what());
    }
  }
}

double ContactOfBodies::add_springs(const Motion& motion, std::size_t index, double frequency2,
                                    AlignedVector<double>& springs) const {
  double limit = std::numeric_limits<double>::infinity();
  for (const ContactPair& pair : pairs_)
    limit = std::min(limit, pair.add_springs(index, motion.bodies[index], motion.rigid, frequency2, springs));
  return limit;
}

void ContactOfBodies::add_energies(Ledger& l) const {
  for (const ContactPair& pair : pairs_) {
    l.contact += pair.stored();
    l.friction += pair.friction_loss();
  }
}

void ContactOfBodies::state(Archive& archive) {
  for (ContactPair& pair : pairs_)
    archive.below("contact " + pair.contact().name, [&] { pair.state(archive); });
}

std::size_t ContactOfBodies::touching() const {
  std::size_t points = 0;
  for (const ContactPair& pair : pairs_) points += pair.touching();
  return points;
}

void ContactOfBodies::contact_forces(std::vector<Point>& forces) const {
  for (const ContactPair& pair : pairs_)
    forces[std::size_t(&pair.contact() - scene_.contacts.data())] = pair.force();
}

void ContactOfBodies::describe(const Motion& motion,
                               std::vector<std::pair<std::string, std::string>>& lines) const {
  for (const ContactPair& pair : pairs_) {
    lines.emplace_back(
        "contact " + pair.contact().name,
        fmt::format("penalty {:.4g} Pa/m, friction {:g}", pair.stiffness(), pair.contact().friction));
    if (motion.step > 0)
      lines.emplace_back(
          pair.contact().name + " depth",
          fmt::format("{:.4g} m at most, {:.3g} of the spacing", pair.deepest(), pair.deepest_share()));
  }
}

}  // namespace femsph
