// What a scene asks to see: probes and sections.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "model/scene/quantities.hpp"
#include "model/scene/reader/scene_reader.hpp"

namespace femsph::scene_reader {
namespace {

std::optional<Quantity> read_observed(Fields& fields) {
  return fields.choice<Quantity>(
      "quantity", Need::required,
      {{"displacement", Quantity::displacement},
       {"velocity", Quantity::velocity},
       {"stress", Quantity::stress},
       {"strain", Quantity::strain},
       {"plastic_strain", Quantity::plastic_strain},
       {"equivalent_stress", Quantity::equivalent_stress},
       {"principal_stress", Quantity::principal_stress}});
}

const std::vector<std::pair<std::string, StressReading>> stress_readings{
    {"recovered", StressReading::recovered}, {"raw", StressReading::raw}};

/// How stress and strain are read there; of a displacement it would say nothing.
StressReading read_reading(Fields& fields, std::optional<Quantity> quantity, const Reading& reading) {
  const auto own = fields.choice<StressReading>("reading", Need::optional, stress_readings);
  if (quantity && !on_material(*quantity) && fields.has("reading"))
    fields.fault(
        "reading",
        "\"reading\" says how stress and strain are read, and this reads neither; expected no such key");
  return own.value_or(reading.stress);
}

bool taken(const std::string& name, const Scene& scene) {
  const auto same = [&](const auto& observer) { return observer.name == name; };
  return std::any_of(scene.probes.begin(), scene.probes.end(), same) ||
         std::any_of(scene.sections.begin(), scene.sections.end(), same) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const Body& body) { return body.rigid && body.name == name; });
}

// Names become columns and files; probes and sections share one namespace.
std::string read_name(Fields& fields, const Scene& scene) {
  const std::string expected = "letters, digits, _ and - (at most 64: it names columns and files)";
  const auto name = fields.text("name", Need::required, expected);
  if (!name) return "";
  if (!usable_name(*name))
    fields.fault("name", fmt::format("the name {} cannot be used; expected {}", in_quotes(*name), expected));
  else if (taken(*name, scene))
    fields.fault(
        "name",
        fmt::format("the name {} is taken; expected a name that no other probe, section or rigid body has",
                    in_quotes(*name)));
  return *name;
}

bool inside(const Point& p, const Body& body) {
  return body.shape->contains(p, point_tolerance(*body.shape));
}

void check_line(const Fields& fields, const Section& section, const Reading& reading) {
  const Body& body = reading.scene.bodies[section.body];
  if (section.from == section.to)
    fields.fault("to", "\"to\" is the same point as \"from\"; expected the other end of a line");
  require_inside(fields, "from", section.from, section.body, reading);
  require_inside(fields, "to", section.to, section.body, reading);
  if (!body.shape || !inside(section.from, body) || !inside(section.to, body)) return;
  // The ends may lie in the body and the line between them not: across a notch, say. A thousand points tell.
  const int steps = std::min(section.count - 1, 1000);
  for (int i = 1; i < steps; ++i) {
    Point p;
    for (int c = 0; c < 3; ++c) p[c] = section.from[c] + (section.to[c] - section.from[c]) * i / steps;
    if (inside(p, body)) continue;
    fields.fault(
        "from", fmt::format("the section leaves body {} between its ends; expected a line inside the body",
                            in_quotes(body.name)));
    return;
  }
}

}  // namespace

bool usable_name(const std::string& name) {
  const auto allowed = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-'); };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), allowed);
}

void read_output(Fields& root, Reading& reading) {
  auto output = root.table(
      "output", Need::optional,
      "a table with reading = \"recovered\" or \"raw\", or fields = \"raw\" or \"both\"");
  if (!output) return;
  reading.stress =
      output->choice<StressReading>("reading", Need::optional, stress_readings).value_or(reading.stress);
  reading.scene.recovered_fields =
      output->choice<bool>("fields", Need::optional, {{"raw", false}, {"both", true}})
          .value_or(reading.scene.recovered_fields);
  output->done();
}

void read_probes(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("probes")) {
    Probe probe;
    probe.name = read_name(fields, reading.scene);
    const auto body = read_body_of(fields, reading);
    const auto quantity = read_observed(fields);
    probe.reading = read_reading(fields, quantity, reading);
    const auto point = fields.vector("point", Need::required, dimension::length, reading.dim);
    fields.done();
    if (body) require_deformable(fields, "probe", *body, reading);
    if (body && point) require_inside(fields, "point", *point, *body, reading);
    probe.body = body.value_or(0);
    probe.quantity = quantity.value_or(probe.quantity);
    probe.point = point.value_or(Point{});
    reading.scene.probes.push_back(probe);
  }
}

void read_sections(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("sections")) {
    Section section;
    section.name = read_name(fields, reading.scene);
    const auto body = read_body_of(fields, reading);
    const auto quantity = read_observed(fields);
    section.reading = read_reading(fields, quantity, reading);
    const auto from = fields.vector("from", Need::required, dimension::length, reading.dim);
    const auto to = fields.vector("to", Need::required, dimension::length, reading.dim);
    section.count = fields.count("points", Need::optional, 2, 1'000'000).value_or(section.count);
    fields.done();
    section.body = body.value_or(0);
    section.quantity = quantity.value_or(section.quantity);
    section.from = from.value_or(Point{});
    section.to = to.value_or(Point{});
    if (body) require_deformable(fields, "section", *body, reading);
    if (body && from && to) check_line(fields, section, reading);
    reading.scene.sections.push_back(section);
  }
}

}  // namespace femsph::scene_reader
