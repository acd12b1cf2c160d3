// Reads what a scene requests as output: [output], probes and sections.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "model/scene/place_extent.hpp"
#include "model/scene/reader/scene_page.hpp"
#include "model/scene/reader/scene_parts.hpp"

namespace femsph::scene_reader {
namespace {

const std::vector<std::pair<std::string, StressReading>> stress_readings{
    {"recovered", StressReading::recovered}, {"raw", StressReading::raw}};

const std::vector<std::pair<std::string, bool>> field_readings{{"raw", false}, {"both", true}};
/// The keys that probes and sections share, around those of their place.
std::vector<Key> observer_keys(const std::vector<Key>& place) {
  std::vector<Key> keys = {
      {"name", key_holds::text, "The name of its columns and files: at most 64 letters, digits, _ and -.",
       true},
      body_key(),
      {"quantity", key_holds::words(quantity_words()), "What is read; listed under [[probes]].", true}};
  keys.insert(keys.end(), place.begin(), place.end());
  keys.push_back({"reading", key_holds::words(stress_readings),
                  "How stress and strain are read, as in [output], whose value it has unless given."});
  return keys;
}

/// How stress and strain are read there. A displacement or velocity has no such key.
StressReading read_reading(Fields& fields, std::optional<const Quantity*> quantity, const Reading& reading) {
  const auto own = fields.choice<StressReading>("reading", Need::optional, stress_readings);
  if (quantity && !(*quantity)->on_material && fields.has("reading"))
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

// Names become names of columns and files, so probes, sections and rigid bodies must have different ones.
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
  // The line may leave the body between its ends, for example across a notch: test up to a thousand points.
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

KeyTable output_keys() {
  return {"[output]",
          "How stress and strain are read from the results (see model/results/README.md).",
          {{"reading", key_holds::words(stress_readings),
            "For probes and sections without a \"reading\" of their own. \"recovered\": a local fit, by one "
            "rule for all methods, so that methods can be compared. \"raw\": each method's own "
            "interpolation. \"recovered\" unless given."},
           {"fields", key_holds::words(field_readings),
            "\"raw\": the fields for ParaView hold stress and strain at the material points. \"both\": they "
            "hold the recovered values at nodes and particles as well. \"raw\" unless given."}}};
}

KeyTable probe_keys() {
  return {
      "[[probes]]",
      "A quantity that is read at a point, once for every row of the history: columns NAME_x, NAME_xx, ..",
      observer_keys(
          {{"point", key_holds::vector(dimension::length), "The point, in the undeformed body.", true}}),
      "quantity", quantity_entries()};
}

KeyTable section_keys() {
  return {"[[sections]]",
          "A quantity that is read along a straight line inside a body, at the end of the run: the file "
          "section_NAME.csv.",
          observer_keys({{"from", key_holds::vector(dimension::length),
                          "One end of the line, in the undeformed body.", true},
                         {"to", key_holds::vector(dimension::length), "The other end.", true},
                         {"points", key_holds::count,
                          "How many equally spaced points are read, both ends included. 41 unless given."}})};
}

void read_output(Fields& root, Reading& reading) {
  auto output = root.table(
      "output", Need::optional,
      "a table with reading = \"recovered\" or \"raw\", or fields = \"raw\" or \"both\"");
  if (!output) return;
  reading.stress =
      output->choice<StressReading>("reading", Need::optional, stress_readings).value_or(reading.stress);
  reading.scene.recovered_fields =
      output->choice("fields", Need::optional, field_readings).value_or(reading.scene.recovered_fields);
  output->done();
}

void read_probes(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("probes")) {
    Probe probe;
    probe.name = read_name(fields, reading.scene);
    const auto body = read_body_of(fields, reading);
    const auto quantity = fields.choice("quantity", Need::required, quantity_words());
    probe.reading = read_reading(fields, quantity, reading);
    const auto point = fields.vector("point", Need::required, dimension::length, reading.dim);
    fields.done();
    if (body) require_deformable(fields, "probe", *body, reading);
    if (body && point) require_inside(fields, "point", *point, *body, reading);
    probe.body = body.value_or(0);
    probe.quantity = quantity.value_or(quantities().front());
    probe.point = point.value_or(Point{});
    reading.scene.probes.push_back(probe);
  }
}

void read_sections(Fields& root, Reading& reading) {
  for (Fields& fields : root.tables("sections")) {
    Section section;
    section.name = read_name(fields, reading.scene);
    const auto body = read_body_of(fields, reading);
    const auto quantity = fields.choice("quantity", Need::required, quantity_words());
    section.reading = read_reading(fields, quantity, reading);
    const auto from = fields.vector("from", Need::required, dimension::length, reading.dim);
    const auto to = fields.vector("to", Need::required, dimension::length, reading.dim);
    section.count = fields.count("points", Need::optional, 2, 1'000'000).value_or(section.count);
    fields.done();
    section.body = body.value_or(0);
    section.quantity = quantity.value_or(quantities().front());
    section.from = from.value_or(Point{});
    section.to = to.value_or(Point{});
    if (body) require_deformable(fields, "section", *body, reading);
    if (body && from && to) check_line(fields, section, reading);
    reading.scene.sections.push_back(section);
  }
}

}  // namespace femsph::scene_reader
