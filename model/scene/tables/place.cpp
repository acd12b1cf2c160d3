// The place that a table names: keys at, point and within.

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "model/input/lookup.hpp"
#include "model/scene/place_extent.hpp"
#include "model/scene/tables/reading.hpp"

namespace femsph::scene_reader {
namespace {

const std::string whole_body = "all";

bool opposite(const std::string& a, const std::string& b) {
  return a.size() == 2 && b.size() == 2 && a[0] == b[0] && a[1] != b[1];
}

// Sides meet if a point lies on all of them. In a mesh this is tested with its vertices (an L-shape has no
// corner where x+ and y+ meet); sides of the bounding box of another shape meet unless they are opposite.
bool meet(const Shape& shape, const std::vector<std::string>& sides) {
  const CellMesh* mesh = shape.cells();
  if (!mesh) {
    for (const auto& a : sides)
      for (const auto& b : sides)
        if (opposite(a, b)) return false;
    return true;
  }
  const double tolerance = point_tolerance(shape);
  return std::any_of(mesh->vertices.begin(), mesh->vertices.end(), [&](const Point& p) {
    return std::all_of(sides.begin(), sides.end(),
                       [&](const std::string& side) { return shape.on_side(side, p, tolerance); });
  });
}

/// The name of a side that `word` refers to: its own name, or that of a physical group given by name or
/// number. Nothing if there is no such side.
std::optional<std::string> side_named(const Shape& shape, const std::string& word) {
  const std::vector<std::string> sides = shape.sides();
  if (const CellMesh* mesh = shape.cells())
    for (const auto& [said, group] : mesh->group_words)
      if (said == word) return mesh->groups[std::size_t(group)];
  const bool known = std::find(sides.begin(), sides.end(), word) != sides.end();
  return known ? std::optional(word) : std::nullopt;
}

/// Why a name or number in the mesh file cannot be used; nothing if it is not in the file.
std::optional<std::string> why_unusable(const Shape& shape, const std::string& word) {
  if (const CellMesh* mesh = shape.cells())
    for (const auto& [said, why] : mesh->unusable_words)
      if (said == word) return why;
  return {};
}

/// The words of "at". The name of a physical group may contain blanks, so that "at" as a whole may be one
/// word; it is refused if both readings are possible.
std::optional<std::vector<std::string>> words_of(const Fields& fields, const std::string& at,
                                                 const Shape& shape) {
  std::vector<std::string> words;
  std::istringstream stream(at);
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.size() < 2 || (!side_named(shape, at) && !why_unusable(shape, at))) return words;
  if (std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return side_named(shape, word) || why_unusable(shape, word) || word == whole_body;
      }))
    return fields.fault("at", fmt::format("{} is the name of a physical group, and several sides; expected "
                                          "the group's number, or another name for it",
                                          in_quotes(at))),
           std::nullopt;
  return std::vector<std::string>{at};
}

std::optional<std::vector<std::string>> read_sides(const Fields& fields, const std::string& at,
                                                   const Shape& shape) {
  std::vector<std::string> sides, known = shape.sides();
  known.push_back(whole_body);
  const auto words = words_of(fields, at, shape);
  if (!words) return {};
  for (const std::string& word : *words) {
    if (const auto why = why_unusable(shape, word)) return fields.fault("at", *why), std::nullopt;
    const std::optional<std::string> side = word == whole_body ? word : side_named(shape, word);
    if (!side)
      return fields.fault(
                 "at", fmt::format("unknown side {}{}", in_quotes(word), expected_names(word, known))),
             std::nullopt;
    if (std::find(sides.begin(), sides.end(), *side) != sides.end())
      return fields.fault(
                 "at", fmt::format("side {} is given twice; expected each side once", in_quotes(word))),
             std::nullopt;
    sides.push_back(*side);
  }
  if (sides.empty())
    return fields.fault("at", fmt::format("\"at\" is empty; expected {}", one_of(known))), std::nullopt;
  if (std::find(sides.begin(), sides.end(), whole_body) != sides.end()) {
    if (sides.size() > 1)
      return fields.fault("at", "\"all\" is given with other sides; expected \"all\" alone or sides alone"),
             std::nullopt;
    return std::vector<std::string>{};
  }
  if (meet(shape, sides)) return sides;
  fields.fault("at", fmt::format("the sides {} do not meet; expected sides with a common {}", in_quotes(at),
                                 shape.dim() == 3 ? "edge or corner" : "corner"));
  return {};
}

}  // namespace

std::vector<Key> place_keys(const std::vector<Key>& more) {
  std::vector<Key> keys = {
      body_key(),
      {"at", "a text: sides of the body's shape, or \"all\"",
       "The place. \"x-\" is one side, \"x+ y+\" the edge or corner where two sides meet, \"all\" the whole "
       "body. A physical group of a mesh has its name or number. A rigid body has no places: the table acts "
       "on its centre.",
       false, "unless \"point\" is given or the body is rigid"},
      {"point", key_holds::vector(dimension::length),
       "Instead of \"at\": the node or particle that is nearest to this point of the undeformed body."},
      {"within", key_holds::corners(dimension::length),
       "Restricts \"at\" to the points inside a box, in the undeformed body: its lower and its upper "
       "corner."}};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

std::optional<Place> read_place(Fields& fields, const Reading& reading) {
  const std::string expected = "at = \"x-\" (sides, or \"all\") or point = [..] (the nearest point)";
  const auto body = read_body_of(fields, reading);
  const bool both = fields.has("at") && fields.has("point");
  const bool by_point = fields.has("point");
  const bool rigid = body && reading.scene.bodies[*body].rigid;
  // A body without a material is rigid, or has a fault.
  const bool needs_at = !by_point && !fields.misspelt({"point"}) && body &&
                        !reading.scene.bodies[*body].material.empty();
  const auto at = fields.text("at", needs_at ? Need::required : Need::optional, expected);
  const auto point = fields.vector("point", Need::optional, dimension::length, reading.dim);
  const auto within = fields.corners("within", Need::optional, dimension::length, reading.dim);
  if (both)
    return fields.fault("point", "both \"at\" and \"point\" are given; expected one of them"), std::nullopt;
  if (rigid) {
    if (point || at.value_or(whole_body) != whole_body)
      return fields.fault(
                 by_point ? "point" : "at",
                 fmt::format("part of body {}, which is rigid; expected \"all\", which stands for its centre",
                             in_quotes(reading.scene.bodies[*body].name))),
             std::nullopt;
    return Place{*body, {}, {}, fields.source("body")};
  }
  if (!body || (!at && !point)) return {};

  Place place;
  place.body = *body;
  place.point = point;
  if (within) place.within = Region{within->first, within->second};
  if (point && fields.has("within"))
    fields.fault("within", "\"within\" with \"point\"; expected it only with \"at\"");
  place.source = fields.source(by_point ? "point" : "at");
  const Shape* shape = reading.scene.bodies[*body].shape.get();
  if (!shape) return place;
  if (point) return require_inside(fields, "point", *point, *body, reading), place;
  const auto sides = read_sides(fields, *at, *shape);
  if (!sides) return {};
  place.sides = *sides;
  return place;
}

}  // namespace femsph::scene_reader
