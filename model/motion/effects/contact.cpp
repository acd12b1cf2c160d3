#include "model/motion/effects/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/scene/tables/reading.hpp"

namespace femsph {

namespace {

using namespace scene_reader;

KeyTable contact_keys() {
  return {
      "[[contacts]]",
      "Contact between two bodies, or a bond between them.",
      {{"between", key_holds::texts, "The names of the two bodies.", true},
       {"kind", key_holds::words(std::vector<std::string>{"press", "tied"}),
        "\"press\": the bodies may touch, slide and separate. \"tied\": surfaces that touch at the start "
        "stay bonded. \"press\" unless given."},
       {"stiffness", key_holds::number, "A factor above 0 on the default penalty stiffness. 1 unless given."},
       {"friction", key_holds::number, "Coulomb's coefficient of friction. 0 unless given."},
       {"name", key_holds::text,
        "The name of its columns in the history: contact_NAME_force_x, .. BODY1-BODY2 unless given."}}};
}

std::optional<std::array<std::size_t, 2>> read_between(Fields& fields, const Reading& reading) {
  const std::string expected = "two bodies, such as [\"weight\", \"beam\"]";
  const auto given = fields.texts("between", Need::required, expected);
  if (!given) return {};
  if (given->size() != 2 || (*given)[0] == (*given)[1])
    return fields.fault(
               "between", fmt::format("\"between\" does not name two bodies; expected {}", expected)),
           std::nullopt;
  const std::vector<std::string> names = body_names(reading.scene);
  if (names.empty()) return {};  // said where bodies are read
  std::array<std::size_t, 2> between{};
  for (int k = 0; k < 2; ++k) {
    const auto body = fields.position_of((*given)[k], names, "between", "body");
    if (!body) return {};
    between[k] = *body;
  }
  if (reading.scene.bodies[between[0]].rigid && reading.scene.bodies[between[1]].rigid)
    return fields.fault("between", "both bodies are rigid; expected one at least that deforms"), std::nullopt;
  return between;
}

std::string read_contact_name(Fields& fields, const Contact& contact, const Reading& reading) {
  const auto& bodies = reading.scene.bodies;
  const std::string standing = fmt::format(
      "{}-{}", bodies[contact.between[0]].name, bodies[contact.between[1]].name);
  const auto name = fields.text("name", Need::optional);
  const std::string chosen = name.value_or(standing);
  const auto same = [&](const Contact& other) { return other.name == chosen; };
  if (!usable_name(chosen))
    fields.fault(
        "name",
        fmt::format(
            "the name {} cannot be used; expected letters, digits, _ and - (at most 64: it names columns)",
            in_quotes(chosen)));
  else if (std::any_of(reading.scene.contacts.begin(), reading.scene.contacts.end(), same))
    fields.fault("name", fmt::format("the name {} is taken; expected a name that no other contact has",
                                     in_quotes(chosen)));
  return chosen;
}

void read_contacts(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("contacts")) {
    Contact contact;
    contact.source = fields.source();
    const auto between = read_between(fields, reading);
    if (between) contact.between = *between;
    contact.tied =
        fields.choice<bool>("kind", Need::optional, {{"press", false}, {"tied", true}}).value_or(false);
    if (contact.tied) {
      for (const char* key : {"stiffness", "friction"})
        if (fields.has(key))
          fields.fault(key, fmt::format("\"{}\" in a contact of kind \"tied\", whose surfaces stay together; "
                                        "expected it only without kind = \"tied\"",
                                        key));
      if (between &&
          (reading.scene.bodies[contact.between[0]].rigid || reading.scene.bodies[contact.between[1]].rigid))
        fields.fault("between",
                     "one of two tied bodies is rigid; expected two that deform (a support holds a body to "
                     "the ground)");
    }
    contact.stiffness = fields.number("stiffness", Need::optional, "a factor above 0").value_or(1);
    if (!(contact.stiffness > 0))
      fields.fault(
          "stiffness", fmt::format("\"stiffness\" is {}; expected a factor above 0", contact.stiffness));
    contact.friction = fields.number("friction", Need::optional, "a coefficient of 0 or more").value_or(0);
    if (!(contact.friction >= 0))
      fields.fault("friction",
                   fmt::format("\"friction\" is {}; expected a coefficient of 0 or more", contact.friction));
    if (between)
      contact.name = read_contact_name(fields, contact, reading);
    else
      fields.text("name", Need::optional);
    fields.done();
    if (between) reading.scene.contacts.push_back(contact);
  }
}

}  // namespace

EffectEntry contact_effect() {
  EffectEntry e{{"contact", "contact between bodies, by a penalty"}};
  e.asked_by = "[[contacts]]";
  e.on = [](const Scene& s) {
    return std::any_of(s.contacts.begin(), s.contacts.end(), [](const Contact& c) { return !c.tied; });
  };
  e.off = [](const Scene& s) { return s.contacts.empty(); };
  e.tables = {contact_keys()};
  e.read = read_contacts;
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
