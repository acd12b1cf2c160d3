// Rigid bodies of a scene, and contacts between bodies.

#include <fmt/format.h>

#include <algorithm>

#include "model/scene/reader/scene_reader.hpp"

namespace femsph::scene_reader {
namespace {

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
    const auto found = std::find(names.begin(), names.end(), (*given)[k]);
    if (found == names.end())
      return fields.fault("between", fmt::format("unknown body {}; expected {}{}", in_quotes((*given)[k]),
                                                 one_of(names), did_you_mean((*given)[k], names))),
             std::nullopt;
    between[k] = std::size_t(found - names.begin());
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

}  // namespace

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

void read_rigid_body(Fields& fields, Body& body, const Reading& reading) {
  const bool by_density = fields.has("density") && !fields.has("mass");
  const auto mass = fields.quantity(
      "mass", by_density ? Need::optional : Need::required, dimension::mass, Sign::positive);
  const auto density = fields.quantity("density", Need::optional, dimension::density, Sign::positive);
  if (fields.has("mass") && fields.has("density"))
    fields.fault("density", "both \"mass\" and \"density\" are given; expected one of them");
  const bool plane = reading.dim == 2;
  body.thickness = fields
                       .quantity("thickness", plane && by_density ? Need::required : Need::optional,
                                 dimension::length, Sign::positive)
                       .value_or(1.0);
  if (reading.dim == 3 && fields.has("thickness"))
    fields.fault(
        "thickness",
        "\"thickness\" in a three-dimensional scene; expected it only with plane = \"stress\" or \"strain\"");
  if (body.shape && body.shape->cells())
    fields.fault("shape", "a rigid body made of cells; expected \"box\", \"disc\" or \"sphere\"");
  else if (body.shape && !body.shape->rigid())
    fields.fault(
        "shape", fmt::format("a rigid {}; expected \"box\", \"disc\" or \"sphere\"", body.shape->describe()));
  if (!usable_name(body.name))
    fields.fault(
        "shape",
        fmt::format("the name {} cannot be used; expected letters, digits, _ and - (it names columns)",
                    in_quotes(body.name)));
  fields.done();
  body.mass = mass.value_or(body.shape && density ? *density * body.shape->measure() * body.thickness : 1.0);
}

void read_rigid_support(Fields& fields, const Place& place, Reading& reading) {
  std::vector<std::string> all = reading.dim == 2
                                     ? std::vector<std::string>{"x", "y", "turn"}
                                     : std::vector<std::string>{"x", "y", "z", "turn-x", "turn-y", "turn-z"};
  if (reading.dim == 0) all.push_back("turn");  // it may be a plane scene
  const std::string expected = "a list of components such as [\"x\", \"" + all.back() + "\"]";
  Support support{place, {}, {}};
  const auto components = fields.texts("fix", Need::required, expected);
  for (const std::string& component : components.value_or(std::vector<std::string>{})) {
    const auto found = std::find(all.begin(), all.end(), component);
    if (found == all.end())
      fields.fault("fix", fmt::format("unknown component {}; expected {}{}", in_quotes(component),
                                      one_of(all), did_you_mean(component, all)));
    else if (component.starts_with("turn"))
      support.fixed_turn[component == "turn" ? 2 : component.back() - 'x'] = true;
    else
      support.fixed[component[0] - 'x'] = true;
  }
  if (components && components->empty()) fields.fault("fix", "\"fix\" is empty; expected " + expected);
  fields.done();
  reading.scene.supports.push_back(support);
}

void require_deformable(const Fields& fields, const char* what, std::size_t body, const Reading& reading) {
  const Body& owner = reading.scene.bodies[body];
  if (owner.rigid)
    fields.fault("body", fmt::format("a {0} in body {1}, which is rigid; the histories hold its motion "
                                     "({2}_x, {2}_vx, ..) without one",
                                     what, in_quotes(owner.name), owner.name));
}

}  // namespace femsph::scene_reader
